#pragma once

#include "app/model/sandbox/blueprint_limits.h"
#include "lessons/api/parameter.h"

#include <QString>

namespace app {

/// The name, unit, help text and range of a property.
struct PropertyRange
{
    const char *id;
    QString name;
    QString unit;
    QString help;
    Span span;
    int decimals;
};

/// Returns the property as a parameter that a field can show.
lessons::Parameter parameterOf(const PropertyRange &named, double preset);

// The properties that can be set for the parts of a sandbox scene.
namespace named {

PropertyRange x();
PropertyRange y();
PropertyRange vx();
PropertyRange vy();
PropertyRange mass();
PropertyRange size();
PropertyRange fixed();
PropertyRange stiffness();
PropertyRange length();
PropertyRange share();
PropertyRange angle();
PropertyRange leg();
PropertyRange drop();
PropertyRange gaitSpeed();
PropertyRange gaitStart();
PropertyRange pullsBody();

}

}

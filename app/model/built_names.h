#pragma once

#include "app/model/blueprint_limits.h"
#include "lessons/api/parameter.h"

#include <QString>

namespace app {

/// What a property is called, and what it can be.
struct Named
{
    const char *id;
    QString name;
    QString unit;
    QString help;
    Span span;
    int decimals;
};

/// The same as a parameter, which a field can show.
lessons::Parameter parameterOf(const Named &named, double preset);

// What can be set of the parts of a built scene.
namespace named {

Named x();
Named y();
Named vx();
Named vy();
Named mass();
Named size();
Named fixed();
Named stiffness();
Named length();
Named share();
Named angle();
Named leg();
Named drop();
Named gaitSpeed();
Named gaitStart();
Named pullsBody();

}

}

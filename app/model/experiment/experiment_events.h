#pragma once

#include "lessons/api/step.h"
#include "sim/scene/state.h"

#include <QStringList>

#include <vector>

namespace app {

/// A kind of event in files.
struct EventKind
{
    QString id;
    QStringList fields;   ///< required ones besides "frame" and "event"
    QStringList optional; ///< optional fields
    std::optional<lessons::Interaction>
        does; ///< the interaction that a step must accept for it; empty if every step accepts it
};

/// Returns the kinds of events that `step` knows, in the order in which messages list them.
std::vector<EventKind> eventKindsOf(const lessons::Step &step);

/// A control key and its name in files.
struct KeyName
{
    QString name;
    bool sim::Keys::*key;
};
const std::vector<KeyName> &keyNames();

}

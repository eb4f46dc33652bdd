#pragma once

#include "lessons/api/step.h"
#include "sim/scene/state.h"

#include <QStringList>

#include <vector>

namespace app {

/// A kind of event as files write it.
struct EventKind
{
    QString id;
    QStringList fields;   ///< required ones besides "frame" and "event"
    QStringList optional; ///< others that it may have
    std::optional<lessons::Interaction>
        does; ///< the interaction that a step must accept for it; empty: every step accepts it
};

/// The kinds that `step` knows, in the order in which messages list them.
std::vector<EventKind> eventKindsOf(const lessons::Step &step);

/// The keys that steer, as files call them.
struct KeyName
{
    QString name;
    bool sim::Keys::*key;
};
const std::vector<KeyName> &keyNames();

}

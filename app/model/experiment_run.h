#pragma once

#include "app/model/json_fields.h"
#include "lessons/api/step.h"
#include "sim/run/script/script.h"

#include <cstdint>

namespace app {

/// A run as a file describes it.
struct ReadRun
{
    std::int64_t frames = 300; ///< where the file does not say how many are computed
    sim::Script script;        ///< complete: presets filled in
};

/// The fields that describe a run of a step: method and step, what differs from the step's own, and the input.
const QStringList &runFields();

/// Reads those from `fields`, which may have others. @throws Refusal: wrong types, unknown names, values out of range
ReadRun readRun(const QString &file, const JsonFields &fields, const lessons::Step &step);

/// Reads a run that is `base`, a run of `step`, up to frame `fork`: "frames" and "input" from there on are all that it has.
/// @throws Refusal: as readRun, or an event before `fork`
ReadRun readRunFrom(const QString &file, const JsonFields &fields, const lessons::Step &step,
                    const sim::Script &base, std::int64_t fork);

}

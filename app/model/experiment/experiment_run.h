#pragma once

#include "app/model/experiment/json_fields.h"
#include "lessons/api/step.h"
#include "sim/run/script/script.h"

#include <cstdint>

namespace app {

/// A run read from a file.
struct ReadRun
{
    std::int64_t frames = 300; ///< the default if the file gives no number
    sim::Script script;        ///< complete: presets filled in
};

/// Returns the names of the fields of a run: method and step, differences from the lesson step's own run, and the
/// input.
const QStringList &runFields();

/// Reads the fields of a run from `fields`, which may have others.
/// @throws UserError: wrong types, unknown names, values out of range
ReadRun readRun(const QString &file, const JsonFields &fields, const lessons::Step &step);

/// Reads a run that equals `base`, a run of `step`, before frame `fork`. From there on, `fields` gives only
/// "frames" and "input".
/// @throws UserError: as readRun(), or an event before `fork`
ReadRun readRunFrom(const QString &file, const JsonFields &fields, const lessons::Step &step,
                    const sim::Script &base, std::int64_t fork);

}

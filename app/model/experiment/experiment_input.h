#pragma once

#include "app/model/experiment/json_document.h"
#include "lessons/api/step.h"
#include "sim/run/script/script.h"

#include <vector>

namespace app {

/// An event of a file with its line.
struct ReadEvent
{
    sim::Event event;
    int line = 0;
};

/// Returns the events of a file's "input", sorted by frame. Checks each event separately.
std::vector<ReadEvent> readInput(const QString &file, const JsonValue &input, const lessons::Step &step);

}

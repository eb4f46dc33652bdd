#pragma once

#include "app/listing/values.h"

#include <vector>

namespace listing {

/// Completes the loops of traced lines. Before, LoopTurn::turn is 1 in the body of a loop and 0 in its head.
/// Afterwards it counts the turns, and LoopTurn::turns is how many there are. A loop whose head is about to run has
/// no entry.
void countLoopTurns(std::vector<TracedLine> &lines);

}

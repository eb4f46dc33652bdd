#pragma once

#include "sim/effects/pairs/links.h"

#include <vector>

/// Directed links between points. Two points that pull each other have a link each way.
namespace scenes {

/// Returns the links of a creature of creature(): from each foot to the body, then from the body to each foot.
std::vector<sim::Link> legs(int feet);
/// Returns the links of the creatures of crowdByParts(), foot by foot: from each foot to its body, and back.
std::vector<sim::Link> legsByParts(int creatures, int feet);
/// Returns the links of each point to the next one, and back.
std::vector<sim::Link> chainLinks(int points);
/// Returns the links of each point of a square of `side` rows to its right and lower neighbours, and back. Points are
/// numbered row by row.
std::vector<sim::Link> gridLinks(int side);

}

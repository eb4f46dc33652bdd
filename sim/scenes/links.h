#pragma once

#include "sim/effects/pairs/links.h"

#include <vector>

/// Directed links between points. Two points that pull each other have two links, one in each direction.
namespace scenes {

/// Returns the links of a creature(): from each foot to the body, then from the body to each foot.
std::vector<sim::Link> legs(int feet);
/// Returns the links of the creatures of crowdByParts(): for each foot, to its body and back.
std::vector<sim::Link> legsByParts(int creatures, int feet);
/// Returns the links of a chain: for each point, to the next point and back.
std::vector<sim::Link> chainLinks(int points);
/// Returns the links of a square of `side` rows of `side` points, which are numbered row by row: for each
/// point, to its right and its lower neighbour and back.
std::vector<sim::Link> gridLinks(int side);

}

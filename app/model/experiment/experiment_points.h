#pragma once

#include "app/model/experiment/json_document.h"
#include "sim/scene/values.h"

#include <vector>

namespace app {

constexpr int mostPoints = 1000; ///< in a file, in place of a step's own
constexpr int mostSticks = 10'000;

/// Returns how many points "bodies" gives in place of a step's own: p0, p1... without a gap.
/// @throws UserError: another name, a gap, or more than mostPoints
int countPoints(const QString &file, const JsonValue &bodies);

/// Returns the sticks of "links", between points p0 to p`points`-1.
/// @throws UserError: wrong types, an unknown end, a length below 0, a share outside 0 to 1
std::vector<sim::Stick> readSticks(const QString &file, const JsonValue &links, int points);

}

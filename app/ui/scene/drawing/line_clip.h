#pragma once

#include <QRectF>

#include <optional>
#include <utility>

namespace app {

/// Returns where a line enters and leaves `box`, as fractions of its length; empty if it is outside (Liang and Barsky, "A
/// New Concept and Method for Line Clipping", ACM TOG 3 (1), 1984).
std::optional<std::pair<double, double>> partWithin(const QRectF &box, QPointF from, QPointF to);

}

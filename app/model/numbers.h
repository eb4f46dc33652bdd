#pragma once

#include "sim/base/vec2.h"

#include <QString>

namespace app {

// Numbers on the screen: with a minus sign and the decimal sign of QLocale(), and never "minus nought".

/// With exactly `decimals` digits after the point: for what changes while it is read. From 1e7 on as roughNumber().
QString fixedNumber(double value, int decimals);

/// With `decimals` digits after the point, or as many as the number really has: for what somebody set.
QString writtenNumber(double value, int decimals);

/// With two digits, for what was measured: "3.7", "0.084", "2.1·10⁻¹¹".
QString roughNumber(double value);
/// How long `a` is, also where its square is past all numbers; the largest number where even the length is.
double shownLength(sim::Vec2 a);
/// A power of ten: "10⁻⁸".
QString powerOfTen(int exponent);

}

#pragma once

#include "sim/base/vec2.h"

#include <QString>

namespace app {

// Numbers on the screen: with a minus sign, the decimal sign of QLocale(), and never "-0".

/// Returns `value` with exactly `decimals` digits after the point, for values that change while they are read. From
/// 1e7 on, same as roughNumber().
QString fixedNumber(double value, int decimals);

/// Returns `value` with `decimals` digits after the point, or with all its digits if it has more. Use it for values
/// that the user set.
QString writtenNumber(double value, int decimals);

/// Returns a measured value with two significant digits: "3.7", "0.084", "2.1·10⁻¹¹".
QString roughNumber(double value);
/// Returns the length of `a`, even if its square overflows. Returns the largest finite number if the length
/// overflows, too.
double shownLength(sim::Vec2 a);
/// Returns a power of ten as text: "10⁻⁸".
QString powerOfTen(int exponent);

/// Returns `markdown` with spaces that do not break between a number and its unit, as in "100 px", and in a product of
/// numbers, as in "540 × 400".
QString withoutBreaksInNumbers(QString markdown);

}

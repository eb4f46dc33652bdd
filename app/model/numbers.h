#pragma once

#include <QString>

namespace app {

// Numbers on the screen: with a minus sign, and never "minus nought".

/// With exactly `decimals` digits after the point: for what changes while it is read.
QString fixedNumber(double value, int decimals);

/// With `decimals` digits after the point, or as many as the number really has: for what somebody set.
QString writtenNumber(double value, int decimals);

}

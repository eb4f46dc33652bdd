#pragma once

#include "app/model/text/numbers.h"

#include "app/ui/theme/custom_plot.h"

#include <cmath>

namespace app {

/// Labels of a linear axis: powers of ten where numbers are large or small ("1.5·10⁶"), and without rounding errors
/// such as 0.30000000000000004.
class NumberTicker : public QCPAxisTicker
{
public:
    /// Makes about `ticks` labels.
    explicit NumberTicker(int ticks) { setTickCount(ticks); }

protected:
    QString getTickLabel(double tick, const QLocale &, QChar, int) override
    {
        constexpr double shortFrom = 1e5, shortBelow = 1e-3;
        const double size = std::abs(tick);
        if (size >= shortFrom || (size > 0.0 && size < shortBelow))
            return roughNumber(tick);
        return writtenNumber(QString::number(tick, 'g', 9).toDouble(), 0);
    }
};

}

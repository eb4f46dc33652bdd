#pragma once

#include "app/model/numbers.h"

#include <qcustomplot.h>

#include <cmath>

namespace app {

/// Ticks with short labels, where numbers are large, too: "1.5·10⁶".
class ShortTicker : public QCPAxisTicker
{
protected:
    QString getTickLabel(double tick, const QLocale &, QChar, int) override
    {
        const double size = std::abs(tick);
        if (size >= 1e5 || (size > 0.0 && size < 1e-3))
            return roughNumber(tick);
        return writtenNumber(tick, 0);
    }
};

}

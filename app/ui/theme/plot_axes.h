#pragma once

#include "app/ui/theme/theme.h"

#include "app/ui/theme/custom_plot.h"

namespace app {

/// Axis lines, ticks, labels and grid as all plots have them: small, with ticks outside, and without a zero line.
inline void dressAxis(QCPAxis &axis, const Theme &theme)
{
    const Tokens &t = theme.tokens();
    axis.setBasePen(QPen(t.line2, 1.0));
    axis.setTickPen(QPen(t.line2, 1.0));
    axis.setTickLength(0, 3);
    axis.setSubTicks(false);
    axis.setTickLabelColor(t.ink3);
    axis.setTickLabelFont(theme.ui(12));
    axis.setTickLabelPadding(4);
    axis.grid()->setSubGridVisible(false);
    // In high contrast a line is as white as a curve; the grid lies behind them.
    axis.grid()->setPen(QPen(theme.scheme() == Scheme::highContrast ? t.dots : t.line, 1.0));
    axis.grid()->setZeroLinePen(Qt::NoPen);
}

}

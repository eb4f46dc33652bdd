#pragma once

#include "app/ui/theme/custom_plot.h"

namespace app {

/// The dashes along a line through `points`, `length` px long and as far apart, as far as they are within `seen`. Where a
/// point is none (NaN) the line has a gap.
QVector<QLineF> dashesAlong(const QVector<QPointF> &points, double length, const QRectF &seen);

/// Graphs and curves whose lines are dashed dash by dash, each of them a plain line: Qt draws those many times as fast as
/// the outline of a dashed line with hundreds of corners. The pen says how dashes look where plots are saved.
class DashedGraph : public QCPGraph
{
public:
    using QCPGraph::QCPGraph;

protected:
    void drawLinePlot(QCPPainter *painter, const QVector<QPointF> &lines) const override;
};

class DashedCurve : public QCPCurve
{
public:
    using QCPCurve::QCPCurve;

protected:
    void drawCurveLine(QCPPainter *painter, const QVector<QPointF> &lines) const override;
};

/// A pen for those: dashes and gaps of this length (px).
QPen dashedPen(const QColor &ink, double width, double length);

}

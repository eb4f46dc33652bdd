#pragma once

#include "app/ui/theme/custom_plot.h"

namespace app {

/// Returns the dashes within `seen` of a line through `points`: they and their gaps are `length` px long. The line has
/// a gap at a point that is not finite.
QVector<QLineF> dashesAlong(const QVector<QPointF> &points, double length, const QRectF &seen);

/// A graph that draws each dash as a line. Qt draws these many times as fast as the outline of a dashed line with
/// hundreds of corners. Vector files have the dashes of the pen.
class DashedGraph : public QCPGraph
{
public:
    using QCPGraph::QCPGraph;

protected:
    void drawLinePlot(QCPPainter *painter, const QVector<QPointF> &lines) const override;
};

/// A curve with dashes like those of DashedGraph.
class DashedCurve : public QCPCurve
{
public:
    using QCPCurve::QCPCurve;

protected:
    void drawCurveLine(QCPPainter *painter, const QVector<QPointF> &lines) const override;
};

/// Returns a pen for both, with dashes and gaps of `length` px.
QPen dashedPen(const QColor &ink, double width, double length);

}

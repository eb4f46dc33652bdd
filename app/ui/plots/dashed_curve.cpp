#include "app/ui/plots/dashed_curve.h"

#include "app/ui/plots/plot.h"
#include "app/ui/scene/drawing/line_clip.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

/// Draws dashes in place of the line of `painter`'s pen. Returns whether that is possible.
bool drawDashes(QCPPainter &painter, const QVector<QPointF> &lines, const QRectF &seen)
{
    const QPen pen = painter.pen();
    if (painter.modes().testFlag(QCPPainter::pmVectorized) || pen.dashPattern().isEmpty())
        return false;
    painter.setPen(QPen(pen.color(), pen.widthF(), Qt::SolidLine, Qt::FlatCap));
    painter.drawLines(dashesAlong(lines, pen.dashPattern().front() * pen.widthF(), seen));
    painter.setPen(pen);
    return true;
}

}

QVector<QLineF> dashesAlong(const QVector<QPointF> &points, double length, const QRectF &seen)
{
    QVector<QLineF> dashes;
    double before = 0.0; // along the line, from the beginning of a dash on
    for (qsizetype i = 1; i < points.size(); ++i) {
        const QPointF from = points[i - 1], to = points[i];
        if (!isFinite(from) || !isFinite(to)) {
            before = 0.0;
            continue;
        }
        const double whole = std::hypot(to.x() - from.x(), to.y() - from.y());
        const auto part = partWithin(seen, from, to);
        const double end = part ? part->second * whole : 0.0;
        for (double at = part ? part->first * whole : 0.0; at < end;) {
            const double inPair = std::fmod(before + at, 2.0 * length);
            const double next = std::min(end, at + (inPair < length ? length : 2.0 * length) - inPair);
            if (inPair < length)
                dashes.append({from + (to - from) * (at / whole), from + (to - from) * (next / whole)});
            if (!(next > at)) // so far away that a dash is shorter than a rounding error
                break;
            at = next;
        }
        before = std::fmod(before + whole, 2.0 * length);
    }
    return dashes;
}

void DashedGraph::drawLinePlot(QCPPainter *painter, const QVector<QPointF> &lines) const
{
    applyDefaultAntialiasingHint(painter);
    if (!drawDashes(*painter, lines, clipRect()))
        QCPGraph::drawLinePlot(painter, lines);
}

void DashedCurve::drawCurveLine(QCPPainter *painter, const QVector<QPointF> &lines) const
{
    applyDefaultAntialiasingHint(painter);
    if (!drawDashes(*painter, lines, clipRect()))
        QCPCurve::drawCurveLine(painter, lines);
}

QPen dashedPen(const QColor &ink, double width, double length)
{
    QPen pen(ink, width, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({length / width, length / width});
    return pen;
}

}

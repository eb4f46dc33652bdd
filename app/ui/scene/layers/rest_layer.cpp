// A layer of the rest lengths of springs and sticks.

#include "app/model/picture/rest_marks.h"
#include "app/ui/scene/layers/layers.h"
#include "sim/run/script/composed_interval.h"

#include <algorithm>

namespace app {

namespace {

constexpr double beyondDisc = 4.0; ///< screen px by which a bar extends beyond the disc at its end
constexpr double leastHalf = 6.0;  ///< screen px, of a bar
constexpr double barWidth = 2.0;
constexpr double rim = 2.0; ///< screen px of background around a bar, for contrast on any disc

/// Returns the point where the disc of `point` ends on the way to a place, or the place itself if it is
/// inside the disc.
QPointF edgeTowards(const Canvas &canvas, int point, QPointF place)
{
    const QLineF way(canvas.camera.at(canvas.shown.state().positionOf(point)), place);
    const double disc = canvas.discRadius(point);
    return way.length() > disc ? way.pointAt(disc / way.length()) : place;
}

/// The shapes drawn for links of one kind.
struct Strokes
{
    QVector<QLineF> shadows; ///< from one end of a link to the rest position of its other end
    QVector<QLineF> bars;    ///< across a link, at its rest length
    QPainterPath rings;      ///< around a rest position that is not on the link
};

void addMark(Strokes &strokes, const Canvas &canvas, const RestMark &mark)
{
    const QPointF place = canvas.camera.at(mark.rest.position);
    const QPointF from = canvas.camera.at(canvas.shown.state().positionOf(mark.rest.anchor));
    const QLineF visible = canvas.cut(edgeTowards(canvas, mark.rest.anchor, place), place);
    if (!visible.isNull())
        strokes.shadows << visible;
    const double half = std::max(leastHalf, canvas.discRadius(mark.rest.mover) + beyondDisc);
    if (!canvas.reaches(place, half))
        return;
    if (!mark.rest.isDistance) {
        strokes.rings.addEllipse(place, half, half);
        return;
    }
    const QLineF link(from, place);
    if (link.length() <= 0.0)
        return;
    const QPointF across = half / link.length() * QPointF(link.dy(), -link.dx());
    strokes.bars << QLineF(place - across, place + across);
}

void drawStrokes(QPainter &painter, const Strokes &strokes, const QColor &color, const QColor &behind)
{
    painter.setBrush(Qt::NoBrush);
    QPen pen(behind, barWidth + rim, Qt::SolidLine, Qt::FlatCap);
    painter.setPen(pen);
    painter.drawLines(strokes.bars);
    painter.setPen(dashed(color, 1.2, {4.0, 3.0}));
    painter.drawLines(strokes.shadows);
    painter.setPen(dashed(color, 1.5, {4.0, 3.0}));
    painter.drawPath(strokes.rings);
    pen.setColor(color);
    pen.setWidthF(barWidth);
    painter.setPen(pen);
    painter.drawLines(strokes.bars);
}

}

void drawRests(const Canvas &canvas)
{
    const SceneContent &shown = canvas.shown;
    if (!shown.extras.rests)
        return;
    Strokes springs, sticks;
    for (const RestMark &mark : restMarks(shown.picture.interval->scene, shown.state(), shown.view())) {
        if (shown.isCrowd() && mark.rest.mover != shown.selected && mark.rest.anchor != shown.selected)
            continue;
        addMark(mark.kind == sim::EffectKind::stick ? sticks : springs, canvas, mark);
    }
    drawStrokes(canvas.painter, springs, canvas.tokens().spring, canvas.tokens().scene);
    drawStrokes(canvas.painter, sticks, canvas.tokens().stick, canvas.tokens().scene);
}

}

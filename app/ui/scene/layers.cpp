#include "app/ui/scene/layers.h"

#include "app/ui/scene/arrows.h"

#include <QStyleOptionGraphicsItem>

#include <cmath>

namespace app {

namespace {

constexpr double hatchStep = 12.0; ///< px of the screen

double firstHatch(double from, double anchor)
{
    return from - std::fmod(from - anchor, hatchStep) - 2.0 * hatchStep;
}

void hatchFloor(QList<QLineF> &lines, double left, double right, double anchor, double y)
{
    for (double x = firstHatch(left, anchor); x < right; x += hatchStep)
        lines << QLineF(x, y + 10.0, x + 8.0, y + 1.0);
}

/// `solid`: on which side of the wall it is solid, −1 or 1.
void hatchWall(QList<QLineF> &lines, double top, double bottom, double anchor, double x, double solid)
{
    for (double y = firstHatch(top, anchor); y < bottom - 8.0; y += hatchStep)
        lines << QLineF(x + solid * 10.0, y - solid * 4.0, x + solid, y + solid * 4.0);
}

}

Layer::Layer(const Shown &shown, const Theme &theme, int height) : m_shown(shown), m_theme(theme)
{
    setFlag(ItemUsesExtendedStyleOption);
    setAcceptedMouseButtons(Qt::NoButton);
    setZValue(height);
}

QRectF Layer::boundingRect() const
{
    return {-worldReach, -worldReach, 2.0 * worldReach, 2.0 * worldReach};
}

void Layer::paint(QPainter *painter, const QStyleOptionGraphicsItem *option, QWidget *)
{
    if (m_shown.points() == 0)
        return;
    const QTransform toView = painter->worldTransform();
    painter->save();
    painter->setWorldTransform({});
    painter->setBrush(Qt::NoBrush);
    draw({*painter, m_shown, m_theme, Camera(toView), toView.mapRect(option->exposedRect)});
    painter->restore();
}

void RoomLayer::draw(const Canvas &canvas) const
{
    const std::optional<sim::Room> &room = canvas.shown.picture.look.room;
    if (!room)
        return;
    QPainter &p = canvas.painter;
    const QRectF area = canvas.area;
    const QPointF low = canvas.camera.at({room->left, room->floor});
    const double left = std::round(low.x());
    const double right = std::round(canvas.camera.at({room->right, room->floor}).x());
    const double floor = std::round(low.y());
    const QColor ground = canvas.tokens().win;
    p.fillRect(QRectF(QPointF(area.left(), floor), area.bottomRight()).intersected(area), ground);
    p.fillRect(QRectF(area.topLeft(), QPointF(left, area.bottom())).intersected(area), ground);
    p.fillRect(QRectF(QPointF(right, area.top()), area.bottomRight()).intersected(area), ground);

    QList<QLineF> hatch;
    if (floor < area.bottom() + 10.0)
        hatchFloor(hatch, std::max(left, area.left()), std::min(right, area.right()), left, floor);
    const double bottom = std::min(floor, area.bottom() + 10.0);
    if (left > area.left() - 10.0)
        hatchWall(hatch, area.top(), bottom, floor, left, -1.0);
    if (right < area.right() + 10.0)
        hatchWall(hatch, area.top(), bottom, floor, right, 1.0);
    p.setPen(QPen(canvas.tokens().line2, 1.3, Qt::SolidLine, Qt::FlatCap));
    p.drawLines(hatch);

    p.setPen(QPen(canvas.tokens().contact, 2.0, Qt::SolidLine, Qt::FlatCap, Qt::MiterJoin));
    const double top = area.top() - 4.0;
    p.drawPolyline(
        QPolygonF{QPointF(left, top), QPointF(left, floor), QPointF(right, floor), QPointF(right, top)});
}

void TrailLayer::draw(const Canvas &canvas) const
{
    const Shown &shown = canvas.shown;
    const std::deque<Trail::Mark> &marks = shown.trail.marks();
    if (!shown.extras.trails || marks.size() < 2 || marks.back().position.rows() != shown.points())
        return;
    bool anyBody = false;
    for (int i = 0; i < shown.points(); ++i)
        anyBody |= shown.isBody(i);
    for (std::size_t k = 1; k < marks.size(); ++k) {
        const double age = static_cast<double>(marks.back().frame - marks[k].frame) / Trail::length;
        canvas.painter.setPen(solid(faded(canvas.tokens().body, 0.05 + 0.3 * (1.0 - age)), 2.0));
        for (int i = 0; i < shown.points(); ++i) {
            const auto place = [&](const Trail::Mark &mark) {
                return canvas.camera.at({mark.position(i, 0), mark.position(i, 1)});
            };
            if (shown.isBody(i) || !anyBody)
                canvas.painter.drawLine(canvas.cut(place(marks[k - 1]), place(marks[k])));
        }
    }
}

void ArrowLayer::draw(const Canvas &canvas) const
{
    for (const Arrow &arrow : velocityArrows(canvas.shown, canvas.camera, canvas.theme))
        drawArrow(canvas.painter, arrow, canvas.tokens().scene);
    for (const Arrow &arrow : pullArrows(canvas.shown, canvas.camera, canvas.theme))
        drawArrow(canvas.painter, arrow, canvas.tokens().scene);
}

}

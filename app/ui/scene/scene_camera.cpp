// Where the scene view looks: zoom, pan, and what a step shows first.

#include "app/ui/scene/layers.h"
#include "app/ui/scene/scene_view.h"

#include <QResizeEvent>
#include <QScrollBar>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

constexpr double leastZoom = 0.05;
constexpr double mostZoom = 16.0;
constexpr double zoomStep = 1.25;
constexpr double border = 24.0;        ///< px of the screen round the stage
constexpr double pleasant = 2.6;       ///< the zoom of a creature that is small enough for it
constexpr double creatureReach = 75.0; ///< px round a creature's middle that it needs, at least
constexpr double creatureRoom = 12.0;  ///< px that it needs beside its outermost body
constexpr double solidSide = 12.0;     ///< px beyond the walls that a room shows
constexpr double groundBorder = 52.0;  ///< px of the screen below a floor: scale and legends stand there
constexpr double largestRoom = 1.5;    ///< the most that a room is enlarged at first

QRectF around(QPointF centre, double half)
{
    return {centre.x() - half, centre.y() - half, 2.0 * half, 2.0 * half};
}

/// Floor, walls and what is between them.
QRectF roomArea(const sim::Room &room, QRectF stage)
{
    return QRectF(QPointF(room.left - solidSide, std::min(stage.top(), room.floor - 1.0)),
                  QPointF(room.right + solidSide, room.floor));
}

/// Bodies and places that a step is about, with room to move.
QRectF creatureArea(const Picture &picture)
{
    QRectF area;
    for (int i = 0; i < picture.state.points(); ++i) {
        const sim::Vec2 at = picture.state.at(i);
        const double half = picture.look.bodies[static_cast<std::size_t>(i)].radius + creatureRoom;
        area = area.united(around({at.x, at.y}, half));
    }
    for (const lessons::Guide &guide : picture.guides)
        area = area.united(around({guide.a.x, guide.a.y}, std::max(guide.size, creatureRoom)));
    return area.united(around(area.center(), creatureReach));
}

}

double SceneView::zoom() const
{
    return 100.0 * transform().m11();
}

void SceneView::showHome()
{
    const Picture &picture = m_shown.picture;
    const QRectF stage = picture.look.stage;
    if (picture.look.room) {
        m_home = roomArea(*picture.look.room, stage);
    } else {
        m_home = creatureArea(picture);
        const bool isSmall = m_home.width() < stage.width() && m_home.height() < stage.height();
        m_home = isSmall ? m_home : stage.united(m_home);
    }
    m_atHome = true;
    showArea(m_home, picture.look.room ? largestRoom : pleasant);
}

void SceneView::showArea(QRectF area, double most)
{
    const bool hasGround = m_shown.picture.look.room.has_value();
    const double below = hasGround ? groundBorder : border;
    const double across = (viewRect().width() - 2.0 * border) / area.width();
    const double down = (viewRect().height() - border - below) / area.height();
    const double zoom = std::clamp(std::min({across, down, most}), leastZoom, mostZoom);
    setTransform(QTransform::fromScale(zoom, zoom));
    centerOn(area.center() + QPointF(0.0, (below - border) / 2.0 / zoom));
    emit zoomChanged(this->zoom());
}

void SceneView::fit()
{
    QRectF area = m_shown.picture.look.stage;
    if (m_shown.picture.look.room)
        area = area.united(roomArea(*m_shown.picture.look.room, area));
    m_atHome = false;
    showArea(area, mostZoom);
}

void SceneView::zoomIn()
{
    setZoom(transform().m11() * zoomStep, viewRect().center());
}

void SceneView::zoomOut()
{
    setZoom(transform().m11() / zoomStep, viewRect().center());
}

void SceneView::zoomTo100()
{
    setZoom(1.0, viewRect().center());
}

void SceneView::setZoom(double zoom, QPointF keep)
{
    const QPointF place = viewportTransform().inverted().map(keep);
    zoom = std::clamp(zoom, leastZoom, mostZoom);
    setTransform(QTransform::fromScale(zoom, zoom));
    pan(keep - viewportTransform().map(place));
    emit zoomChanged(this->zoom());
}

void SceneView::pan(QPointF by)
{
    m_atHome = false;
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() - static_cast<int>(std::lround(by.x())));
    verticalScrollBar()->setValue(verticalScrollBar()->value() - static_cast<int>(std::lround(by.y())));
}

void SceneView::bringBack(const QString &body)
{
    const int point = m_shown.picture.segment->scene.find(body.toStdString());
    if (point < 0)
        return;
    const sim::Vec2 at = m_shown.state().at(point);
    m_atHome = false;
    centerOn(std::clamp(at.x, -worldReach, worldReach), std::clamp(at.y, -worldReach, worldReach));
    viewport()->update();
}

void SceneView::resizeEvent(QResizeEvent *event)
{
    QGraphicsView::resizeEvent(event);
    if (m_atHome && !m_home.isEmpty())
        showArea(m_home, m_shown.picture.look.room ? largestRoom : pleasant);
}

}

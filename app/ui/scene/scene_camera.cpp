// Where the scene view looks: zoom, pan, and what a step shows first.

#include "app/ui/scene/layers.h"
#include "app/ui/scene/scene_view.h"

#include <QResizeEvent>
#include <QScrollBar>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace app {

namespace {

constexpr double leastZoom = 0.01;
constexpr double mostZoom = 16.0;
constexpr double zoomStep = 1.25;
constexpr double border = 24.0;        ///< px of the screen round the stage
constexpr double pleasant = 2.6;       ///< the zoom of a creature that is small enough for it
constexpr double creatureReach = 75.0; ///< px round a creature's middle that it needs, at least
constexpr double creatureRoom = 12.0;  ///< px that it needs beside its outermost body
constexpr double solidSide = 12.0;     ///< px beyond the walls that a room shows
constexpr double groundBorder = 52.0;  ///< px of the screen below a floor: scale and legends stand there
constexpr double endlessBorder = 68.0; ///< likewise, of an endless ground: distances stand there too
constexpr double endlessShare = 0.12;  ///< of the view's height, if that is more
constexpr double largestRoom = 1.5;    ///< the most that a room or a tree is enlarged at first
constexpr double largestWalk = 1.8;    ///< the most that who walks is enlarged at first
constexpr double followEdge = 0.2; ///< of the view's width, at either side, that what walks is kept out of

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
        const double half = picture.look->bodies[static_cast<std::size_t>(i)].radius + creatureRoom;
        area = area.united(around({at.x, at.y}, half));
    }
    for (const lessons::Guide &guide : picture.guides)
        area = area.united(around({guide.a.x, guide.a.y}, std::max(guide.size, creatureRoom)));
    return area.united(around(area.center(), creatureReach));
}

/// All branches of a tree, as they are now.
QRectF treeArea(const lessons::TreeLook &tree, const sim::State &state)
{
    QRectF area;
    const int count = std::min(static_cast<int>(tree.length.size()), static_cast<int>(state.angle.rows()));
    for (int i = 0; i < count; ++i) {
        const double angle = state.angle[i] * std::numbers::pi / 180.0;
        const double length = tree.length[static_cast<std::size_t>(i)];
        const QPointF from(state.position(i, 0), state.position(i, 1));
        const QPointF to = from + length * QPointF(std::cos(angle), std::sin(angle));
        area = area.united(QRectF(from, to).normalized().adjusted(-2, -2, 2, 2));
    }
    return area;
}

/// Whether there is ground without walls: it is endless.
bool standsOnGround(const lessons::Look &look)
{
    return !look.room && (look.ground || look.sky != lessons::Look::Sky::paper);
}

/// px of the screen that stay free below what is shown, in a view of this height.
double belowArea(const lessons::Look &look, double height)
{
    if (standsOnGround(look))
        return std::max(endlessBorder, endlessShare * height);
    return look.room ? groundBorder : border;
}

/// The stage of a figure and that of its companion.
QRectF bothStages(const lessons::Look &look, const Shown &beside)
{
    return look.stage.united(look.stage.translated(beside.shift.x, beside.shift.y));
}

/// What a step shows first.
QRectF homeOf(const Picture &picture, const Shown &beside)
{
    const lessons::Look &look = *picture.look;
    if (!beside.name.isEmpty())
        return bothStages(look, beside);
    if (look.room)
        return roomArea(*look.room, look.stage);
    if (look.tree || look.sky != lessons::Look::Sky::paper)
        return look.tree ? look.stage.united(treeArea(*look.tree, picture.state)) : look.stage;
    QRectF area = creatureArea(picture);
    if (look.ground)
        area.setBottom(*look.ground);
    const bool isSmall = area.width() < look.stage.width() && area.height() < look.stage.height();
    return isSmall ? area : look.stage.united(area);
}

/// Whether walls and floor are where they were in what was shown before.
bool hasSameRoom(const lessons::Look &look, QRectF home, QRectF before)
{
    return !before.isEmpty() &&
           (!look.room || (home.left() == before.left() && home.right() == before.right() &&
                           home.bottom() == before.bottom()));
}

/// The most that what a step shows first is enlarged.
double mostAtHome(const lessons::Look &look)
{
    if (look.ground && !look.room)
        return largestWalk;
    return look.room || look.tree || look.sky != lessons::Look::Sky::paper ? largestRoom : pleasant;
}

}

double SceneView::zoom() const
{
    return 100.0 * transform().m11();
}

void SceneView::showHome()
{
    const QRectF before = m_atHome ? m_home : QRectF();
    m_home = homeOf(m_shown.picture, m_beside);
    m_stage = m_shown.look().stage;
    m_atHome = true;
    // Whoever puts one part after the other goes on where the last one was: the picture moves only for what is not seen.
    const QRectF seen = viewportTransform().inverted().mapRect(viewRect());
    const bool stays = m_session.isWorkshop() && hasSameRoom(m_shown.look(), m_home, before) &&
                       seen.contains(creatureArea(m_shown.picture));
    if (!stays)
        showArea(m_home, mostAtHome(m_shown.look()));
    follow();
}

void SceneView::showArea(QRectF area, double most)
{
    const double below = belowArea(m_shown.look(), viewRect().height());
    const double across = (viewRect().width() - 2.0 * border) / area.width();
    const double down = (viewRect().height() - border - below) / area.height();
    const double zoom = std::clamp(std::min({across, down, most}), leastZoom, mostZoom);
    setTransform(QTransform::fromScale(zoom, zoom));
    QPointF middle = area.center() + QPointF(0.0, (below - border) / 2.0 / zoom);
    if (standsOnGround(m_shown.look())) // the ground lies low, however much room there is above
        middle.setY(area.bottom() + (below - viewRect().height() / 2.0) / zoom);
    centerOn(middle);
    emit zoomChanged(this->zoom());
}

void SceneView::fit()
{
    QRectF area = bothStages(m_shown.look(), m_beside);
    if (m_shown.look().room)
        area = area.united(roomArea(*m_shown.look().room, area));
    if (m_shown.look().tree)
        area = area.united(treeArea(*m_shown.look().tree, m_shown.state()));
    m_atHome = false;
    m_follows = true;
    showArea(area, mostZoom);
    follow();
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
    movePicture(keep - viewportTransform().map(place));
    emit zoomChanged(this->zoom());
}

void SceneView::pan(QPointF by)
{
    m_follows = false;
    movePicture(by);
}

void SceneView::movePicture(QPointF by)
{
    m_atHome = false;
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() - static_cast<int>(std::lround(by.x())));
    verticalScrollBar()->setValue(verticalScrollBar()->value() - static_cast<int>(std::lround(by.y())));
}

void SceneView::follow()
{
    const int point = m_shown.look().follow;
    const double width = viewRect().width();
    // While a hand holds something, the picture stays: else the hand would carry it on and on.
    if (point < 0 || !m_follows || m_hand.isDown() || width <= 0.0)
        return;
    const double x = camera().at(m_shown.state().at(point)).x();
    const double kept = std::clamp(x, followEdge * width, (1.0 - followEdge) * width);
    if (std::abs(kept - x) < 0.5)
        return;
    const bool wasAtHome = m_atHome;
    movePicture({kept - x, 0.0});
    m_atHome = wasAtHome;
}

void SceneView::bringBack(const QString &body)
{
    const int point = m_shown.picture.segment->scene.find(body.toStdString());
    if (point < 0)
        return;
    const sim::Vec2 at = m_shown.state().at(point);
    m_atHome = false;
    m_follows = m_follows || point == m_shown.look().follow;
    centerOn(std::clamp(at.x, -worldReach, worldReach), std::clamp(at.y, -worldReach, worldReach));
    viewport()->update();
}

void SceneView::resizeEvent(QResizeEvent *event)
{
    QGraphicsView::resizeEvent(event);
    if (m_atHome && !m_home.isEmpty())
        showArea(m_home, mostAtHome(m_shown.look()));
    if (m_shown.points() > 0)
        follow();
}

}

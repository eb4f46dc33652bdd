// How the scene view frames a step at first, and how it then keeps its bodies in view.
//
// Until the learner zooms or pans, the view shows the bodies with their motion. If bodies leave the view, it
// zooms out, then moves along. Back at frame 0, it returns to the first framing. After the learner has zoomed
// or panned, the view stays as it is while any body is in view. When the last body has left, the view moves
// to the bodies and keeps its zoom. "Fit" returns to the first behaviour.

#include "app/model/picture/motion_area.h"
#include "app/ui/scene/framing.h"
#include "app/ui/scene/hud/free_area.h"
#include "app/ui/scene/layers/layers.h"
#include "app/ui/scene/scene_view.h"
#include "sim/run/script/composed_interval.h"

#include <QResizeEvent>
#include <QScrollBar>

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr double zoomStep = 1.25;
/// The view keeps the followed body between these fractions of its width. Bodies walk to the right, so there is
/// more space on that side.
constexpr double walkerFrom = 0.4;
constexpr double walkerTo = 0.5;
constexpr double mostWidened = 4.0;    ///< the view zooms out by itself by at most this factor
constexpr double inSightBorder = 16.0; ///< screen px; anything closer to the edge does not count as visible
constexpr double legendBorder = 52.0;  ///< screen px below the bodies, for two lines of the legend
constexpr double nearer = 1.3;         ///< a close-up must enlarge by at least this factor to be worth a jump
constexpr std::int64_t mostMeasured = 200;       ///< frames from the start whose motion is measured, at most
constexpr std::int64_t measuredPoints = 200'000; ///< points times frames, if that is less
constexpr qint64 measuredMilliseconds = 60;      ///< if that is less

/// Returns whether walls and floor are unchanged since `before` was shown.
bool hasSameRoom(const lessons::View &view, QRectF home, QRectF before)
{
    return !before.isEmpty() &&
           (!view.room || (home.left() == before.left() && home.right() == before.right() &&
                           home.bottom() == before.bottom()));
}

/// Returns the box of the bodies of `shown` within `area`.
QRectF boxWithin(const SceneContent &shown, const QRectF &area)
{
    QRectF box;
    for (int i = 0; i < shown.points(); ++i) {
        const sim::Vec2 at = shown.state().positionOf(i) + shown.shift;
        const double radius = shown.radius(i);
        const QRectF body = QRectF(at.x, at.y, 0.0, 0.0).adjusted(-radius, -radius, radius, radius);
        if (area.contains(body))
            box |= body;
    }
    return box;
}

/// Returns the box of the crosses of `picture`, such as the target of a motor.
QRectF boxOfCrosses(const Picture &picture)
{
    QRectF box;
    for (const lessons::Overlay &overlay : picture.overlays) {
        if (overlay.shape == lessons::Overlay::Shape::cross)
            box |= QRectF(overlay.a.x, overlay.a.y, 0.0, 0.0).adjusted(-1.0, -1.0, 1.0, 1.0);
    }
    return box;
}

/// Returns the part of `view`, screen px, in which the text at the top and the legend cover no body. In a small view,
/// which they would fill, it is the view within its border.
QRectF uncovered(const SceneContent &shown, QRectF view)
{
    const QRectF all = view.adjusted(frameBorder, frameBorder, -frameBorder, -frameBorder);
    QRectF clear = all;
    clear.setTop(std::max(all.top(), freeArea(shown, view).top()));
    const bool isPaper =
        shown.view().sky == lessons::View::Sky::paper && !shown.view().room && !shown.view().ground;
    if (isPaper) // elsewhere the legend is below the floor
        clear.setBottom(view.bottom() - legendBorder);
    return clear.height() < view.height() / 2.0 ? all : clear;
}

bool isNowhere(const QRectF &box)
{
    const QRectF world(-worldReach, -worldReach, 2.0 * worldReach, 2.0 * worldReach);
    return box.isNull() || !world.contains(box);
}

}

double SceneView::zoom() const
{
    return 100.0 * transform().m11();
}

const QRectF &SceneView::motion()
{
    if (m_motion)
        return *m_motion;
    const std::int64_t frames =
        std::min(mostMeasured, measuredPoints / std::max<std::int64_t>(1, m_shown.points()));
    MotionArea measured(m_session.timeline().script(), m_shown.picture.view, 0, frames);
    measured.goOn(measuredMilliseconds);
    m_motion = measured.area();
    return *m_motion;
}

QRectF SceneView::motionHere()
{
    return motion().translated(followedX(m_shown.view(), m_shown.state()), 0.0);
}

void SceneView::showHome()
{
    const QRectF before = m_atHome && !m_isFitted ? m_home : QRectF();
    const QRectF seen = viewportTransform().inverted().mapRect(viewRect());
    m_home = homeArea(m_shown.picture, m_companion, motionHere());
    m_stage = m_shown.view().stage;
    m_atHome = true;
    m_isFitted = false;
    // While a learner adds parts one by one, the view moves only if something would be invisible.
    const bool stays = m_session.isSandbox() && hasSameRoom(m_shown.view(), m_home, before) &&
                       seen.contains(creatureArea(m_shown.picture));
    if (stays)
        m_narrow.reset();
    else
        frameHome();
}

void SceneView::frameHome()
{
    const QSizeF size = viewRect().size();
    const double most = m_isFitted ? mostZoom : mostAtHome(m_shown.view(), size);
    frame(framingOf(m_shown.view(), m_home, size, most));
    m_narrow.reset();
    m_isClose = false;
    m_seenAt = m_session.preview().run().cursor();
    followWithin(walkerFrom, walkerFrom);
}

void SceneView::frame(const Framing &framing)
{
    setTransform(QTransform::fromScale(framing.zoom, framing.zoom));
    centerOn(framing.middle);
    emit zoomChanged(zoom());
}

Framing SceneView::framing() const
{
    return {transform().m11(), viewportTransform().inverted().map(viewRect().center())};
}

void SceneView::fit()
{
    m_home = wholeArea(m_shown.picture, m_companion, motionHere());
    m_atHome = true;
    m_isFitted = true;
    m_follows = true;
    frameHome();
}

void SceneView::showSpan(const QRectF &motion)
{
    const lessons::View &view = m_shown.view();
    const QSizeF size = viewRect().size();
    const auto zoomOf = [&](const QRectF &area) {
        return framingOf(view, area, size, mostAtHome(view, size)).zoom;
    };
    const QRectF span = motion.translated(followedX(view, m_shown.state()), 0.0);
    const QRectF all = m_home.united(span);
    if (zoomOf(all) * 2.0 >= zoomOf(m_home))
        m_home = all;
    else if (zoomOf(span) * mostWidened >= zoomOf(m_home))
        m_home = span;
    frameHome();
}

void SceneView::returnHome()
{
    if (m_atHome && m_narrow)
        frame(*m_narrow);
    m_narrow.reset();
    m_isClose = false;
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
    const bool wasInSight = isSubjectInSight();
    movePicture(by);
    if (wasInSight && !isSubjectInSight()) // the learner cannot pan away from all bodies
        movePicture(wayToSubject());
}

void SceneView::movePicture(QPointF by)
{
    m_atHome = false;
    shiftBy(by);
}

void SceneView::shiftBy(QPointF by)
{
    horizontalScrollBar()->setValue(horizontalScrollBar()->value() - static_cast<int>(std::lround(by.x())));
    verticalScrollBar()->setValue(verticalScrollBar()->value() - static_cast<int>(std::lround(by.y())));
}

void SceneView::followWithin(double from, double to)
{
    const int point = m_shown.view().followedPoint;
    const double width = viewRect().width();
    // While a body is being dragged, the view stays: a moving view would drag the body on and on. While the
    // pointer is pressed, the view also stays, so that creatures that run after the pointer can reach it.
    if (point < 0 || !m_follows || m_drag.isDown() || m_tools.isPointing() || width <= 0.0)
        return;
    const double x = camera().at(m_shown.state().positionOf(point)).x();
    const double kept = std::clamp(x, from * width, to * width);
    if (std::abs(kept - x) >= 0.5)
        shiftBy({kept - x, 0.0});
}

void SceneView::follow()
{
    followWithin(walkerFrom, walkerTo);
}

void SceneView::keepSubject()
{
    follow();
    const sim::Cursor at = m_session.preview().run().cursor();
    const bool hasMoved = at != m_seenAt;
    m_seenAt = at;
    if (m_session.preview().isActive() || m_drag.isDown() || viewRect().isEmpty() || m_shown.points() == 0)
        return;
    if (m_narrow && (at == sim::Cursor{} || (m_isClose && m_session.playback().isPlaying())))
        returnHome();
    const bool isBuilding = m_session.isSandbox() && at == sim::Cursor{};
    if (m_atHome && !isBuilding) {
        zoomToCreature();
        widen();
    } else if (!m_atHome && hasMoved && !isSubjectInSight()) {
        bringSubjectBack();
    }
}

QRectF SceneView::subject() const
{
    QRectF box = subjectBox(m_shown.view(), m_shown.state());
    if (m_companion.points() > 0)
        box |= subjectBox(m_companion.view(), m_companion.state())
                   .translated(m_companion.shift.x, m_companion.shift.y);
    return box;
}

QRectF SceneView::subjectWithin(const QRectF &area) const
{
    return boxWithin(m_shown, area) | boxWithin(m_companion, area);
}

bool SceneView::isSubjectInSight() const
{
    const QRectF sight = viewRect().adjusted(inSightBorder, inSightBorder, -inSightBorder, -inSightBorder);
    const Camera camera = this->camera();
    const auto isSeen = [&](const SceneContent &shown) {
        for (int i = 0; i < shown.points(); ++i) {
            if (sight.contains(camera.at(shown.state().positionOf(i) + shown.shift)))
                return true;
        }
        return false;
    };
    return isSeen(m_shown) || isSeen(m_companion); // while the companion is visible, bodies may fly off
}

QPointF SceneView::wayToSubject() const
{
    const QRectF inside = viewRect().adjusted(2.0 * inSightBorder, 2.0 * inSightBorder, -2.0 * inSightBorder,
                                              -2.0 * inSightBorder);
    const Camera camera = this->camera();
    QPointF shortest;
    double least = std::numeric_limits<double>::infinity();
    for (int i = 0; i < m_shown.points(); ++i) {
        const sim::Vec2 place = m_shown.state().positionOf(i);
        if (std::max(std::abs(place.x), std::abs(place.y)) > worldReach)
            continue; // the view cannot reach it
        const QPointF at = camera.at(place);
        const QPointF way(std::clamp(at.x(), inside.left(), inside.right()) - at.x(),
                          std::clamp(at.y(), inside.top(), inside.bottom()) - at.y());
        const double length = QPointF::dotProduct(way, way);
        if (length < least) {
            least = length;
            shortest = way;
        }
    }
    return shortest;
}

void SceneView::bringSubjectBack()
{
    const QRectF box = subject();
    const QRectF there = viewportTransform().mapRect(box);
    if (there.width() < viewRect().width() && there.height() < viewRect().height() && !isNowhere(box))
        centerOn(box.center());
    else
        shiftBy(wayToSubject());
}

void SceneView::widen()
{
    QRectF inside = viewRect().adjusted(frameBorder, frameBorder, -frameBorder, -frameBorder);
    if (inside.isEmpty())
        return;
    const QRectF clear = uncovered(m_shown, viewRect());
    if (m_narrow)
        inside = clear;
    QRectF box = subject();
    if (m_session.preview().run().cursor() == sim::Cursor{} && !m_tools.isPointing())
        box |= boxOfCrosses(m_shown.picture); // a run begins with all of its marks in view
    if (m_shown.view().followedPoint >= 0 &&
        // The followed point may be left of the centre, with bodies on either side.
        m_follows) {
        const double x = followedX(m_shown.view(), m_shown.state());
        const double side = std::max(x - box.left(), box.right() - x) / (2.0 * walkerFrom);
        box |= QRectF(QPointF(x - side, box.top()), QPointF(x + side, box.bottom()));
    }
    const QTransform toScene = viewportTransform().inverted();
    if (toScene.mapRect(inside).adjusted(-0.5, -0.5, 0.5, 0.5).contains(box))
        return;
    m_narrow = m_narrow.value_or(framing());
    const double least = m_narrow->zoom / mostWidened;
    // As if the view were only as large as its uncovered part, with the usual border.
    const QRectF part = clear.adjusted(-frameBorder, -frameBorder, frameBorder, frameBorder);
    const auto widenedTo = [&](const QRectF &all) {
        return widened(m_shown.view(), toScene.mapRect(clear), all, part.size(), least);
    };
    std::optional<Framing> wide;
    if (!isNowhere(box))
        wide = widenedTo(box);
    if (!wide) { // some fly off: show the others
        const QSizeF size = viewRect().size() / least;
        const QPointF corner = m_narrow->middle - QPointF(size.width() / 2.0, size.height() / 2.0);
        const QRectF others = subjectWithin({corner, size});
        if (!others.isNull())
            wide = widenedTo(others);
    }
    if (wide) {
        wide->middle += (viewRect().center() - part.center()) / wide->zoom;
        frame(*wide);
    }
    follow();
    if (!isSubjectInSight())
        bringSubjectBack();
}

void SceneView::zoomToCreature()
{
    const bool isInside = m_session.preview().run().cursor().phase > 0 && !m_session.playback().isPlaying();
    if (!isInside || m_isClose || m_shown.isCrowd() || m_shown.view().tree || m_companion.points() > 0)
        return;
    const QRectF area = creatureArea(m_shown.picture);
    const Framing close = closeUp(m_shown.view(), area, viewRect().size());
    if (close.zoom < nearer * transform().m11() || isNowhere(area))
        return;
    m_narrow = m_narrow.value_or(framing());
    m_isClose = true;
    frame(close);
}

void SceneView::bringBack(const QString &body)
{
    const int point = m_shown.picture.interval->scene.find(body.toStdString());
    if (point < 0)
        return;
    const sim::Vec2 at = m_shown.state().positionOf(point);
    m_atHome = false;
    m_follows = m_follows || point == m_shown.view().followedPoint;
    centerOn(std::clamp(at.x, -worldReach, worldReach), std::clamp(at.y, -worldReach, worldReach));
    viewport()->update();
}

void SceneView::resizeEvent(QResizeEvent *event)
{
    QGraphicsView::resizeEvent(event);
    if (m_atHome && !m_home.isEmpty())
        frameHome();
    if (m_shown.points() > 0)
        keepSubject();
}

}

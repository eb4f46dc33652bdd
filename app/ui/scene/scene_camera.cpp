// Where the scene view looks: what a step shows first, and how the picture stays with its subject.
//
// As long as the learner has neither zoomed nor moved the picture, it shows the subject with its motion. If bodies leave
// it all the same, it zooms out, then moves along; back at frame 0 it shows what it showed first. A picture that the
// learner has zoomed or moved stays as it is while any body is in sight. When the last one has left, the picture moves
// to the bodies and keeps its zoom. "Fit" gives it back to the first rule.

#include "app/model/motion_area.h"
#include "app/ui/scene/framing.h"
#include "app/ui/scene/layers.h"
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
constexpr double walkerFrom =
    0.4; ///< of the view's width, where the body that it follows is kept: the view looks
constexpr double walkerTo = 0.5;           ///< ahead, as they walk to the right
constexpr double mostWidened = 4.0;        ///< how many times as wide the view gets by itself
constexpr double inSightBorder = 16.0;     ///< px of the screen: what is nearer to the edge is not in sight
constexpr double nearer = 1.3;             ///< a closer look that enlarges less than that is not worth a jump
constexpr std::int64_t mostMeasured = 200; ///< frames of which the motion is shown from the start
constexpr std::int64_t measuredPoints = 200'000; ///< points times frames, if that is less
constexpr qint64 measuredMilliseconds = 60;      ///< if that is less

/// Whether walls and floor are where they were in what was shown before.
bool hasSameRoom(const lessons::View &look, QRectF home, QRectF before)
{
    return !before.isEmpty() &&
           (!look.room || (home.left() == before.left() && home.right() == before.right() &&
                           home.bottom() == before.bottom()));
}

/// The box of those bodies of `shown` that lie within `area`.
QRectF boxWithin(const Shown &shown, const QRectF &area)
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
    MotionArea measured(m_session.timeline().script(), m_shown.picture.look, 0, frames);
    measured.goOn(measuredMilliseconds);
    m_motion = measured.area();
    return *m_motion;
}

QRectF SceneView::motionHere()
{
    return motion().translated(followedX(m_shown.look(), m_shown.state()), 0.0);
}

void SceneView::showHome()
{
    const QRectF before = m_atHome && !m_isFitted ? m_home : QRectF();
    const QRectF seen = viewportTransform().inverted().mapRect(viewRect());
    m_home = homeArea(m_shown.picture, m_beside, motionHere());
    m_stage = m_shown.look().stage;
    m_atHome = true;
    m_isFitted = false;
    // While a learner puts one part after the other, the picture moves only for what is not seen.
    const bool stays = m_session.isWorkshop() && hasSameRoom(m_shown.look(), m_home, before) &&
                       seen.contains(creatureArea(m_shown.picture));
    if (stays)
        m_narrow.reset();
    else
        frameHome();
}

void SceneView::frameHome()
{
    const QSizeF size = viewRect().size();
    const double most = m_isFitted ? mostZoom : mostAtHome(m_shown.look(), size);
    frame(framingOf(m_shown.look(), m_home, size, most));
    m_narrow.reset();
    m_isClose = false;
    m_seenAt = m_session.shown().cursor();
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
    m_home = wholeArea(m_shown.picture, m_beside, motionHere());
    m_atHome = true;
    m_isFitted = true;
    m_follows = true;
    frameHome();
}

void SceneView::showSpan(const QRectF &motion)
{
    const lessons::View &look = m_shown.look();
    const QSizeF size = viewRect().size();
    const auto zoomOf = [&](const QRectF &area) {
        return framingOf(look, area, size, mostAtHome(look, size)).zoom;
    };
    const QRectF span = motion.translated(followedX(look, m_shown.state()), 0.0);
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
    if (wasInSight && !isSubjectInSight()) // it cannot be moved away from all that there is
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
    const int point = m_shown.look().followedPoint;
    const double width = viewRect().width();
    // While a hand holds something, the picture stays: else the hand would carry it on and on. It also stays while the
    // pointer is held: what runs after it shall come to it.
    if (point < 0 || !m_follows || m_hand.isDown() || m_tools.isPointing() || width <= 0.0)
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
    const sim::Cursor at = m_session.shown().cursor();
    const bool hasMoved = at != m_seenAt;
    m_seenAt = at;
    if (m_session.isGlancing() || m_hand.isDown() || viewRect().isEmpty() || m_shown.points() == 0)
        return;
    if (m_narrow && (at == sim::Cursor{} || (m_isClose && m_session.isPlaying())))
        returnHome();
    const bool isBuilding = m_session.isWorkshop() && at == sim::Cursor{};
    if (m_atHome && !isBuilding) {
        lookClosely();
        widen();
    } else if (!m_atHome && hasMoved && !isSubjectInSight()) {
        bringSubjectBack();
    }
}

QRectF SceneView::subject() const
{
    QRectF box = subjectBox(m_shown.look(), m_shown.state());
    if (m_beside.points() > 0)
        box |= subjectBox(m_beside.look(), m_beside.state()).translated(m_beside.shift.x, m_beside.shift.y);
    return box;
}

QRectF SceneView::subjectWithin(const QRectF &area) const
{
    return boxWithin(m_shown, area) | boxWithin(m_beside, area);
}

bool SceneView::isSubjectInSight() const
{
    const QRectF sight = viewRect().adjusted(inSightBorder, inSightBorder, -inSightBorder, -inSightBorder);
    const Camera camera = this->camera();
    const auto isSeen = [&](const Shown &shown) {
        for (int i = 0; i < shown.points(); ++i) {
            if (sight.contains(camera.at(shown.state().positionOf(i) + shown.shift)))
                return true;
        }
        return false;
    };
    return isSeen(m_shown) || isSeen(m_beside); // whoever flies off leaves the companion to be looked at
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
            continue; // no picture goes there
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
    const QRectF inside = viewRect().adjusted(frameBorder, frameBorder, -frameBorder, -frameBorder);
    if (inside.isEmpty())
        return;
    QRectF box = subject();
    if (m_shown.look().followedPoint >= 0 &&
        m_follows) { // it may stand left of the middle, with others on either side
        const double x = followedX(m_shown.look(), m_shown.state());
        const double side = std::max(x - box.left(), box.right() - x) / (2.0 * walkerFrom);
        box |= QRectF(QPointF(x - side, box.top()), QPointF(x + side, box.bottom()));
    }
    const QRectF now = viewportTransform().inverted().mapRect(inside);
    if (now.adjusted(-0.5, -0.5, 0.5, 0.5).contains(box))
        return;
    m_narrow = m_narrow.value_or(framing());
    const double least = m_narrow->zoom / mostWidened;
    std::optional<Framing> wide;
    if (!isNowhere(box))
        wide = widened(m_shown.look(), now, box, viewRect().size(), least);
    if (!wide) { // some fly off: the others are shown
        const QSizeF size = viewRect().size() / least;
        const QPointF corner = m_narrow->middle - QPointF(size.width() / 2.0, size.height() / 2.0);
        const QRectF others = subjectWithin({corner, size});
        if (!others.isNull())
            wide = widened(m_shown.look(), now, others, viewRect().size(), least);
    }
    if (wide)
        frame(*wide);
    follow();
    if (!isSubjectInSight())
        bringSubjectBack();
}

void SceneView::lookClosely()
{
    const bool isInside = m_session.shown().cursor().phase > 0 && !m_session.isPlaying();
    if (!isInside || m_isClose || m_shown.isCrowd() || m_shown.look().tree || m_beside.points() > 0)
        return;
    const QRectF area = creatureArea(m_shown.picture);
    const Framing close = closeUp(m_shown.look(), area, viewRect().size());
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
    m_follows = m_follows || point == m_shown.look().followedPoint;
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

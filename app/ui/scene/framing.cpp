// Computes which part of the scene a view shows.

#include "app/ui/scene/framing.h"

#include "app/model/picture/motion_area.h"

#include <algorithm>

namespace app {

namespace {

constexpr double pleasant = 2.6;          ///< the zoom for a small creature
constexpr double arrowRoom = 100.0;       ///< screen px around a creature with arrows
constexpr double creatureReach = 75.0;    ///< px around a creature's centre, at least
constexpr double dragReach = 110.0;       ///< likewise, with space to drag a body
constexpr double creatureRoom = 12.0;     ///< px beside a creature's outermost body
constexpr double nearWall = 40.0;         ///< px; a wall closer to the creature than this is shown too
constexpr double solidSide = 12.0;        ///< px beyond the walls that a room shows
constexpr double groundBorder = 52.0;     ///< screen px below a floor, for the scale and the legends
constexpr double endlessBorder = 68.0;    ///< likewise for endless ground, where distances are shown too
constexpr double endlessShare = 0.12;     ///< of the view's height, if that is more
constexpr double largestRoom = 1.5;       ///< the largest first zoom of a room or a tree
constexpr double largestWalk = 1.8;       ///< the largest first zoom of a walking creature
constexpr QSizeF usualView{680.0, 520.0}; ///< px; larger views allow a larger zoom
constexpr double motionShare = 0.5; ///< how far motion may extend a step's area on each side, as a fraction
constexpr double flyingOff = 4.0;   ///< motion this much larger than the area leaves any view

QRectF around(QPointF centre, double half)
{
    return {centre.x() - half, centre.y() - half, 2.0 * half, 2.0 * half};
}

/// Returns whether there is ground without walls. Such ground is endless.
bool standsOnGround(const lessons::View &view)
{
    return !view.room && (view.ground || view.sky != lessons::View::Sky::paper);
}

/// Returns the height of the floor, ground or horizon, scene px. Empty if there is none, or if it is far
/// below the stage.
std::optional<double> baseOf(const lessons::View &view)
{
    std::optional<double> base = view.room ? std::optional(view.room->floor) : view.ground;
    if (!base && view.sky != lessons::View::Sky::paper)
        base = view.stage.bottom();
    return base && *base < view.stage.bottom() + 2.0 * view.stage.height() ? base : std::nullopt;
}

/// Returns the area of the floor, the walls and the space between them.
QRectF roomArea(const lessons::View &view)
{
    const double floor = baseOf(view).value_or(view.stage.bottom());
    return QRectF(QPointF(view.room->left - solidSide, std::min(view.stage.top(), floor - 1.0)),
                  QPointF(view.room->right + solidSide, floor));
}

/// Returns how many screen px stay free below the content, in a view of this height.
double belowBase(const lessons::View &view, double height)
{
    return standsOnGround(view) ? std::max(endlessBorder, endlessShare * height) : groundBorder;
}

/// Returns the box of both stages: the figure's and its companion's.
QRectF bothStages(const lessons::View &view, const SceneContent &companion)
{
    return view.stage.united(view.stage.translated(companion.shift.x, companion.shift.y));
}

/// Returns the area that a step is about, at its start.
QRectF restArea(const Picture &picture, const SceneContent &companion)
{
    const lessons::View &view = *picture.view;
    if (!companion.name.isEmpty())
        return bothStages(view, companion);
    if (view.room)
        return roomArea(view);
    if (view.tree)
        return view.stage.united(subjectBox(view, picture.state));
    if (view.sky != lessons::View::Sky::paper)
        return view.stage;
    QRectF area = creatureArea(picture);
    area = area.united(around(area.center(), dragReach));
    if (view.ground)
        area.setBottom(*view.ground);
    const bool isSmall = area.width() < view.stage.width() && area.height() < view.stage.height();
    return isSmall ? area : view.stage.united(area);
}

/// Returns `area` with the part of `motion` near it, or `area` alone if bodies fly off. They would otherwise make
/// everything tiny.
QRectF withMotion(const QRectF &area, const QRectF &motion)
{
    if (motion.width() > flyingOff * area.width() || motion.height() > flyingOff * area.height())
        return area;
    const double across = motionShare * area.width(), down = motionShare * area.height();
    return area.united(motion.intersected(area.adjusted(-across, -down, across, down)));
}

/// Returns `area` extended to the near walls and floor of the room, so that a creature is shown with the wall
/// that it is about to hit.
QRectF withNearWalls(const lessons::View &view, QRectF area)
{
    if (!view.room)
        return area;
    const QRectF room = roomArea(view);
    if (area.left() - room.left() < nearWall)
        area.setLeft(std::min(area.left(), room.left()));
    if (room.right() - area.right() < nearWall)
        area.setRight(std::max(area.right(), room.right()));
    if (room.bottom() - area.bottom() < nearWall)
        area.setBottom(std::max(area.bottom(), room.bottom()));
    return area;
}

/// Returns the start of an interval of length `room` that contains `wantedFrom` to `wantedTo`, after the
/// smallest move from `from`.
double moved(double from, double room, double wantedFrom, double wantedTo)
{
    return std::clamp(from, wantedTo - room, wantedFrom);
}

}

QRectF creatureArea(const Picture &picture)
{
    QRectF area;
    for (int i = 0; i < picture.state.pointCount(); ++i) {
        const sim::Vec2 at = picture.state.positionOf(i);
        const double half = picture.view->bodies[static_cast<std::size_t>(i)].radius + creatureRoom;
        area = area.united(around({at.x, at.y}, half));
    }
    for (const lessons::Overlay &overlay : picture.overlays)
        area = area.united(around({overlay.a.x, overlay.a.y}, std::max(overlay.size, creatureRoom)));
    return area.united(around(area.center(), creatureReach));
}

QRectF homeArea(const Picture &picture, const SceneContent &companion, const QRectF &motion)
{
    return withMotion(restArea(picture, companion), motion);
}

QRectF wholeArea(const Picture &picture, const SceneContent &companion, const QRectF &motion)
{
    const lessons::View &view = *picture.view;
    QRectF area = bothStages(view, companion);
    if (view.room)
        area = area.united(roomArea(view));
    return withMotion(area, motion).united(subjectBox(view, picture.state));
}

double mostAtHome(const lessons::View &view, QSizeF size)
{
    const double larger =
        std::max(1.0, std::min(size.width() / usualView.width(), size.height() / usualView.height()));
    if (view.ground && !view.room)
        return larger * largestWalk;
    const bool isLarge = view.room || view.tree || view.sky != lessons::View::Sky::paper;
    return larger * (isLarge ? largestRoom : pleasant);
}

Framing framingOf(const lessons::View &view, const QRectF &area, QSizeF size, double most)
{
    const std::optional<double> base = baseOf(view);
    const double below = belowBase(view, size.height());
    double zoom = std::min((size.width() - 2.0 * frameBorder) / area.width(),
                           (size.height() - 2.0 * frameBorder) / area.height());
    if (base && *base > area.top())
        zoom = std::min(zoom, (size.height() - frameBorder - below) / (*base - area.top()));
    zoom = std::clamp(std::min(zoom, most), leastZoom, mostZoom);
    QPointF middle = area.center();
    if (base) { // it is low in the view, even if there is much space above
        const double bottom = std::max(*base + below / zoom, area.bottom() + frameBorder / zoom);
        middle.setY(bottom - size.height() / 2.0 / zoom);
    }
    return {zoom, middle};
}

Framing closeUp(const lessons::View &view, const QRectF &creature, QSizeF size)
{
    const QRectF area = withNearWalls(view, creature);
    const double zoom = std::min({(size.width() - 2.0 * arrowRoom) / area.width(),
                                  (size.height() - 2.0 * arrowRoom) / area.height(), pleasant});
    QPointF middle = area.center();
    if (const std::optional<double> base = baseOf(view); base && *base > area.center().y())
        middle.setY(std::min(middle.y(), *base + (arrowRoom - size.height() / 2.0) / zoom));
    return {zoom, middle};
}

std::optional<Framing> widened(const lessons::View &view, const QRectF &now, const QRectF &box, QSizeF size,
                               double least)
{
    const QSizeF inside(size.width() - 2.0 * frameBorder, size.height() - 2.0 * frameBorder);
    QRectF all = now.united(box);
    const std::optional<double> base = baseOf(view);
    if (base && now.top() < *base && *base < now.bottom())
        all.setBottom(std::max(*base, box.bottom()));
    const Framing wide = framingOf(view, all, size, inside.width() / now.width());
    if (wide.zoom >= least)
        return wide;
    const QSizeF room = inside / least;
    if (box.width() > room.width() || box.height() > room.height())
        return std::nullopt;
    const QPointF middle = now.center();
    const double left = moved(middle.x() - room.width() / 2.0, room.width(), box.left(), box.right());
    const double top = moved(middle.y() - room.height() / 2.0, room.height(), box.top(), box.bottom());
    return Framing{least, {left + room.width() / 2.0, top + room.height() / 2.0}};
}

}

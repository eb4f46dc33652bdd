// Which part of the scene a view shows.

#include "app/ui/scene/framing.h"

#include "app/model/motion_area.h"

#include <algorithm>

namespace app {

namespace {

constexpr double pleasant = 2.6;          ///< the zoom of a creature that is small enough for it
constexpr double arrowRoom = 100.0;       ///< px of the screen round a creature with arrows
constexpr double creatureReach = 75.0;    ///< px round a creature's middle that it needs, at least
constexpr double handReach = 110.0;       ///< likewise, for a hand that carries something
constexpr double creatureRoom = 12.0;     ///< px that it needs beside its outermost body
constexpr double nearWall = 40.0;         ///< px from a creature to a wall that is shown with it
constexpr double solidSide = 12.0;        ///< px beyond the walls that a room shows
constexpr double groundBorder = 52.0;     ///< px of the screen below a floor: scale and legends stand there
constexpr double endlessBorder = 68.0;    ///< likewise, of an endless ground: distances stand there too
constexpr double endlessShare = 0.12;     ///< of the view's height, if that is more
constexpr double largestRoom = 1.5;       ///< the most that a room or a tree is enlarged at first
constexpr double largestWalk = 1.8;       ///< the most that a creature that walks is enlarged at first
constexpr QSizeF usualView{680.0, 520.0}; ///< px; larger views enlarge more
constexpr double motionShare = 0.5;       ///< of what a step is about, that motion may add on each side

QRectF around(QPointF centre, double half)
{
    return {centre.x() - half, centre.y() - half, 2.0 * half, 2.0 * half};
}

/// Whether there is ground without walls: it is endless.
bool standsOnGround(const lessons::View &look)
{
    return !look.room && (look.ground || look.sky != lessons::View::Sky::paper);
}

/// The height of floor, ground or horizon, px of the scene; empty without one, or where it is far below the stage.
std::optional<double> baseOf(const lessons::View &look)
{
    std::optional<double> base = look.room ? std::optional(look.room->floor) : look.ground;
    if (!base && look.sky != lessons::View::Sky::paper)
        base = look.stage.bottom();
    return base && *base < look.stage.bottom() + 2.0 * look.stage.height() ? base : std::nullopt;
}

/// Floor, walls and what is between them.
QRectF roomArea(const lessons::View &look)
{
    const double floor = baseOf(look).value_or(look.stage.bottom());
    return QRectF(QPointF(look.room->left - solidSide, std::min(look.stage.top(), floor - 1.0)),
                  QPointF(look.room->right + solidSide, floor));
}

/// px of the screen that stay free below what is shown, in a view of this height.
double belowBase(const lessons::View &look, double height)
{
    return standsOnGround(look) ? std::max(endlessBorder, endlessShare * height) : groundBorder;
}

/// The stage of a figure and that of its companion.
QRectF bothStages(const lessons::View &look, const Shown &beside)
{
    return look.stage.united(look.stage.translated(beside.shift.x, beside.shift.y));
}

/// What a step is about at its start.
QRectF restArea(const Picture &picture, const Shown &beside)
{
    const lessons::View &look = *picture.look;
    if (!beside.name.isEmpty())
        return bothStages(look, beside);
    if (look.room)
        return roomArea(look);
    if (look.tree)
        return look.stage.united(subjectBox(look, picture.state));
    if (look.sky != lessons::View::Sky::paper)
        return look.stage;
    QRectF area = creatureArea(picture);
    area = area.united(around(area.center(), handReach));
    if (look.ground)
        area.setBottom(*look.ground);
    const bool isSmall = area.width() < look.stage.width() && area.height() < look.stage.height();
    return isSmall ? area : look.stage.united(area);
}

/// `area` and of `motion` what is near it: what flies off does not make all else tiny.
QRectF withMotion(const QRectF &area, const QRectF &motion)
{
    const double across = motionShare * area.width(), down = motionShare * area.height();
    return area.united(motion.intersected(area.adjusted(-across, -down, across, down)));
}

/// `area` and the walls and the floor of the room that are not far from it: what is about to hit them is looked at with
/// them.
QRectF withNearWalls(const lessons::View &look, QRectF area)
{
    if (!look.room)
        return area;
    const QRectF room = roomArea(look);
    if (area.left() - room.left() < nearWall)
        area.setLeft(std::min(area.left(), room.left()));
    if (room.right() - area.right() < nearWall)
        area.setRight(std::max(area.right(), room.right()));
    if (room.bottom() - area.bottom() < nearWall)
        area.setBottom(std::max(area.bottom(), room.bottom()));
    return area;
}

/// Where a stretch of length `room` begins that holds `wanted` after the smallest move from `from`.
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
        const double half = picture.look->bodies[static_cast<std::size_t>(i)].radius + creatureRoom;
        area = area.united(around({at.x, at.y}, half));
    }
    for (const lessons::Overlay &guide : picture.guides)
        area = area.united(around({guide.a.x, guide.a.y}, std::max(guide.size, creatureRoom)));
    return area.united(around(area.center(), creatureReach));
}

QRectF homeArea(const Picture &picture, const Shown &beside, const QRectF &motion)
{
    return withMotion(restArea(picture, beside), motion);
}

QRectF wholeArea(const Picture &picture, const Shown &beside, const QRectF &motion)
{
    const lessons::View &look = *picture.look;
    QRectF area = bothStages(look, beside);
    if (look.room)
        area = area.united(roomArea(look));
    return withMotion(area, motion).united(subjectBox(look, picture.state));
}

double mostAtHome(const lessons::View &look, QSizeF view)
{
    const double larger =
        std::max(1.0, std::min(view.width() / usualView.width(), view.height() / usualView.height()));
    if (look.ground && !look.room)
        return larger * largestWalk;
    const bool isLarge = look.room || look.tree || look.sky != lessons::View::Sky::paper;
    return larger * (isLarge ? largestRoom : pleasant);
}

Framing framingOf(const lessons::View &look, const QRectF &area, QSizeF view, double most)
{
    const std::optional<double> base = baseOf(look);
    const double below = belowBase(look, view.height());
    double zoom = std::min((view.width() - 2.0 * frameBorder) / area.width(),
                           (view.height() - 2.0 * frameBorder) / area.height());
    if (base && *base > area.top())
        zoom = std::min(zoom, (view.height() - frameBorder - below) / (*base - area.top()));
    zoom = std::clamp(std::min(zoom, most), leastZoom, mostZoom);
    QPointF middle = area.center();
    if (base) { // it lies low, however much room there is above
        const double bottom = std::max(*base + below / zoom, area.bottom() + frameBorder / zoom);
        middle.setY(bottom - view.height() / 2.0 / zoom);
    }
    return {zoom, middle};
}

Framing closeUp(const lessons::View &look, const QRectF &creature, QSizeF view)
{
    const QRectF area = withNearWalls(look, creature);
    const double zoom = std::min({(view.width() - 2.0 * arrowRoom) / area.width(),
                                  (view.height() - 2.0 * arrowRoom) / area.height(), pleasant});
    QPointF middle = area.center();
    if (const std::optional<double> base = baseOf(look); base && *base > area.center().y())
        middle.setY(std::min(middle.y(), *base + (arrowRoom - view.height() / 2.0) / zoom));
    return {zoom, middle};
}

std::optional<Framing> widened(const lessons::View &look, const QRectF &now, const QRectF &box, QSizeF view,
                               double least)
{
    const QSizeF inside(view.width() - 2.0 * frameBorder, view.height() - 2.0 * frameBorder);
    QRectF all = now.united(box);
    const std::optional<double> base = baseOf(look);
    if (base && now.top() < *base && *base < now.bottom())
        all.setBottom(std::max(*base, box.bottom()));
    const Framing wide = framingOf(look, all, view, inside.width() / now.width());
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

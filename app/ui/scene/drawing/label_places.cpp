#include "app/ui/scene/drawing/label_places.h"

#include "app/ui/scene/drawing/figure.h"
#include "app/ui/scene/drawing/line_clip.h"
#include "lessons/api/view/view.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr double raster = 8.0;      ///< px between two candidate positions
constexpr double coverCost = 4.0;   ///< px of distance per covered square px
constexpr double shiftCost = 64.0;  ///< covered square px per px that a label is moved into the view
constexpr double strokeWidth = 8.0; ///< px; of a line with its arrow head
/// A smaller advantage of a position can be a rounding error, with which a label would jump from frame to frame. Covered
/// square px, or px.
constexpr double leastGain = 0.01;
constexpr std::size_t mostLinks = 200; ///< of which labels avoid each

/// Returns `box`, moved into `area` as far as it fits.
QRectF movedInto(const QRectF &area, QRectF box)
{
    box.moveLeft(std::max(area.left(), std::min(box.left(), area.right() - box.width())));
    box.moveTop(std::max(area.top(), std::min(box.top(), area.bottom() - box.height())));
    return box;
}

double distanceBetween(QPointF a, QPointF b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

}

double lengthWithin(const QLineF &line, const QRectF &box)
{
    if (std::max(line.x1(), line.x2()) < box.left() || std::min(line.x1(), line.x2()) > box.right() ||
        std::max(line.y1(), line.y2()) < box.top() || std::min(line.y1(), line.y2()) > box.bottom())
        return 0.0; // most lines are far from the box
    const auto part = partWithin(box, line.p1(), line.p2());
    return part ? (part->second - part->first) * line.length() : 0.0;
}

double LabelPlaces::covered(const QRectF &box) const
{
    double area = 0.0;
    for (const QLineF &line : m_strokes)
        area += strokeWidth * lengthWithin(line, box);
    for (const QRectF &other : m_taken) {
        const QRectF both = box.intersected(other);
        if (!both.isEmpty())
            area += both.width() * both.height();
    }
    return area;
}

QRectF LabelPlaces::beside(QPointF anchor, QSizeF size, const QRectF &area)
{
    const double w = size.width();
    const double h = size.height();
    QRectF best;
    double least = std::numeric_limits<double>::infinity();
    for (const double away : {8.0, 20.0, 36.0}) {
        const std::array places{QPointF(away, -h / 2),    QPointF(-w / 2, -h - away),
                                QPointF(-w / 2, away),    QPointF(-w - away, -h / 2),
                                QPointF(away, -h - away), QPointF(away, away),
                                QPointF(-w - away, away), QPointF(-w - away, -h - away)};
        for (const QPointF &place : places) {
            const QRectF box = movedInto(area, {anchor + place, size});
            const double cost = covered(box) + shiftCost * distanceBetween(box.topLeft(), anchor + place);
            if (cost < least - leastGain) {
                least = cost;
                best = box;
            }
        }
    }
    m_taken.push_back(best);
    return best;
}

QRectF LabelPlaces::within(QRectF area, QPointF wanted, QSizeF size)
{
    const auto distance = [&](const QRectF &box) { return distanceBetween(box.topLeft(), wanted); };
    const double right = std::max(area.left(), area.right() - size.width());
    const double bottom = std::max(area.top(), area.bottom() - size.height());
    const QPointF clamped(std::clamp(wanted.x(), area.left(), right),
                          std::clamp(wanted.y(), area.top(), bottom));
    QRectF best(clamped, size);
    double least = coverCost * covered(best) + distance(best);
    const auto attempt = [&](int across, int down) {
        const QPointF place = clamped + raster * QPointF(across, down);
        if (place.x() < area.left() || place.x() > right || place.y() < area.top() || place.y() > bottom)
            return;
        const QRectF box(place, size);
        const double away = distance(box);
        if (away >= least)
            return;
        const double here = coverCost * covered(box) + away;
        if (here < least - leastGain) {
            least = here;
            best = box;
        }
    };
    // Tries ring after ring. A ring whose distance alone costs more than the best position cannot be better.
    const int rings = static_cast<int>(std::max(area.width(), area.height()) / raster);
    for (int ring = 1; ring <= rings && ring * raster < least; ++ring) {
        for (int i = -ring; i <= ring; ++i) {
            attempt(i, -ring);
            attempt(i, ring);
        }
        for (int i = 1 - ring; i < ring; ++i) {
            attempt(-ring, i);
            attempt(ring, i);
        }
    }
    m_taken.push_back(best);
    return best;
}

std::vector<QRectF> bodyBoxes(const SceneContent &shown, const Camera &camera)
{
    std::vector<QRectF> boxes;
    const auto add = [&](int i) {
        if (shown.isHidden(i))
            return;
        const QPointF c = camera.at(shown.state().positionOf(i));
        const double r = camera.radius(shown.radius(i)) + (i == shown.selected ? 6.0 : 1.0);
        boxes.emplace_back(c.x() - r, c.y() - r, 2 * r, 2 * r);
    };
    if (shown.isCrowd() && shown.selected >= 0)
        add(shown.selected);
    for (int i = shown.isCrowd() ? shown.points() : 0; i < shown.points(); ++i)
        add(i);
    return boxes;
}

std::vector<QLineF> linkLines(const SceneContent &shown, const Camera &camera)
{
    const lessons::View &view = shown.view();
    if (view.springs.size() + view.sticks.size() + view.legs.size() > mostLinks)
        return {};
    const sim::State &state = shown.state();
    const auto at = [&](int point) { return camera.at(state.positionOf(point)); };
    std::vector<QLineF> lines;
    for (const lessons::SpringView &spring : view.springs)
        lines.emplace_back(at(spring.a), camera.at(endOf(spring, state)));
    for (const lessons::StickView &stick : view.sticks)
        lines.emplace_back(at(stick.a), at(stick.b));
    for (const lessons::LegView &leg : view.legs)
        lines.emplace_back(at(leg.from), at(leg.to));
    return lines;
}

}

#include "app/ui/scene/label_places.h"

#include <array>
#include <cmath>

namespace app {

namespace {

constexpr double apart = 8.0;     ///< px between an anchor and its label
constexpr double raster = 16.0;   ///< px between two places that are tried
constexpr double coverCost = 4.0; ///< px of distance that a covered square px is worth

}

double LabelPlaces::covered(const QRectF &box) const
{
    double area = 0.0;
    for (const QRectF &other : m_taken) {
        const QRectF both = box.intersected(other);
        if (!both.isEmpty())
            area += both.width() * both.height();
    }
    return area;
}

QRectF LabelPlaces::beside(QPointF anchor, QSizeF size)
{
    const double w = size.width();
    const double h = size.height();
    const std::array places{QPointF(apart, -h / 2),     QPointF(-w / 2, -h - apart),
                            QPointF(-w / 2, apart),     QPointF(-w - apart, -h / 2),
                            QPointF(apart, -h - apart), QPointF(apart, apart),
                            QPointF(-w - apart, apart), QPointF(-w - apart, -h - apart)};
    QRectF best;
    double least = -1.0;
    for (const QPointF &place : places) {
        const QRectF box(anchor + place, size);
        const double cost = covered(box);
        if (least < 0.0 || cost < least) {
            least = cost;
            best = box;
        }
    }
    m_taken.push_back(best);
    return best;
}

QRectF LabelPlaces::within(QRectF area, QPointF wanted, QSizeF size)
{
    const auto cost = [&](const QRectF &box) {
        const QPointF off = box.topLeft() - wanted;
        return coverCost * covered(box) + std::hypot(off.x(), off.y());
    };
    const double right = std::max(area.left(), area.right() - size.width());
    const double bottom = std::max(area.top(), area.bottom() - size.height());
    const QPointF clamped(std::clamp(wanted.x(), area.left(), right),
                          std::clamp(wanted.y(), area.top(), bottom));
    QRectF best(clamped, size);
    double least = cost(best);
    for (double y = area.top(); least > 0.0 && y <= bottom; y += raster) {
        for (double x = area.left(); x <= right; x += raster) {
            const QRectF box(QPointF(x, y), size);
            const double here = cost(box);
            if (here < least) {
                least = here;
                best = box;
            }
        }
    }
    m_taken.push_back(best);
    return best;
}

std::vector<QRectF> bodyBoxes(const Shown &shown, const Camera &camera)
{
    std::vector<QRectF> boxes;
    for (int i = 0; i < shown.points(); ++i) {
        const QPointF c = camera.at(shown.state().at(i));
        const double r = camera.radius(shown.radius(i)) + (i == shown.selected ? 6.0 : 1.0);
        boxes.emplace_back(c.x() - r, c.y() - r, 2 * r, 2 * r);
    }
    return boxes;
}

}

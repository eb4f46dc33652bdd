#include "app/model/picture/arrow_angle.h"

#include <cmath>
#include <numbers>

namespace app {

double ArrowAngle::length() const
{
    return std::hypot(vector().x, vector().y);
}

double ArrowAngle::angle() const
{
    return std::atan2(vector().y, vector().x);
}

double ArrowAngle::cosine() const
{
    return length() > 0.0 ? vector().x / length() : 1.0;
}

double ArrowAngle::sine() const
{
    return length() > 0.0 ? vector().y / length() : 0.0;
}

std::optional<ArrowAngle> arrowAngleOf(const Picture &picture)
{
    if (!picture.interval || !picture.view->angle)
        return std::nullopt;
    const lessons::AngleView &arrow = *picture.view->angle;
    const int count = picture.state.pointCount();
    if (arrow.from >= count || arrow.to >= count)
        return std::nullopt;
    const ArrowAngle found{picture.state.positionOf(arrow.from), arrow.to < 0
                                                                     ? branchEnd(picture, arrow.from)
                                                                     : picture.state.positionOf(arrow.to)};
    return std::isfinite(found.length()) ? std::optional(found) : std::nullopt;
}

sim::Vec2 branchEnd(const Picture &picture, int point)
{
    const sim::Vec2 from = picture.state.positionOf(point);
    const std::optional<lessons::TreeView> &tree = picture.view->tree;
    const auto index = static_cast<std::size_t>(point);
    if (!tree || index >= tree->length.size() || point >= picture.state.angle.rows())
        return from;
    const double angle = picture.state.angle[point] * std::numbers::pi / 180.0;
    return from + tree->length[index] * sim::Vec2{std::cos(angle), std::sin(angle)};
}

}

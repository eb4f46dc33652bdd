#include "looks.h"

#include "lessons/api/acting.h"
#include "plan.h"
#include "sim/effects/ground.h"
#include "sim/effects/room_limits.h"

#include <algorithm>
#include <cmath>

using namespace lessons;

namespace sandbox {

namespace {

constexpr double raster = 50.0; ///< px, in which the stage grows, so that it does not with every move

enum class Part { loose, joint, foot, body };

/// What each point is a part of, as far as it decides how it is drawn.
std::vector<Part> partsOf(const sim::Blueprint &plan)
{
    std::vector<Part> parts(plan.points.size(), Part::loose);
    const auto at = [&](int point) -> Part & { return parts[static_cast<std::size_t>(point)]; };
    for (const sim::BuiltStick &stick : plan.sticks)
        at(stick.a) = at(stick.b) = Part::joint;
    for (const sim::BuiltFoot &foot : plan.feet)
        at(foot.foot) = Part::foot;
    for (const sim::BuiltFoot &foot : plan.feet)
        at(foot.body) = Part::body;
    return parts;
}

BodyLook bodyLook(const sim::BuiltPoint &point, Part part)
{
    BodyLook look;
    look.radius = 0.5 * point.size;
    look.fixed = point.fixed;
    if (part == Part::body)
        look.shape = BodyLook::Shape::body;
    else if (part == Part::joint && point.size <= 12.0)
        look.shape = BodyLook::Shape::joint;
    return look;
}

/// A foot's place is its lowest point, and the disc that is drawn has its middle there. So the ground is drawn where the
/// discs of the feet end.
double footRadius(const Look &look, const sim::Blueprint &plan)
{
    double radius = 0.0;
    for (const sim::BuiltFoot &foot : plan.feet)
        radius = std::max(radius, look.bodies[static_cast<std::size_t>(foot.foot)].radius);
    return radius;
}

QRectF stageOf(const sim::Blueprint &plan, QRectF least)
{
    for (const sim::BuiltPoint &point : plan.points) {
        const double half = 0.5 * point.size;
        least |= QRectF(point.x.x - half, point.x.y - half, point.size, point.size);
    }
    const double left = raster * std::floor(least.left() / raster);
    const double top = raster * std::floor(least.top() / raster);
    return {left, top, std::max(540.0, raster * std::ceil(least.right() / raster) - left),
            std::max(400.0, raster * std::ceil(least.bottom() / raster) - top)};
}

}

Look builtLook(const sim::Scene &scene, const sim::Values &values)
{
    const sim::Blueprint &plan = planOf(values);
    const std::vector<Part> parts = partsOf(plan);
    Look look;
    for (std::size_t i = 0; i < plan.points.size(); ++i)
        look.bodies.push_back(bodyLook(plan.points[i], parts[i]));
    for (const sim::BuiltSpring &spring : plan.springs)
        look.springs.push_back({spring.a, spring.b, spring.length});
    for (const sim::BuiltStick &stick : plan.sticks)
        look.sticks.push_back({stick.a, stick.b, stick.length});
    for (const sim::BuiltFoot &foot : plan.feet)
        look.legs.push_back({foot.body, foot.foot});
    if (effectOf<sim::Walls>(scene) || effectOf<sim::RoomLimits>(scene))
        look.room = roomOf(values);
    if (effectOf<sim::Ground>(scene))
        look.ground = values["ground"] + footRadius(look, plan);
    const auto walker = std::find(parts.begin(), parts.end(), Part::body);
    if (look.ground && !look.room && walker != parts.end()) // an endless ground, to walk along
        look.follow = static_cast<int>(walker - parts.begin());
    look.stage = stageOf(plan, {0.0, 0.0, 540.0, 400.0});
    return look;
}

}

#include "view.h"

#include "lessons/api/view/acting.h"
#include "scenes.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/room_limits.h"

#include <algorithm>
#include <cmath>
#include <map>

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
    for (const sim::BlueprintStick &stick : plan.sticks)
        at(stick.a) = at(stick.b) = Part::joint;
    for (const sim::BlueprintFoot &foot : plan.feet)
        at(foot.foot) = Part::foot;
    for (const sim::BlueprintFoot &foot : plan.feet)
        at(foot.body) = Part::body;
    return parts;
}

BodyView bodyLook(const sim::BlueprintPoint &point, Part part)
{
    BodyView look;
    look.radius = 0.5 * point.size;
    look.fixed = point.fixed;
    if (part == Part::body)
        look.shape = BodyView::Shape::body;
    else if (part == Part::joint && point.size <= 12.0)
        look.shape = BodyView::Shape::joint;
    return look;
}

/// A foot's place is its lowest point, and the disc that is drawn has its middle there. So the ground is drawn where the
/// discs of the feet end.
double footRadius(const View &look, const sim::Blueprint &plan)
{
    double radius = 0.0;
    for (const sim::BlueprintFoot &foot : plan.feet)
        radius = std::max(radius, look.bodies[static_cast<std::size_t>(foot.foot)].radius);
    return radius;
}

using Pair = std::pair<int, int>;

Pair pairOf(int a, int b)
{
    return std::minmax(a, b);
}

/// Twice the area of the triangle a, b, c: positive on one side of the line from a to b.
double side(sim::Vec2 a, sim::Vec2 b, sim::Vec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Springs that cross in the middle of four others make soft matter: a patch each.
class SoftMatter
{
public:
    explicit SoftMatter(const sim::Blueprint &plan) : m_plan(plan), m_neighbours(plan.points.size())
    {
        for (const sim::BlueprintSpring &spring : plan.springs) {
            if (m_uses.try_emplace(pairOf(spring.a, spring.b), 0).second) {
                m_neighbours[static_cast<std::size_t>(spring.a)].push_back(spring.b);
                m_neighbours[static_cast<std::size_t>(spring.b)].push_back(spring.a);
            }
        }
        for (const auto &[pair, uses] : m_uses)
            lookAcross(pair.first, pair.second);
    }

    const std::vector<SheetView> &sheets() const { return m_sheets; }

    SpringView::Part partOf(const sim::BlueprintSpring &spring) const
    {
        const int uses = m_uses.at(pairOf(spring.a, spring.b));
        return uses == 0   ? SpringView::Part::alone
               : uses == 1 ? SpringView::Part::edge
                           : SpringView::Part::inside;
    }

private:
    sim::Vec2 at(int point) const { return m_plan.points[static_cast<std::size_t>(point)].x; }

    /// Takes the patches of which the spring from `a` to `c` is a diagonal, and of all corners `a` is the first.
    void lookAcross(int a, int c)
    {
        for (const int b : m_neighbours[static_cast<std::size_t>(a)]) {
            if (b < a || side(at(a), at(c), at(b)) <= 0.0 || !m_uses.contains(pairOf(b, c)))
                continue;
            for (const int d : m_neighbours[static_cast<std::size_t>(b)]) {
                const bool crosses = d > a && side(at(a), at(c), at(d)) < 0.0 &&
                                     side(at(b), at(d), at(a)) * side(at(b), at(d), at(c)) < 0.0;
                if (crosses && m_uses.contains(pairOf(a, d)) && m_uses.contains(pairOf(c, d)))
                    take({{a, b, c, d}});
            }
        }
    }

    void take(const SheetView &sheet)
    {
        const auto &[a, b, c, d] = sheet.corners;
        for (const Pair &edge : {pairOf(a, b), pairOf(b, c), pairOf(c, d), pairOf(d, a)})
            ++m_uses.at(edge);
        for (const Pair &diagonal : {pairOf(a, c), pairOf(b, d)})
            m_uses.at(diagonal) += 2; // it lies inside
        m_sheets.push_back(sheet);
    }

    const sim::Blueprint &m_plan;
    std::vector<std::vector<int>> m_neighbours; ///< one entry a point
    std::map<Pair, int> m_uses;                 ///< by how many patches each spring is used
    std::vector<SheetView> m_sheets;
};

void addSprings(View &look, const sim::Blueprint &plan)
{
    const SoftMatter matter(plan);
    look.sheets = matter.sheets();
    for (const sim::BlueprintSpring &spring : plan.springs)
        look.springs.push_back(
            {.a = spring.a, .b = spring.b, .length = spring.length, .part = matter.partOf(spring)});
}

QRectF stageOf(const sim::Blueprint &plan, QRectF least)
{
    for (const sim::BlueprintPoint &point : plan.points) {
        const double half = 0.5 * point.size;
        least |= QRectF(point.x.x - half, point.x.y - half, point.size, point.size);
    }
    const double left = raster * std::floor(least.left() / raster);
    const double top = raster * std::floor(least.top() / raster);
    return {left, top, std::max(540.0, raster * std::ceil(least.right() / raster) - left),
            std::max(400.0, raster * std::ceil(least.bottom() / raster) - top)};
}

}

View builtLook(const sim::Scene &scene, const sim::Values &values)
{
    const sim::Blueprint &plan = planOf(values);
    const std::vector<Part> parts = partsOf(plan);
    View look;
    for (std::size_t i = 0; i < plan.points.size(); ++i)
        look.bodies.push_back(bodyLook(plan.points[i], parts[i]));
    addSprings(look, plan);
    for (const sim::BlueprintStick &stick : plan.sticks)
        look.sticks.push_back({stick.a, stick.b, stick.length});
    for (const sim::BlueprintFoot &foot : plan.feet)
        look.legs.push_back({foot.body, foot.foot});
    if (effectOf<sim::Walls>(scene) || effectOf<sim::RoomLimits>(scene))
        look.room = roomOf(values);
    if (effectOf<sim::Ground>(scene))
        look.ground = values["ground"] + footRadius(look, plan);
    const auto walker = std::find(parts.begin(), parts.end(), Part::body);
    if (look.ground && !look.room && walker != parts.end()) // an endless ground, to walk along
        look.followedPoint = static_cast<int>(walker - parts.begin());
    look.stage = stageOf(plan, {0.0, 0.0, 540.0, 400.0});
    return look;
}

}

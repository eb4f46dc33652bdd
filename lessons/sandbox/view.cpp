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

/// px. The stage grows in steps of this size, so that it stays the same when a point moves a little.
constexpr double gridStep = 50.0;

enum class Part { loose, joint, foot, body };

/// Returns the part that decides how each point is drawn.
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

BodyView bodyViewOf(const sim::BlueprintPoint &point, Part part)
{
    BodyView view;
    view.radius = 0.5 * point.size;
    view.fixed = point.fixed;
    if (part == Part::body)
        view.shape = BodyView::Shape::body;
    else if (part == Part::joint && point.size <= 12.0)
        view.shape = BodyView::Shape::joint;
    return view;
}

/// Returns the largest radius of a foot's disc, in px. A foot touches the ground with its position, which is
/// the centre of the disc. The ground is drawn lower by this radius, so that the discs stand on it.
double footRadius(const View &view, const sim::Blueprint &plan)
{
    double radius = 0.0;
    for (const sim::BlueprintFoot &foot : plan.feet)
        radius = std::max(radius, view.bodies[static_cast<std::size_t>(foot.foot)].radius);
    return radius;
}

using Pair = std::pair<int, int>;

Pair pairOf(int a, int b)
{
    return std::minmax(a, b);
}

/// Returns twice the signed area of the triangle a, b, c. Its sign is the side of the line ab on which c
/// lies.
double side(sim::Vec2 a, sim::Vec2 b, sim::Vec2 c)
{
    return (b.x - a.x) * (c.y - a.y) - (b.y - a.y) * (c.x - a.x);
}

/// Finds the soft sheets of a blueprint: four springs round a quadrilateral with springs along both
/// diagonals.
class SoftSheets
{
public:
    explicit SoftSheets(const sim::Blueprint &plan) : m_plan(plan), m_neighbours(plan.points.size())
    {
        for (const sim::BlueprintSpring &spring : plan.springs) {
            if (m_uses.try_emplace(pairOf(spring.a, spring.b), 0).second) {
                m_neighbours[static_cast<std::size_t>(spring.a)].push_back(spring.b);
                m_neighbours[static_cast<std::size_t>(spring.b)].push_back(spring.a);
            }
        }
        for (const auto &[pair, uses] : m_uses)
            addSheetsAcross(pair.first, pair.second);
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

    /// Adds the sheets with the diagonal from `a` to `c` in which `a` is the corner with the smallest index.
    void addSheetsAcross(int a, int c)
    {
        for (const int b : m_neighbours[static_cast<std::size_t>(a)]) {
            if (b < a || side(at(a), at(c), at(b)) <= 0.0 || !m_uses.contains(pairOf(b, c)))
                continue;
            for (const int d : m_neighbours[static_cast<std::size_t>(b)]) {
                const bool crosses = d > a && side(at(a), at(c), at(d)) < 0.0 &&
                                     side(at(b), at(d), at(a)) * side(at(b), at(d), at(c)) < 0.0;
                if (crosses && m_uses.contains(pairOf(a, d)) && m_uses.contains(pairOf(c, d)))
                    addSheet({{a, b, c, d}});
            }
        }
    }

    void addSheet(const SheetView &sheet)
    {
        const auto &[a, b, c, d] = sheet.corners;
        for (const Pair &edge : {pairOf(a, b), pairOf(b, c), pairOf(c, d), pairOf(d, a)})
            ++m_uses.at(edge);
        for (const Pair &diagonal : {pairOf(a, c), pairOf(b, d)})
            m_uses.at(diagonal) += 2; // a diagonal is inside its sheet
        m_sheets.push_back(sheet);
    }

    const sim::Blueprint &m_plan;
    std::vector<std::vector<int>> m_neighbours; ///< one entry per point
    std::map<Pair, int> m_uses; ///< number of sheets along each spring; 2 more per sheet for a diagonal
    std::vector<SheetView> m_sheets;
};

void addSprings(View &view, const sim::Blueprint &plan)
{
    const SoftSheets sheets(plan);
    view.sheets = sheets.sheets();
    for (const sim::BlueprintSpring &spring : plan.springs)
        view.springs.push_back(
            {.a = spring.a, .b = spring.b, .length = spring.length, .part = sheets.partOf(spring)});
}

/// Returns a stage that contains `stage` and all points.
QRectF stageOf(const sim::Blueprint &plan, QRectF stage)
{
    for (const sim::BlueprintPoint &point : plan.points) {
        const double radius = 0.5 * point.size;
        stage |= QRectF(point.x.x - radius, point.x.y - radius, point.size, point.size);
    }
    const double left = gridStep * std::floor(stage.left() / gridStep);
    const double top = gridStep * std::floor(stage.top() / gridStep);
    return {left, top, std::max(540.0, gridStep * std::ceil(stage.right() / gridStep) - left),
            std::max(400.0, gridStep * std::ceil(stage.bottom() / gridStep) - top)};
}

}

View sandboxView(const sim::Scene &scene, const sim::Values &values)
{
    const sim::Blueprint &plan = planOf(values);
    const std::vector<Part> parts = partsOf(plan);
    View view;
    for (std::size_t i = 0; i < plan.points.size(); ++i)
        view.bodies.push_back(bodyViewOf(plan.points[i], parts[i]));
    addSprings(view, plan);
    for (const sim::BlueprintStick &stick : plan.sticks)
        view.sticks.push_back({stick.a, stick.b, stick.length});
    for (const sim::BlueprintRuleLink &link : plan.ruleLinks)
        view.ruleLinks.push_back({link.a, link.b});
    for (const sim::BlueprintFoot &foot : plan.feet)
        view.legs.push_back({foot.body, foot.foot});
    if (effectOf<sim::Walls>(scene) || effectOf<sim::RoomLimits>(scene))
        view.room = roomOf(values);
    if (effectOf<sim::Ground>(scene))
        view.ground = values["ground"] + footRadius(view, plan);
    const auto walker = std::find(parts.begin(), parts.end(), Part::body);
    if (view.ground && !view.room && walker != parts.end()) // a creature that walks on endless ground
        view.followedPoint = static_cast<int>(walker - parts.begin());
    view.stage = stageOf(plan, {0.0, 0.0, 540.0, 400.0});
    return view;
}

}

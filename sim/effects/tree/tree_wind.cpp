#include "sim/effects/tree/tree_wind.h"

#include "sim/base/random.h"
#include "sim/effects/tree/tree_walk.h"
#include "sim/simd/point_kernels.h"

namespace sim {

namespace {

const char *const here = "sim/effects/tree/tree_wind.h";
const char *const tree = "sim/effects/tree/tree.h";

/// Calls `visit` with what says how a branch resists: `strength(resistance, distance, scale)`.
template <class Visit>
auto resisted(Resistance::By by, const Visit &visit)
{
    switch (by) {
    case Resistance::By::distance:
        return visit([](const Resistance &, double distance, double) { return byDistance(distance); });
    case Resistance::By::thickness:
        return visit([](const Resistance &resistance, double distance, double scale) {
            return byThickness(distance, scale, resistance.amount);
        });
    case Resistance::By::ease:
        break;
    }
    return visit([](const Resistance &resistance, double, double) { return resistance.amount; });
}

/// The formulas without the rule for an end that the pointer is on.
struct Corrected
{
    Vec2 pointer;

    BranchWind breeze(Vec2 origin, Vec2 reach, double scale) const
    {
        return windAt(branchEnd(origin, reach, scale), pointer);
    }
    double turn(double angle, double wind, double strength, double h) const
    {
        return bend(angle, wind, strength, h);
    }
};

/// As printed, which has no such rule.
struct AsPrinted
{
    Vec2 pointer;

    BranchWind breeze(Vec2 origin, Vec2 reach, double scale) const
    {
        return windPublished(pointerOffsetPublished(pointer, origin, reach, scale).d);
    }
    double turn(double angle, double wind, double strength, double h) const
    {
        return bendPublished(angle, wind, strength, h);
    }
};

/// The wind at each branch of a run, in the order of the run.
struct Breezes
{
    // These begin without values: each number is written before it is read.
    BranchBuffer reachX, reachY, wind, distance;
};

/// Computes the wind at each branch of `run`, as if the pointer were on no branch's end.
template <class Bend>
void findBreezes(const TreeWalk &walk, State &state, const double *scale, PointRange range,
                 const Bend &bendBy, Breezes &into)
{
    double *reachX = into.reachX.data(), *reachY = into.reachY.data();
    walk.forEachReach(range, [=, first = range.first](int i, Vec2 reach) {
        reachX[i - first] = reach.x;
        reachY[i - first] = reach.y;
    });
    // Two short loops: in a long one a processor could not begin with the next branches early enough.
    dispatch([=, &into, at = XyColumns(state.position)] {
        double *wind = into.wind.data(), *distance = into.distance.data();
        const int first = range.first, count = range.count;
        SIM_TURNS_ARE_APART
        for (int i = 0; i < count; ++i) {
            const BranchWind breeze =
                bendBy.breeze(at.at(first + i), {reachX[i], reachY[i]}, scale[first + i]);
            wind[i] = breeze.wind;
            distance[i] = breeze.distance;
        }
    });
}

}

std::vector<Region> TreeWind::regions(DirectionRule) const
{
    const bool asPrinted = m_formula == TreeFormula::published;
    std::vector<Region> shown = {{tree, "reach"}};
    if (asPrinted)
        shown.insert(shown.end(), {{tree, "sight_published"}, {here, "wind_published"}});
    else
        shown.insert(shown.end(), {{tree, "end"}, {here, "wind"}});
    if (m_turbulence)
        shown.insert(shown.end(), {{here, "turbulence"}, {here, "gusty"}});
    if (m_resistance.by == Resistance::By::distance)
        shown.push_back({here, "by_distance"});
    if (m_resistance.by == Resistance::By::thickness)
        shown.push_back({here, "by_thickness"});
    shown.push_back({here, asPrinted ? "bend_published" : "bend"});
    if (asPrinted)
        shown.push_back({tree, "end"});
    return shown;
}

int TreeWind::count(const State &, PointRange points) const
{
    return points.count;
}

BranchWind TreeWind::breezeAt(TreeFormula formula, int point, Vec2 origin, double angle, Vec2 pointer) const
{
    const double scale = m_tree->scale[static_cast<std::size_t>(point)];
    const Vec2 reach = branchReach(angle, m_tree->baseLength, degreesOf(formula));
    if (formula == TreeFormula::published)
        return windPublished(pointerOffsetPublished(pointer, origin, reach, scale).d);
    return windAt(branchEnd(origin, reach, scale), pointer, point);
}

double TreeWind::gustNow(const State &state) const
{
    if (!m_turbulence)
        return 0.0;
    if (state.input.gust)
        return *state.input.gust;
    const auto frame = static_cast<std::uint64_t>(state.frame);
    return gustOf(m_turbulence->degrees, uniform(m_turbulence->seed, frame, 0));
}

double TreeWind::strength(double distance, int point) const
{
    const double scale = m_tree->scale[static_cast<std::size_t>(point)];
    return resisted(m_resistance.by, [&](auto strength) { return strength(m_resistance, distance, scale); });
}

template <class Bend>
void TreeWind::bendAll(State &state, double h, const Bend &bendBy) const
{
    const double gust = gustNow(state), *scale = m_tree->scale.data();
    double *angle = state.angle.data();
    TreeWalk walk(*m_tree, state, degreesOf(m_formula));
    Breezes breezes;
    for (PointRange range = walk.next({}); range.count > 0; range = walk.next(range)) {
        findBreezes(walk, state, scale, range, bendBy, breezes);
        const int first = range.first;
        double *wind = breezes.wind.data(), *distance = breezes.distance.data();
        for (int i = 0; i < range.count; ++i) {
            const int branch = first + i;
            if (distance[i] < coincidenceDistance)
                wind[i] =
                    breezeAt(m_formula, branch, state.positionOf(branch), angle[branch], *state.input.pointer)
                        .wind;
        }
        resisted(m_resistance.by, [&](auto strengthOf) {
            updateDynamic(state.inverseMass, range, angle, [=, resistance = m_resistance](int branch) {
                const int i = branch - first;
                const double strength = strengthOf(resistance, distance[i], scale[branch]);
                return bendBy.turn(angle[branch], gusty(wind[i], gust), strength, h);
            });
        });
        walk.moveChildren(range);
    }
}

void TreeWind::drive(State &state, double h) const
{
    if (!blows(state))
        return;
    if (m_formula == TreeFormula::published)
        bendAll(state, h, AsPrinted{*state.input.pointer});
    else
        bendAll(state, h, Corrected{*state.input.pointer});
}

std::vector<LiveValue> TreeWind::explain(const State &before, const State &after, int point) const
{
    if (!blows(after) || !after.isDynamic(point))
        return {};
    // In this phase the branch was moved first and turned then.
    const BranchWind breeze =
        breezeAt(m_formula, point, after.positionOf(point), before.angle[point], *after.input.pointer);
    const double gust = gustNow(after);
    std::vector<LiveValue> live = {{"d", breeze.d, {}}, {"distance", breeze.distance, {}}};
    if (m_turbulence)
        live.push_back({"gust", gust, {}});
    live.push_back({"wind", gusty(breeze.wind, gust), {}});
    live.push_back({"strength", strength(breeze.distance, point), {}});
    live.push_back({"angle", after.angle[point], before.angle[point]});
    return live;
}

namespace descriptions {
constinit const EffectDescription wind = {
    "wind", SIM_TEXT("wind"), EffectKind::wind,
    SIM_TEXT("Turns the branches away from the pointer while its button is down.")};
}

}

#include "sim/effects/tree/tree_wind.h"

#include "sim/base/random.h"
#include "sim/effects/tree/tree_walk.h"
#include "sim/simd/point_kernels.h"

namespace sim {

namespace {

const char *const windHeader = "sim/effects/tree/tree_wind.h";
const char *const treeHeader = "sim/effects/tree/tree.h";

/// Calls `visit` with the resistance formula: `strength(resistance, distance, scale)`. So the choice of the
/// formula stays outside the loop over branches.
template <class Visit>
auto withStrengthFormula(Resistance::By by, const Visit &visit)
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

/// The corrected formulas, for ends that do not coincide with the pointer.
struct Corrected
{
    Vec2 pointer;

    BranchWind windOn(Vec2 origin, Vec2 reach, double scale) const
    {
        return windAt(branchEnd(origin, reach, scale), pointer);
    }
    double turn(double angle, double wind, double strength, double h) const
    {
        return bend(angle, wind, strength, h);
    }
};

/// The published formulas.
struct Published
{
    Vec2 pointer;

    BranchWind windOn(Vec2 origin, Vec2 reach, double scale) const
    {
        return windPublished(pointerOffsetPublished(pointer, origin, reach, scale).d);
    }
    double turn(double angle, double wind, double strength, double h) const
    {
        return bendPublished(angle, wind, strength, h);
    }
};

/// The reach of each branch of a batch, and the wind at it.
struct BatchWind
{
    // Uninitialised: each number is written before it is read.
    BranchBuffer reachX, reachY, wind, distance;
};

/// Computes the wind at each branch of `range`, as if no branch's end coincided with the pointer.
template <class Formula>
void computeBatchWind(const TreeWalk &walk, State &state, const double *scale, PointRange range,
                      const Formula &formula, BatchWind &result)
{
    double *reachX = result.reachX.data(), *reachY = result.reachY.data();
    walk.forEachReach(range, [=, first = range.first](int i, Vec2 reach) {
        reachX[i - first] = reach.x;
        reachY[i - first] = reach.y;
    });
    // A second short loop: after one long loop the processor could not start the next batch early enough.
    dispatch([=, &result, position = XyColumns(state.position)] {
        double *wind = result.wind.data(), *distance = result.distance.data();
        const int first = range.first, count = range.count;
        SIM_INDEPENDENT_ITERATIONS
        for (int i = 0; i < count; ++i) {
            const BranchWind branchWind =
                formula.windOn(position.at(first + i), {reachX[i], reachY[i]}, scale[first + i]);
            wind[i] = branchWind.wind;
            distance[i] = branchWind.distance;
        }
    });
}

}

std::vector<Region> TreeWind::regions(DirectionRule) const
{
    const bool isPublished = m_formula == TreeFormula::published;
    std::vector<Region> shown = {{treeHeader, "reach"}};
    if (isPublished)
        shown.insert(shown.end(), {{treeHeader, "pointer_offset_published"}, {windHeader, "wind_published"}});
    else
        shown.insert(shown.end(), {{treeHeader, "end"}, {windHeader, "wind"}});
    if (m_turbulence)
        shown.insert(shown.end(), {{windHeader, "turbulence"}, {windHeader, "gusty"}});
    if (m_resistance.by == Resistance::By::distance)
        shown.push_back({windHeader, "by_distance"});
    if (m_resistance.by == Resistance::By::thickness)
        shown.push_back({windHeader, "by_thickness"});
    shown.push_back({windHeader, isPublished ? "bend_published" : "bend"});
    if (isPublished)
        shown.push_back({treeHeader, "end"});
    return shown;
}

int TreeWind::count(const State &, PointRange points) const
{
    return points.count;
}

BranchWind TreeWind::windOn(TreeFormula formula, int point, Vec2 origin, double angle, Vec2 pointer) const
{
    const double scale = m_tree->scaleOf(point);
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
    return gustOf(m_turbulence->degrees, uniform(m_turbulence->seed, state.frame, 0));
}

double TreeWind::strength(double distance, int point) const
{
    const double scale = m_tree->scaleOf(point);
    return withStrengthFormula(m_resistance.by, [&](auto strengthFormula) {
        return strengthFormula(m_resistance, distance, scale);
    });
}

template <class Formula>
void TreeWind::bendTree(State &state, double h, const Formula &formula) const
{
    const double gust = gustNow(state), *scale = m_tree->scale.data();
    double *angle = state.angle.data();
    TreeWalk walk(*m_tree, state, degreesOf(m_formula));
    BatchWind batchWind;
    for (PointRange range = walk.next({}); range.count > 0; range = walk.next(range)) {
        computeBatchWind(walk, state, scale, range, formula, batchWind);
        const int first = range.first;
        double *wind = batchWind.wind.data(), *distance = batchWind.distance.data();
        for (int i = 0; i < range.count; ++i) {
            const int branch = first + i;
            if (distance[i] < coincidenceDistance)
                wind[i] =
                    windOn(m_formula, branch, state.positionOf(branch), angle[branch], *state.input.pointer)
                        .wind;
        }
        withStrengthFormula(m_resistance.by, [&](auto strengthFormula) {
            updateDynamic(state.inverseMass, range, angle, [=, resistance = m_resistance](int branch) {
                const int i = branch - first;
                const double strength = strengthFormula(resistance, distance[i], scale[branch]);
                return formula.turn(angle[branch], gusty(wind[i], gust), strength, h);
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
        bendTree(state, h, Published{*state.input.pointer});
    else
        bendTree(state, h, Corrected{*state.input.pointer});
}

std::vector<LiveValue> TreeWind::explain(const State &before, const State &after, int point) const
{
    if (!blows(after) || !after.isDynamic(point))
        return {};
    // In this phase the branch was moved before it was turned.
    const BranchWind branchWind =
        windOn(m_formula, point, after.positionOf(point), before.angle[point], *after.input.pointer);
    const double gust = gustNow(after);
    std::vector<LiveValue> live = {{"d", branchWind.d, {}}, {"distance", branchWind.distance, {}}};
    if (m_turbulence)
        live.push_back({"gust", gust, {}});
    live.push_back({"wind", gusty(branchWind.wind, gust), {}});
    live.push_back({"strength", strength(branchWind.distance, point), {}});
    live.push_back({"angle", after.angle[point], before.angle[point]});
    return live;
}

namespace descriptions {
constinit const EffectDescription wind = {
    "wind", SIM_TEXT("wind"), EffectKind::wind,
    SIM_TEXT("Turns the branches away from the pointer while its button is down.")};
}

}

#include "sim/effects/tree_wind.h"

#include "sim/random.h"

namespace sim {

namespace {

/// The pointer has no number among the points.
constexpr int pointerNumber = -1;

const char *const here = "sim/effects/tree_wind.h";
const char *const tree = "sim/effects/tree.h";

}

std::vector<Region> TreeWind::regions(Directions) const
{
    const bool asPrinted = m_formula == TreeFormula::published;
    std::vector<Region> shown = {{tree, "reach"}};
    if (asPrinted)
        shown.insert(shown.end(), {{tree, "sight_published"}, {here, "wind_published"}});
    else
        shown.insert(shown.end(), {{tree, "end"}, {"sim/direction.h", "direction"}, {here, "wind"}});
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

int TreeWind::count(const State &, Points points) const
{
    return points.count;
}

Breeze TreeWind::breezeAt(TreeFormula formula, int point, Vec2 origin, double angle, Vec2 pointer) const
{
    const double scale = m_tree->scale[static_cast<std::size_t>(point)];
    const Vec2 reach = branchReach(angle, m_tree->baseLength, degreesOf(formula));
    if (formula == TreeFormula::published)
        return windPublished(sightPublished(pointer, origin, reach, scale).d);
    return windAt(branchEnd(origin, reach, scale), pointer,
                  [point](Vec2 d) { return direction(d, pointerNumber, point); });
}

double TreeWind::gustNow(const State &state) const
{
    if (!m_turbulence)
        return 0.0;
    if (state.outside.gust)
        return *state.outside.gust;
    const auto frame = static_cast<std::uint64_t>(state.frame);
    return gustOf(m_turbulence->degrees, uniform(m_turbulence->seed, frame, 0));
}

double TreeWind::strength(double distance, int point) const
{
    switch (m_resistance.by) {
    case Resistance::By::distance:
        return byDistance(distance);
    case Resistance::By::thickness:
        return byThickness(distance, m_tree->scale[static_cast<std::size_t>(point)], m_resistance.amount);
    case Resistance::By::ease:
        break;
    }
    return m_resistance.amount;
}

void TreeWind::drive(State &state, double h) const
{
    if (!blows(state))
        return;
    const Vec2 pointer = *state.outside.pointer;
    const double gust = gustNow(state);
    const auto turn = m_formula == TreeFormula::published ? bendPublished : bend;
    fromTheTrunk(*m_tree, state, degreesOf(m_formula), [&](int i) {
        const Breeze breeze = breezeAt(m_formula, i, state.at(i), state.angle[i], pointer);
        state.angle[i] = turn(state.angle[i], gusty(breeze.wind, gust), strength(breeze.distance, i), h);
    });
}

std::vector<Live> TreeWind::explain(const State &before, const State &after, int point) const
{
    if (!blows(after) || !after.feels(point))
        return {};
    // In this phase the branch was moved first and turned then.
    const Breeze breeze =
        breezeAt(m_formula, point, after.at(point), before.angle[point], *after.outside.pointer);
    const double gust = gustNow(after);
    std::vector<Live> live = {{"d", breeze.d, {}}, {"distance", breeze.distance, {}}};
    if (m_turbulence)
        live.push_back({"gust", gust, {}});
    live.push_back({"wind", gusty(breeze.wind, gust), {}});
    live.push_back({"strength", strength(breeze.distance, point), {}});
    live.push_back({"angle", after.angle[point], before.angle[point]});
    return live;
}

}

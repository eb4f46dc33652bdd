#include "sim/effects/tree_wind.h"

#include "sim/effects/tree_walk.h"
#include "sim/free_points.h"
#include "sim/random.h"

namespace sim {

namespace {

/// The pointer has no number among the points.
constexpr int pointerNumber = -1;

const char *const here = "sim/effects/tree_wind.h";
const char *const tree = "sim/effects/tree.h";

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
        return windAt(branchEnd(origin, reach, scale), pointer, [](Vec2 d) { return direction(d); });
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
        return windPublished(sightPublished(pointer, origin, reach, scale).d);
    }
    double turn(double angle, double wind, double strength, double h) const
    {
        return bendPublished(angle, wind, strength, h);
    }
};

/// How the wind comes to each branch of `run`, whose reach is found. Returns whether the pointer is on no end.
template <class Bend>
bool findBreeze(const TreeWalk &walk, const State &state, const double *scales, Points run,
                const Bend &bendBy, TreeRow &wind, TreeRow &distance)
{
    std::int64_t close = 0;
    runFast([&, bendBy] {
        const double *x = state.position.data() + run.first, *y = x + state.position.rows();
        const double *reachX = walk.reachX().data(), *reachY = walk.reachY().data();
        const double *scale = scales + run.first;
        double *to = wind.data(), *far = distance.data();
        std::int64_t any = 0;
        const int count = run.count;
        SIM_TURNS_ARE_APART
        for (int i = 0; i < count; ++i) {
            const BranchWind breeze = bendBy.breeze({x[i], y[i]}, {reachX[i], reachY[i]}, scale[i]);
            to[i] = breeze.wind;
            far[i] = breeze.distance;
            any |= breeze.distance < inOnePlace ? std::int64_t{1} : std::int64_t{0};
        }
        close = any;
    });
    return close == 0;
}

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

BranchWind TreeWind::breezeAt(TreeFormula formula, int point, Vec2 origin, double angle, Vec2 pointer) const
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
    const double scale = m_tree->scale[static_cast<std::size_t>(point)];
    return resisted(m_resistance.by, [&](auto strength) { return strength(m_resistance, distance, scale); });
}

double TreeWind::turned(const State &state, int i, double gust, double h) const
{
    const auto turn = m_formula == TreeFormula::published ? bendPublished : bend;
    const BranchWind breeze = breezeAt(m_formula, i, state.at(i), state.angle[i], *state.outside.pointer);
    return turn(state.angle[i], gusty(breeze.wind, gust), strength(breeze.distance, i), h);
}

template <class Bend>
void TreeWind::bendAll(State &state, double h, const Bend &bendBy) const
{
    const double gust = gustNow(state);
    TreeWalk walk(*m_tree, state, degreesOf(m_formula));
    TreeRow wind, distance, angle; // what they hold has been written before
    for (Points run = walk.next({}); run.count > 0; run = walk.next(run)) {
        walk.findReach(run);
        const bool isSure = findBreeze(walk, state, m_tree->scale.data(), run, bendBy, wind, distance);
        const auto turnAll = [&](auto strengthOf) {
            runFast([&, bendBy, gust, h, resistance = m_resistance] {
                const double *old = state.angle.data() + run.first, *scale = m_tree->scale.data() + run.first;
                const double *to = wind.data(), *far = distance.data();
                double *into = angle.data();
                const int count = run.count;
                SIM_TURNS_ARE_APART
                for (int i = 0; i < count; ++i) {
                    const double strength = strengthOf(resistance, far[i], scale[i]);
                    into[i] = bendBy.turn(old[i], gusty(to[i], gust), strength, h);
                }
            });
        };
        resisted(m_resistance.by, turnAll);
        for (int i = 0; !isSure && i < run.count; ++i)
            angle[static_cast<std::size_t>(i)] = turned(state, run.first + i, gust, h);
        replaceFree(state.inverseMass, run, state.angle.data(),
                    [from = angle.data(), first = run.first](int i) { return from[i - first]; });
        walk.carry(run);
    }
}

void TreeWind::drive(State &state, double h) const
{
    if (!blows(state))
        return;
    if (m_formula == TreeFormula::published)
        bendAll(state, h, AsPrinted{*state.outside.pointer});
    else
        bendAll(state, h, Corrected{*state.outside.pointer});
}

std::vector<Live> TreeWind::explain(const State &before, const State &after, int point) const
{
    if (!blows(after) || !after.feels(point))
        return {};
    // In this phase the branch was moved first and turned then.
    const BranchWind breeze =
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

namespace described {
constinit const Description wind = {
    "wind", SIM_TEXT("wind"), Kind::wind,
    SIM_TEXT("Turns the branches away from the pointer while its button is down.")};
}

}

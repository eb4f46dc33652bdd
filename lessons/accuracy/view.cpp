#include "view.h"

#include "lessons/api/view/look.h"
#include "scenes.h"
#include "sim/pipeline/method.h"
#include "sim/run/script/script.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>
#include <limits>

using namespace lessons;
using sim::Scene;
using sim::Script;
using sim::State;
using sim::Values;

namespace accuracy {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Accuracy)
};

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();
constexpr double leastShown = 0.05; ///< px: a shorter distance has no line

}

double energyOf(const Scene &, const State &state, const Values &values)
{
    const double moving = 0.5 * std::pow(sim::length(state.speed(foot)), 2);
    if (values.has("gravity"))
        return moving + values["gravity"] * (values["floor"] - ballRadius - state.at(foot).y);
    return moving + 0.5 * values["k"] * std::pow(sim::length(state.at(foot) - centre), 2);
}

double energyDrift(ExactRun &exact, const Script &script, const Scene &scene, const State &state,
                   const Values &values)
{
    const State *right = exact.at(script, state.frame);
    if (!right)
        return nothing;
    const double should = energyOf(scene, *right, values);
    constexpr double hardlyAny = 1e-6;
    return should > hardlyAny ? 100.0 * (energyOf(scene, state, values) / should - 1.0) : nothing;
}

double computations(const Script &script, const State &state, const State *before)
{
    if (script.step.adaptive())
        return before ? state.turns() - before->turns() : nothing;
    return double(script.method->evaluations()) * script.step.perRow / script.step.rowFrames;
}

double lastStep(const State &state)
{
    double shortest = nothing;
    for (const sim::Ahead &ahead : state.ahead)
        shortest = std::fmin(shortest, ahead.length);
    return shortest;
}

Measure offMeasure(const Exact &exact)
{
    Measure measure = {Text::tr("Off by"),
                       Text::tr("px"),
                       Text::tr("How far the point that is worst off is from its exact place."),
                       4,
                       {}};
    measure.ofRun = [exact](const Script &script, const Scene &, const State &state, const State *,
                            const Values &) { return exact->distance(script, state, state.frame); };
    return measure;
}

Measure driftMeasure(const Exact &exact)
{
    Measure measure = {Text::tr("Energy drift"),
                       Text::tr("%"),
                       Text::tr("How much more energy there is than in the exact motion at this moment."),
                       2,
                       {}};
    measure.ofRun = [exact](const Script &script, const Scene &scene, const State &state, const State *,
                            const Values &values) {
        return energyDrift(*exact, script, scene, state, values);
    };
    return measure;
}

Measure stepMeasure()
{
    Measure measure = {Text::tr("Its step"),
                       Text::tr("frames"),
                       Text::tr("How much time the method took at once, the last time."),
                       3,
                       {}};
    measure.ofRun = [](const Script &script, const Scene &, const State &state, const State *before,
                       const Values &) {
        return !script.step.adaptive() ? script.step.h : before ? lastStep(state) : nothing;
    };
    return measure;
}

Measure computationsMeasure()
{
    Measure measure = {Text::tr("Computations"),
                       Text::tr("a frame"),
                       Text::tr("How often all forces were computed for this frame: that is the work."),
                       1,
                       {}};
    measure.ofRun = [](const Script &script, const Scene &, const State &state, const State *before,
                       const Values &) { return computations(script, state, before); };
    return measure;
}

std::vector<Guide> exactMarks(ExactRun &exact, const Look &look, const Script &script, const State &state,
                              std::int64_t frame)
{
    const State *right = exact.at(script, frame);
    if (!right || right->points() != state.points())
        return {};
    std::vector<Guide> marks;
    std::size_t worst = 0;
    int farthest = -1;
    double distance = leastShown;
    for (int i = 0; i < state.points(); ++i) {
        if (!state.feels(i)) // it is wherever it was put
            continue;
        const double away = sim::length(state.at(i) - right->at(i));
        if (away >= distance) {
            worst = marks.size();
            farthest = i;
            distance = away;
        }
        marks.push_back({Guide::Shape::ring,
                         right->at(i),
                         {},
                         look.bodies[static_cast<std::size_t>(i)].radius,
                         {},
                         Guide::About::exactMotion});
    }
    if (farthest >= 0) {
        marks[worst].label = Text::tr("%1 px off").arg(QLocale().toString(distance, 'f', 1));
        marks.push_back({Guide::Shape::line,
                         state.at(farthest),
                         right->at(farthest),
                         0.0,
                         {},
                         Guide::About::exactMotion});
    }
    return marks;
}

std::vector<Guide> turningPlaces(const Scene &scene, const State &, const Values &)
{
    const sim::Vec2 start = scene.start.at(foot);
    return {{Guide::Shape::cross, centre, {}, 0.0, {}},
            {Guide::Shape::cross, start, {}, 0.0, {}},
            {Guide::Shape::cross, centre + (centre - start), {}, 0.0, {}}};
}

std::vector<Guide> turningRings(const Scene &scene, const State &state, const Values &values)
{
    const sim::Vec2 middle = state.at(1);
    return {{Guide::Shape::ring, middle, {}, values["radius"], {}},
            {Guide::Shape::ring, middle, {}, sim::length(scene.start.at(foot) - scene.start.at(1)), {}}};
}

}

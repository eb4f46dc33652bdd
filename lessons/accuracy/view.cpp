#include "view.h"

#include "lessons/api/view/acting.h"
#include "lessons/api/view/creature_view.h"
#include "scenes.h"
#include "sim/effects/contacts/walls.h"
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

View smallMiddle(const Scene &scene, const Values &)
{
    View look = creatureView(scene);
    look.bodies[1] = {BodyView::Shape::joint, 4.0}; // so that what happens there is seen
    look.springs = actingSprings(scene);
    return look;
}

View ballLook(const Values &values)
{
    View look;
    look.bodies = {{BodyView::Shape::body, ballRadius}};
    look.room = sim::Room{values["left"], values["right"], values["floor"], values["bounce"]};
    return look;
}

View ballInRoom(const Scene &scene, const Values &values)
{
    View look = ballLook(values);
    if (!effectOf<sim::Walls>(scene))
        look.room.reset();
    return look;
}

View crowdInRoom(const Scene &scene, const Values &values)
{
    const int count = values.integer("creatures");
    View look = crowdByPartsView(scene, count);
    const sim::Room room = crowd::roomFor(count);
    const double border = 20.0;
    const double high = crowd::heightFor(count) + border;
    if (hasEffectOfKind(scene, sim::EffectKind::contact))
        look.room = room;
    look.stage = {room.left - border, room.floor - high, room.right - room.left + 2.0 * border,
                  high + border};
    return look;
}

double energyOf(const Scene &, const State &state, const Values &values)
{
    const double moving = 0.5 * std::pow(sim::length(state.velocityOf(foot)), 2);
    if (values.has("gravity"))
        return moving + values["gravity"] * (values["floor"] - ballRadius - state.positionOf(foot).y);
    return moving + 0.5 * values["k"] * std::pow(sim::length(state.positionOf(foot) - centre), 2);
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
    if (script.step.isAdaptive())
        return before ? state.forceEvaluations() - before->forceEvaluations() : nothing;
    return double(script.method->evaluationsPerStep()) * script.step.stepsPerOutput /
           script.step.framesPerOutput;
}

double lastStep(const State &state)
{
    double shortest = nothing;
    for (const sim::AdaptiveStep &lastStep : state.adaptiveSteps)
        shortest = std::fmin(shortest, lastStep.length);
    return shortest;
}

Measure offMeasure(const Exact &exact)
{
    return {
        .name = Text::tr("Off by"),
        .unit = Text::tr("px"),
        .help = Text::tr("How far the point that is worst off is from its exact place."),
        .decimals = 4,
        .ofRun = [exact](const Script &script, const Scene &, const State &state, const State *,
                         const Values &) { return exact->distance(script, state, state.frame); },
    };
}

Measure driftMeasure(const Exact &exact)
{
    return {
        .name = Text::tr("Energy drift"),
        .unit = Text::tr("%"),
        .help = Text::tr("How much more energy there is than in the exact motion at this moment."),
        .decimals = 2,
        .ofRun = [exact](const Script &script, const Scene &scene, const State &state, const State *,
                         const Values &values) { return energyDrift(*exact, script, scene, state, values); },
    };
}

Measure stepMeasure()
{
    return {
        .name = Text::tr("Its step"),
        .unit = Text::tr("frames"),
        .help = Text::tr("How much time the method took at once, the last time."),
        .decimals = 3,
        .ofRun =
            [](const Script &script, const Scene &, const State &state, const State *before, const Values &) {
                return !script.step.isAdaptive() ? script.step.h : before ? lastStep(state) : nothing;
            },
    };
}

Measure computationsMeasure()
{
    return {
        .name = Text::tr("Computations"),
        .unit = Text::tr("a frame"),
        .help = Text::tr("How often all forces were computed for this frame: that is the work."),
        .decimals = 1,
        .ofRun = [](const Script &script, const Scene &, const State &state, const State *before,
                    const Values &) { return computations(script, state, before); },
    };
}

std::vector<Overlay> exactMarks(ExactRun &exact, const View &look, const Script &script, const State &state,
                                std::int64_t frame)
{
    const State *right = exact.at(script, frame);
    if (!right || right->pointCount() != state.pointCount())
        return {};
    std::vector<Overlay> marks;
    std::size_t worst = 0;
    int farthest = -1;
    double distance = leastShown;
    for (int i = 0; i < state.pointCount(); ++i) {
        if (!state.isDynamic(i)) // it is wherever it was put
            continue;
        const double away = sim::length(state.positionOf(i) - right->positionOf(i));
        if (away >= distance) {
            worst = marks.size();
            farthest = i;
            distance = away;
        }
        marks.push_back({.shape = Overlay::Shape::ring,
                         .a = right->positionOf(i),
                         .size = look.bodies[static_cast<std::size_t>(i)].radius,
                         .about = Overlay::About::exactMotion});
    }
    if (farthest >= 0) {
        marks[worst].label = Text::tr("%1 px off").arg(QLocale().toString(distance, 'f', 1));
        marks.push_back({.shape = Overlay::Shape::line,
                         .a = state.positionOf(farthest),
                         .b = right->positionOf(farthest),
                         .about = Overlay::About::exactMotion});
    }
    return marks;
}

std::vector<Overlay> turningPlaces(const Scene &scene, const State &, const Values &)
{
    const sim::Vec2 start = scene.start.positionOf(foot);
    return {{.shape = Overlay::Shape::cross, .a = centre},
            {.shape = Overlay::Shape::cross, .a = start},
            {.shape = Overlay::Shape::cross, .a = centre + (centre - start)}};
}

std::vector<Overlay> turningRings(const Scene &scene, const State &state, const Values &values)
{
    const sim::Vec2 middle = state.positionOf(1);
    return {{.shape = Overlay::Shape::ring, .a = middle, .size = values["radius"]},
            {.shape = Overlay::Shape::ring,
             .a = middle,
             .size = sim::length(scene.start.positionOf(foot) - scene.start.positionOf(1))}};
}

}

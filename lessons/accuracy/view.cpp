#include "view.h"

#include "lessons/accuracy/text.h"
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

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();
constexpr double minShown = 0.05; ///< px, smallest error that is shown with a line

}

View smallBodyView(const Scene &scene, const Values &)
{
    View view = creatureView(scene);
    view.bodies[1] = {BodyView::Shape::joint, 4.0};
    view.springs = actingSprings(scene);
    return view;
}

View ballView(const Values &values)
{
    View view;
    view.bodies = {{BodyView::Shape::body, ballRadius}};
    view.room = sim::Room{values["left"], values["right"], values["floor"], values["bounce"]};
    return view;
}

View ballInRoomView(const Scene &scene, const Values &values)
{
    View view = ballView(values);
    if (!effectOf<sim::Walls>(scene))
        view.room.reset();
    return view;
}

View crowdView(const Scene &scene, const Values &values)
{
    const int count = values.integer("creatures");
    View view = crowdByPartsView(scene, count);
    const sim::Room room = crowd::roomFor(count);
    const double border = 20.0;
    const double height = crowd::heightFor(count) + border;
    if (hasEffectOfKind(scene, sim::EffectKind::contact))
        view.room = room;
    view.stage = {room.left - border, room.floor - height, room.right - room.left + 2.0 * border,
                  height + border};
    return view;
}

double energyOf(const Scene &, const State &state, const Values &values)
{
    const double kinetic = 0.5 * std::pow(sim::length(state.velocityOf(foot)), 2);
    if (values.has("gravity"))
        return kinetic + values["gravity"] * (values["floor"] - ballRadius - state.positionOf(foot).y);
    return kinetic + 0.5 * values["k"] * std::pow(sim::length(state.positionOf(foot) - centre), 2);
}

double energyDrift(ExactRun &exact, const Script &script, const Scene &scene, const State &state,
                   const Values &values)
{
    const State *exactState = exact.at(script, state.frame);
    if (!exactState)
        return undefined;
    const double exactEnergy = energyOf(scene, *exactState, values);
    constexpr double negligible = 1e-6;
    return exactEnergy > negligible ? 100.0 * (energyOf(scene, state, values) / exactEnergy - 1.0)
                                    : undefined;
}

double forceEvaluations(const Script &script, const State &state, const State *before)
{
    if (script.step.isAdaptive())
        return before ? state.forceEvaluations() - before->forceEvaluations() : undefined;
    return double(script.method->evaluationsPerStep()) * script.step.stepsPerOutput /
           script.step.framesPerOutput;
}

double lastStep(const State &state)
{
    double shortest = undefined;
    for (const sim::AdaptiveStep &lastStep : state.adaptiveSteps)
        shortest = std::fmin(shortest, lastStep.length);
    return shortest;
}

Measure errorMeasure(const Exact &exact)
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
                return !script.step.isAdaptive() ? script.step.h : before ? lastStep(state) : undefined;
            },
    };
}

Measure forceEvaluationsMeasure()
{
    return {
        .name = Text::tr("Computations"),
        .unit = Text::tr("a frame"),
        .help = Text::tr("How often all forces were computed for this frame: that is the work."),
        .decimals = 1,
        .ofRun = [](const Script &script, const Scene &, const State &state, const State *before,
                    const Values &) { return forceEvaluations(script, state, before); },
    };
}

std::vector<Overlay> exactOverlays(ExactRun &exact, const View &view, const Script &script,
                                   const State &state, std::int64_t frame)
{
    const State *exactState = exact.at(script, frame);
    if (!exactState || exactState->pointCount() != state.pointCount())
        return {};
    std::vector<Overlay> overlays;
    std::size_t worstOverlay = 0;
    int farthest = -1;
    double distance = minShown;
    for (int i = 0; i < state.pointCount(); ++i) {
        if (!state.isDynamic(i)) // its position has no error
            continue;
        const double error = sim::length(state.positionOf(i) - exactState->positionOf(i));
        if (error >= distance) {
            worstOverlay = overlays.size();
            farthest = i;
            distance = error;
        }
        overlays.push_back({.shape = Overlay::Shape::ring,
                            .a = exactState->positionOf(i),
                            .size = view.bodies[static_cast<std::size_t>(i)].radius,
                            .about = Overlay::About::exactMotion});
    }
    if (farthest >= 0) {
        // A run that has flown away is too far off for all its digits.
        const QString far =
            distance < 1e6 ? QLocale().toString(distance, 'f', 1) : QLocale().toString(distance, 'g', 2);
        overlays[worstOverlay].label = Text::tr("%1 px off").arg(far);
        overlays.push_back({.shape = Overlay::Shape::line,
                            .a = state.positionOf(farthest),
                            .b = exactState->positionOf(farthest),
                            .about = Overlay::About::exactMotion});
    }
    return overlays;
}

std::vector<Overlay> turningPoints(const Scene &scene, const State &, const Values &)
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

#include "sim/catalogue/claims.h"

#include "sim/analysis/accuracy/study_run.h"
#include "sim/catalogue/number_text.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/methods/adaptive/adaptive_stepper.h"
#include "sim/pipeline/pipeline.h"
#include "sim/simd/flush_denormals.h"

#include <algorithm>
#include <cmath>

namespace sim {

namespace {

/// An adaptive method stops a run if a frame exceeds the step budget (see StepBudget). It claims cases that
/// should need at most this fraction of the budget.
constexpr double maxBudgetShare = 0.5;
/// Number of steps in which an adaptive method locates a bounce.
constexpr double stepsPerBounce = 4.0;
/// The errors of adaptive steps keep a resting scene in motion. The amplitude is up to this many tolerances,
/// because the errors of several steps add up.
constexpr double restDisturbance = 10.0;

/// Returns a claim that is not made, with the reason `id`.
Claim declined(const char *id, const Method &method, std::map<std::string, std::string> values)
{
    values["method"] = method.id();
    return {false, Error(id, std::move(values))};
}

/// Returns whether `requirement` is one of Method::requirements().
bool hasRequirement(const Method &method, const char *requirement)
{
    const std::vector<std::string> all = method.requirements();
    return std::find(all.begin(), all.end(), requirement) != all.end();
}

/// Returns a scene of the spring on the x axis. Each end has its own group, like the feet and body of a
/// creature.
Scene sceneOf(const StiffestSpring &stiffest)
{
    Scene scene;
    scene.start = State::ofPoints(2);
    scene.start.inverseMass << stiffest.inverseMass, stiffest.inverseMass2;
    scene.names = {"a", "b"};
    scene.groups = {{"a", {0, 1}}};
    if (stiffest.inverseMass2 > 0.0)
        scene.groups.push_back({"b", {1, 1}});
    scene.effects = {std::make_shared<BodySpring>(std::vector<Link>{{0, 1}, {1, 0}}, stiffest.k),
                     std::make_shared<Damping>(stiffest.damp)};
    return scene;
}

/// Returns the amplification matrix of a step: it maps the positions and velocities of the two ends to the
/// new ones.
Eigen::Matrix4d matrixOf(const StiffestSpring &stiffest, const MethodPtr &method, double h)
{
    Scene scene = sceneOf(stiffest);
    method->prepareState(scene.start);
    const Pipeline pipeline = compose(scene, *method, StepSize::ofLength(h));
    Eigen::Matrix4d matrix;
    const FlushDenormals flush;
    for (int column = 0; column < 4; ++column) {
        State state = scene.start;
        (column < 2 ? state.position : state.velocity)(column % 2, 0) = 1.0;
        for (const Phase &phase : pipeline.phases)
            phase.run(state);
        matrix.col(column) << state.position.col(0), state.velocity.col(0);
    }
    return matrix;
}

/// Returns the angular frequency of the oscillation, in rad/frame.
double angularFrequency(const StiffestSpring &stiffest)
{
    return std::sqrt(stiffest.k * (stiffest.inverseMass + stiffest.inverseMass2));
}

/// Returns the smallest difference that `rest` allows, in px.
double smallestTolerance(const Rest &rest)
{
    double within = std::numeric_limits<double>::infinity();
    for (const RestPosition &place : rest.places)
        within = std::min(within, place.within);
    for (const RestDistance &distance : rest.distances)
        within = std::min(within, distance.within);
    if (rest.legs.feet > 0)
        within = std::min(within, rest.legs.within);
    return within;
}

/// Returns the claim of an adaptive method.
Claim claimByTolerance(const HardCase &hardCase, const Method &method, const RunSize &size)
{
    const StiffestSpring &stiffest = *hardCase.stiffest;
    // The error of a step is proportional to a power of its length.
    const double perRadian = std::pow(stiffest.stretch / size.tolerance, 1.0 / method.order());
    const double steps =
        std::max(angularFrequency(stiffest) * perRadian, hardCase.driven) + stepsPerBounce * hardCase.bounces;
    const std::int64_t budget =
        StepBudget::maxTries(hardCase.script.build(hardCase.script.values).start.pointCount());
    if (steps > maxBudgetShare * static_cast<double>(budget))
        return declined("claim-too-many-steps", method,
                        {{"steps", numberText(steps)}, {"most", std::to_string(budget)}});
    // Without damping, the errors of all steps add up.
    const double accumulatedError = static_cast<double>(size.frames) * size.tolerance;
    if (stiffest.damp == 1.0 && accumulatedError > hardCase.bound.reach - stiffest.stretch)
        return declined("claim-adds-up", method,
                        {{"frames", std::to_string(size.frames)}, {"off", numberText(accumulatedError)}});
    const Rest *rest = hardCase.hasRequirement(Requirement::comesToRest) ? hardCase.restAfter(size) : nullptr;
    const double disturbance = restDisturbance * size.tolerance * std::max(1.0, angularFrequency(stiffest));
    if (rest && (disturbance > rest->speed || disturbance > smallestTolerance(*rest)))
        return declined("claim-stirs", method,
                        {{"tolerance", numberText(size.tolerance)}, {"stirred", numberText(disturbance)}});
    return {true, {}};
}

/// Returns the claim of a method with fixed steps.
Claim claimByStep(const HardCase &hardCase, const MethodPtr &method, const RunSize &size)
{
    const StiffestSpring &stiffest = *hardCase.stiffest;
    const auto steps = static_cast<std::int64_t>(std::llround(static_cast<double>(size.frames) / size.h));
    const Prediction prediction = predictOscillation(stiffest, method, size.h, steps, hardCase.bound.reach);
    const std::map<std::string, std::string> numbers = {{"k", numberText(stiffest.k)},
                                                        {"apart", numberText(stiffest.stretch)},
                                                        {"h", numberText(size.h)},
                                                        {"left", numberText(prediction.left)},
                                                        {"frames", std::to_string(size.frames)}};
    if (!(prediction.most <= hardCase.bound.reach))
        return declined("claim-grows", *method, numbers);
    const Rest *rest = hardCase.restAfter(size);
    const bool restsInTime = !rest || !hardCase.hasRequirement(Requirement::comesToRest) ||
                             (prediction.left <= smallestTolerance(*rest) && prediction.speed <= rest->speed);
    return restsInTime ? Claim{true, {}} : declined("claim-rings", *method, numbers);
}

}

Prediction predictOscillation(const StiffestSpring &stiffest, const MethodPtr &method, double h,
                              std::int64_t steps, double limit)
{
    const Eigen::Matrix4d step = matrixOf(stiffest, method, h);
    Eigen::Vector4d state(stiffest.stretch, 0.0, 0.0, 0.0);
    Prediction prediction{stiffest.stretch, stiffest.stretch, 0.0};
    for (std::int64_t i = 0; i < steps && prediction.most <= limit; ++i) {
        const double before = state[0] - state[1];
        state = step * state;
        prediction.left = std::abs(state[0] - state[1]);
        prediction.speed = std::abs(state[0] - state[1] - before) / h;
        prediction.most =
            std::isfinite(prediction.left) ? std::max(prediction.most, prediction.left) : prediction.left;
    }
    return prediction;
}

Claim claimOf(const HardCase &hardCase, const MethodPtr &method, const RunSize &size)
{
    if (hardCase.hasRequirement(Requirement::rejected))
        return {true, {}}; // the scene is rejected before the method computes anything
    if (const std::optional<Error> error = composeError(scriptOf(hardCase, method, size)))
        return {false, error};
    if (hardCase.hasRequirement(Requirement::centreStays) && hasRequirement(*method, "groups"))
        return declined("claim-one-by-one", *method, {});
    const bool byTolerance = method->stepLimit() == StepLimit::tolerance;
    if (byTolerance && hardCase.hasRequirement(Requirement::noRoom))
        return declined("claim-no-room", *method, {});
    if (hardCase.stickError && size.h > hardCase.brief.h && !byTolerance)
        return declined("claim-longer-step", *method,
                        {{"h", numberText(size.h)}, {"most", numberText(hardCase.brief.h)}});
    if (!hardCase.stiffest)
        return {true, {}};
    return byTolerance ? claimByTolerance(hardCase, *method, size) : claimByStep(hardCase, method, size);
}

}

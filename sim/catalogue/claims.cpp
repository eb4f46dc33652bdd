#include "sim/catalogue/claims.h"

#include "sim/analysis/accuracy/study_run.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/methods/adaptive/adaptive_stepper.h"
#include "sim/pipeline/pipeline.h"
#include "sim/simd/flush_denormals.h"

#include <algorithm>
#include <cmath>
#include <sstream>

namespace sim {

namespace {

/// Methods that choose their steps give up a frame that takes too many of them (see Patient). They claim what should
/// take half as many.
constexpr double sureOf = 0.5;
/// Each bounce that they find takes a few.
constexpr double stepsPerBounce = 4.0;
/// What a step may be off stirs what should be at rest: by as much as a swing of that size, and some of them add up.
constexpr double stirs = 10.0;

std::string text(double value)
{
    std::ostringstream stream;
    stream.precision(3);
    stream << value;
    return stream.str();
}

Claim no(const char *id, const Method &method, std::map<std::string, std::string> values)
{
    values["method"] = method.id();
    return {false, Error(id, std::move(values))};
}

bool requirements(const Method &method, const char *what)
{
    const std::vector<std::string> all = method.requirements();
    return std::find(all.begin(), all.end(), what) != all.end();
}

/// Both ends of the spring on the x axis, in one group each, as those of a creature are.
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

/// What a step makes of the places and the velocities of the two ends: a column for each of the four.
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

/// How fast it swings, in rad/frame.
double pace(const StiffestSpring &stiffest)
{
    return std::sqrt(stiffest.k * (stiffest.inverseMass + stiffest.inverseMass2));
}

/// The most exact that places and distances have to be in the end, px.
double closest(const Rest &rest)
{
    double within = std::numeric_limits<double>::infinity();
    for (const RestPosition &place : rest.places)
        within = std::min(within, place.within);
    for (const RestDistance &distance : rest.distances)
        within = std::min(within, distance.within);
    return within;
}

/// For methods that choose their steps by the error that those make.
Claim claimByTolerance(const HardCase &hard, const Method &method, const RunSize &size)
{
    const StiffestSpring &stiffest = *hard.stiffest;
    // A step's error goes with a power of its length.
    const double perRadian = std::pow(stiffest.stretch / size.tolerance, 1.0 / method.order());
    const double steps = std::max(pace(stiffest) * perRadian, hard.driven) + stepsPerBounce * hard.bounces;
    const std::int64_t most = StepBudget::maxTries(hard.script.build(hard.script.values).start.pointCount());
    if (steps > sureOf * static_cast<double>(most))
        return no("claim-too-many-steps", method, {{"steps", text(steps)}, {"most", std::to_string(most)}});
    // Where nothing damps, what one step is off stays.
    const double mostOff = static_cast<double>(size.frames) * size.tolerance;
    if (stiffest.damp == 1.0 && mostOff > hard.bound.reach - stiffest.stretch)
        return no("claim-adds-up", method, {{"frames", std::to_string(size.frames)}, {"off", text(mostOff)}});
    const Rest *rest = hard.hasRequirement(Requirement::comesToRest) ? hard.restAfter(size) : nullptr;
    const double stirred = stirs * size.tolerance * std::max(1.0, pace(stiffest));
    if (rest && (stirred > rest->speed || stirred > closest(*rest)))
        return no("claim-stirs", method, {{"tolerance", text(size.tolerance)}, {"stirred", text(stirred)}});
    return {true, {}};
}

Claim claimByStep(const HardCase &hard, const MethodPtr &method, const RunSize &size)
{
    const StiffestSpring &stiffest = *hard.stiffest;
    const auto steps = static_cast<std::int64_t>(std::llround(static_cast<double>(size.frames) / size.h));
    const Prediction told = predictOscillation(stiffest, method, size.h, steps, hard.bound.reach);
    const std::map<std::string, std::string> numbers = {{"k", text(stiffest.k)},
                                                        {"apart", text(stiffest.stretch)},
                                                        {"h", text(size.h)},
                                                        {"left", text(told.left)},
                                                        {"frames", std::to_string(size.frames)}};
    if (!(told.most <= hard.bound.reach))
        return no("claim-grows", *method, numbers);
    const Rest *rest = hard.restAfter(size);
    const bool comes = !rest || !hard.hasRequirement(Requirement::comesToRest) ||
                       (told.left <= closest(*rest) && told.speed <= rest->speed);
    return comes ? Claim{true, {}} : no("claim-rings", *method, numbers);
}

}

Prediction predictOscillation(const StiffestSpring &stiffest, const MethodPtr &method, double h,
                              std::int64_t steps, double enough)
{
    const Eigen::Matrix4d step = matrixOf(stiffest, method, h);
    Eigen::Vector4d now(stiffest.stretch, 0.0, 0.0, 0.0);
    Prediction told{stiffest.stretch, stiffest.stretch, 0.0};
    for (std::int64_t i = 0; i < steps && told.most <= enough; ++i) {
        const double before = now[0] - now[1];
        now = step * now;
        told.left = std::abs(now[0] - now[1]);
        told.speed = std::abs(now[0] - now[1] - before) / h;
        told.most = std::isfinite(told.left) ? std::max(told.most, told.left) : told.left;
    }
    return told;
}

Claim claimOf(const HardCase &hard, const MethodPtr &method, const RunSize &size)
{
    if (hard.hasRequirement(Requirement::refused))
        return {true, {}}; // whatever would compute it
    if (const std::optional<Error> misfit = composeError(scriptOf(hard, method, size)))
        return {false, misfit};
    if (hard.hasRequirement(Requirement::centreStays) && requirements(*method, "groups"))
        return no("claim-one-by-one", *method, {});
    const bool byTolerance = method->stepLimit() == StepLimit::tolerance;
    if (byTolerance && hard.hasRequirement(Requirement::noRoom))
        return no("claim-no-room", *method, {});
    if (hard.stickError && size.h > hard.brief.h && !byTolerance)
        return no("claim-longer-step", *method, {{"h", text(size.h)}, {"most", text(hard.brief.h)}});
    if (!hard.stiffest)
        return {true, {}};
    return byTolerance ? claimByTolerance(hard, *method, size) : claimByStep(hard, method, size);
}

}

#pragma once

#include "sim/run/script/script.h"

#include <optional>
#include <string>
#include <vector>

namespace sim {

/// A demand of a hard case on a method, besides that the method can compute the scene. Claims depend only
/// on requirements, see claimOf().
enum class Requirement {
    oscillates,     ///< something oscillates, and the amplitude must not grow; see HardCase::stiffest
    comesToRest,    ///< the oscillation comes to rest within the run
    centreStays,    ///< no force from outside, so the centre of mass stays in place
    constraints,    ///< sticks, or other constraints on positions
    bounces,        ///< bodies meet walls or a floor; see HardCase::bounces
    noRoom,         ///< two walls are so close that a body always touches one of them
    dragging,       ///< a dragged body jumps
    parameterJumps, ///< a parameter jumps
    driven,         ///< a gait clock, a motor or wind drives the scene, too fast for a step to resolve
    noDirection,    ///< coincident points (or pointer and point), or points on one line
    manyPoints,     ///< thousands of points
    longRun,        ///< millions of frames
    unusualStep,    ///< a step that is not one frame long
    rejected,       ///< the run must be rejected with a user error
    overflows,      ///< a number becomes infinite; the run must end there with the failure cause
};

/// The fastest oscillation of a scene, as a model: two masses on a line, connected by a spring.
/// For a body with n feet, the feet are one mass, n times as heavy, on one spring, n times as stiff.
struct StiffestSpring
{
    double stretch = 100.0;    ///< px, largest difference from the rest length when the oscillation starts
    double k = 0.0;            ///< mass/frame^2, stiffness
    double inverseMass = 1.0;  ///< of the first end
    double inverseMass2 = 0.0; ///< of the second end; 0 if it is fixed
    double damp = 1.0;         ///< damping factor per frame
};

/// The length of a run and of its steps.
struct RunSize
{
    std::int64_t frames = 0;
    double h = 1.0;          ///< frames, step length of methods with fixed steps
    double tolerance = 1e-6; ///< px per step, for adaptive methods
};

/// The position at which a body comes to rest.
struct RestPosition
{
    std::string body;
    Vec2 x;              ///< px
    double within = 0.0; ///< px, allowed difference
};

/// The distance of two bodies at rest.
struct RestDistance
{
    std::string a;
    std::string b;
    double length = 0.0; ///< px
    double within = 0.0; ///< px, allowed difference
};

/// The legs of a creature at rest: the distances of the bodies "foot0", "foot1" and so on from "body".
struct RestLegs
{
    int feet = 0;
    double length = 0.0; ///< px
    double within = 0.0; ///< px, allowed difference
};

/// The state of rest at the end of a run.
struct Rest
{
    std::int64_t after = 0; ///< frames; shorter runs need not reach it
    std::vector<RestPosition> places = {};
    std::vector<RestDistance> distances = {};
    double speed = 0.0; ///< px/frame, upper bound of each displacement per frame in the last output step
    RestLegs legs = {};
};

/// Bounds that hold at every output step of a case.
struct Bounds
{
    double reach = 0.0;         ///< px, maximum distance of any point from `from`
    Vec2 from = {270.0, 200.0}; ///< px
    /// px, maximum displacement of the centre of mass; empty: no limit. See Requirement::centreStays.
    std::optional<double> drift;
};

/// An experiment that breaks careless methods.
struct HardCase
{
    std::string id;     ///< its name in files and on the command line
    std::string title;  ///< in English; see SIM_TEXT
    std::string family; ///< title of a group of cases, such as "Stiff springs", in English; see SIM_TEXT
    std::string story;  ///< what makes it hard, one sentence in English; see SIM_TEXT
    Script script;      ///< scene, values and input; scriptOf() adds the method and its step
    RunSize brief;      ///< a short run that shows the problem, for about a second
    RunSize full;       ///< the run that `story` describes
    std::vector<Requirement> requirements;
    /// The stiffest spring at any time of the run. Set for Requirement::oscillates.
    std::optional<StiffestSpring> stiffest;
    double bounces = 0.0; ///< maximum number of bounces per frame
    double driven = 0.0;  ///< rad/frame, angular frequency of the drive
    Bounds bound;
    std::optional<Rest> rest; ///< empty if no particular rest is required
    /// px, maximum error of a stick's length in steps as long as those of `brief`; empty: no limit.
    std::optional<double> stickError;
    std::string expectedError; ///< id of the expected Error, for Requirement::rejected

    bool hasRequirement(Requirement requirement) const;
    /// Returns the rest that a run of this size must reach; null if none.
    const Rest *restAfter(const RunSize &size) const;
};

/// Returns the script that runs `hardCase` under `method`.
Script scriptOf(const HardCase &hardCase, const MethodPtr &method, const RunSize &size);

}

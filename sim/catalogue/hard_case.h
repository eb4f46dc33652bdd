#pragma once

#include "sim/run/script/script.h"

#include <optional>
#include <string>
#include <vector>

namespace sim {

/// What a hard case asks of a method, besides being able to compute its scene at all. Claims go by these.
enum class Requirement {
    oscillates,     ///< something swings: it must not swing farther and farther; see HardCase::stiffest
    comesToRest,    ///< what swings comes to rest within the run
    centreStays,    ///< nothing pushes from outside: the middle of all masses stays where it is
    constraints,    ///< sticks, or other conditions on places
    bounces,        ///< things meet walls or a floor; see HardCase::bounces
    noRoom,         ///< a wall on either side leaves no place where a body would be free of both
    dragging,       ///< a hand jumps
    parameterJumps, ///< a parameter jumps
    driven,         ///< a clock, a motor or wind drives it, too fast for a step to follow
    noDirection,    ///< points (or pointer and point) in one place, or on one line
    manyPoints,     ///< thousands
    longRun,        ///< millions of frames
    unusualStep,    ///< a step that is not one frame
    refused,        ///< nothing but a clear refusal is right
    overflows,      ///< a number comes out infinite: the run ends there, and says where and why
};

/// The stiffest thing of a scene, as what swings fastest: two masses on a line, joined by a spring.
/// A creature's body with n feet counts as the feet in one, n times as heavy, on n springs in one.
struct StiffestSpring
{
    double stretch = 100.0;    ///< px: the most that the spring is out of its length when it begins to swing
    double k = 0.0;            ///< of the spring, mass/frame^2
    double inverseMass = 1.0;  ///< of what is pulled
    double inverseMass2 = 0.0; ///< of what it is pulled to; 0: that stands fast
    double damp = 1.0;         ///< what a velocity keeps each frame
};

/// How long a run is and by which steps it goes.
struct RunSize
{
    std::int64_t frames = 0;
    double h = 1.0;          ///< frames; methods that choose their steps take `tolerance`
    double tolerance = 1e-6; ///< px a step
};

/// A place at which a body comes to rest.
struct RestPosition
{
    std::string body;
    Vec2 x;              ///< px
    double within = 0.0; ///< px
};

/// A distance that two bodies have at rest.
struct RestDistance
{
    std::string a;
    std::string b;
    double length = 0.0; ///< px
    double within = 0.0; ///< px
};

/// What a run comes to in the end.
struct Rest
{
    std::int64_t after = 0; ///< frames: runs that are shorter need not come to it
    std::vector<RestPosition> places = {};
    std::vector<RestDistance> distances = {};
    double speed = 0.0; ///< px/frame: in the last row nothing goes faster from its place to the next
};

/// What "bounded" means in a case, in every frame.
struct Bounds
{
    double reach = 0.0;          ///< px: no point is farther from `from`
    Vec2 from = {270.0, 200.0};  ///< px
    std::optional<double> drift; ///< px: how far the middle of all masses may go; see Ask::centreStays
};

/// An experiment that breaks careless methods: a plain value.
struct HardCase
{
    std::string id;     ///< names it in files and on the command line
    std::string title;  ///< in English; see SIM_TEXT
    std::string family; ///< in English, what it has in common with others: "Stiff springs"; see SIM_TEXT
    std::string story;  ///< one sentence in English: what makes it hard; see SIM_TEXT
    Script script;      ///< scene, values and input; a method and its step are put in by scriptOf()
    RunSize brief;      ///< enough to see it, in about a second
    RunSize full;       ///< the size that the story tells
    std::vector<Requirement> requirements;
    std::optional<StiffestSpring>
        stiffest;         ///< at any time of the run; set if it asks for `swings` or `rests`
    double bounces = 0.0; ///< the most that happen in a frame
    double driven = 0.0;  ///< rad/frame: how fast what drives it turns
    Bounds bound;
    std::optional<Rest> rest; ///< where there is a right one
    std::optional<double>
        stickError; ///< px: how wrong a stick's length may be after any frame, by steps as brief has them
    std::string refusal; ///< the id of the Error that is right; empty: it runs

    bool hasRequirement(Requirement what) const;
    /// The rest that a run of this size must come to, if any.
    const Rest *restAfter(const RunSize &size) const;
};

/// The run of `hard` under `method`.
Script scriptOf(const HardCase &hard, const MethodPtr &method, const RunSize &size);

}

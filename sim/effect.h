#pragma once

#include "sim/direction.h"
#include "sim/state.h"

#include <memory>
#include <optional>
#include <string>
#include <variant>
#include <vector>

/// Marks a text that people read, for the translation tools. sim itself translates nothing.
#define SIM_TEXT(text) text

namespace sim {

/// A part of a source file between two lines `//! [marker]`: what the code panel shows.
struct Region
{
    std::string file; ///< from the project's top folder, with slashes
    std::string marker;
    friend auto operator<=>(const Region &, const Region &) = default;
};

/// A run of neighbouring points.
struct Points
{
    int first = 0;
    int count = 0;
    int end() const { return first + count; }
    bool contains(int point) const { return point >= first && point < end(); }
};

/// What kind of thing acts. It decides the colour.
enum class Kind { spring, gravity, damping, contact, driver, wind, stick, motion };

/// A named number (or pair) that a formula computed: `name` is the variable's name in the shown code.
struct Live
{
    std::string name;
    std::variant<double, Vec2> value;
    std::optional<std::variant<double, Vec2>> before = {}; ///< set when the line changes what it had
};

/// Something that acts on points. Const and without memory of its own: all that changes is in the State.
class Effect
{
public:
    virtual ~Effect() = default;
    /// Names the effect in files: lower case with underscores.
    virtual std::string id() const = 0;
    /// What a learner calls it, in English; see SIM_TEXT.
    virtual std::string title() const = 0;
    virtual Kind kind() const = 0;
    /// The source that computes this effect, in the order in which it runs.
    virtual std::vector<Region> regions(Directions directions) const = 0;
    /// How many pulls, or points, this effect computes among `points`.
    virtual int count(const State &state, Points points) const = 0;
};

/// Pushes points, and moves none.
class Force : public Effect
{
public:
    /// Adds `scale` times the acceleration (px/frame^2) of each point of `movers` to its row of `into`, one pull
    /// after the other. Points that feel nothing get nothing. A force whose other end feels the opposite in the same
    /// moment adds that to the other end's row at once, whether or not it is among `movers`.
    virtual void add(const State &state, Points movers, double scale, Directions directions,
                     Eigen::ArrayX2d &into) const = 0;
    /// The numbers behind what `mover` feels in `state`; the last one, "pull", is all of it.
    virtual std::vector<Live> explain(const State &state, int mover, Directions directions) const = 0;
};

/// Turns points that have angular inertia, and moves none.
class Torque : public Effect
{
public:
    /// Adds `scale` times the angular acceleration (degrees/frame^2) of each point of `movers` to its row of `into`.
    virtual void add(const State &state, Points movers, double scale, Eigen::ArrayXd &into) const = 0;
    virtual std::vector<Live> explain(const State &state, int mover) const = 0;
};

/// Slows points, exactly: what it leaves of a velocity (or spin) after `h` frames does not depend on how many steps
/// they were taken in, as long as nothing else acts.
class Drag : public Effect
{
public:
    virtual void slow(State &state, Points points, double h) const = 0;
    /// The numbers behind what it did to `point`; the last is the velocity with what it was before.
    virtual std::vector<Live> explain(const State &before, const State &after, int point, double h) const = 0;
};

/// Sets in motion or places what follows a rule of its own: a gait clock, a motor's impulse, a pointer that carries
/// a point, wind that turns branches. Drivers that a scene lists before everything else run at the start of a step,
/// the others at its end.
class Driver : public Effect
{
public:
    virtual void drive(State &state, double h) const = 0;
    virtual std::vector<Live> explain(const State &before, const State &after, int point) const = 0;
};

/// Moves points to where a condition wants them, after they moved by themselves. What it moves gets its velocity
/// from the way it came in the whole step.
class Constraint : public Effect
{
public:
    /// `points`: those whose turn it is; count() says whether any condition belongs to them.
    virtual void enforce(State &state, Points points, Directions directions, double h) const = 0;
    virtual std::vector<Live> explain(const State &before, const State &after, int point) const = 0;
};

/// Corrects points after they moved.
class Contact : public Effect
{
public:
    virtual void resolve(State &state, Points points) const = 0;
};

using EffectPtr = std::shared_ptr<const Effect>;

/// What changed of a point, position and then velocity, under the names "x" and "v": an explanation for effects
/// whose formula computes nothing else.
std::vector<Live> changeOf(const State &before, const State &after, int point);

}

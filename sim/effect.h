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
    /// after the other. Points that feel nothing get nothing.
    virtual void add(const State &state, Points movers, double scale, Directions directions,
                     Eigen::ArrayX2d &into) const = 0;
    /// The numbers behind what `mover` feels in `state`; the last one, "pull", is all of it.
    virtual std::vector<Live> explain(const State &state, int mover, Directions directions) const = 0;
};

/// Slows points: takes the same share of every velocity. A method applies it as exactly as it can.
class Drag : public Effect
{
public:
    /// The factor that a velocity keeps over `h` frames.
    virtual double keep(double h) const = 0;
};

/// Corrects points after they moved.
class Contact : public Effect
{
public:
    virtual void resolve(State &state, Points points) const = 0;
};

using EffectPtr = std::shared_ptr<const Effect>;

}

#pragma once

#include "sim/base/direction.h"
#include "sim/forward.h"
#include "sim/scene/explanation.h"
#include "sim/scene/state.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <variant>
#include <vector>

/// Marks a text that people read, for the translation tools. sim itself translates nothing.
#define SIM_TEXT(text) text

namespace sim {

/// A run of neighbouring points.
struct PointRange
{
    int first = 0;
    int count = 0;
    int end() const { return first + count; }
    bool contains(int point) const { return point >= first && point < end(); }
    friend bool operator==(const PointRange &, const PointRange &) = default;
};

/// What kind of thing acts. It decides the colour.
enum class EffectKind { spring, gravity, damping, contact, driver, wind, stick, motion };

/// What the work of an effect on a point depends on, besides the effect's own numbers.
enum class Dependence {
    coupledPoints, ///< that point, and those that Effect::ties() ties to it, straight or by way of others; nothing else
    scene, ///< anything in the State but the number of the frame
    time,  ///< the number of the frame, too: what is random is a hash of it
};

/// Two points of which at least one feels the other.
using Coupling = std::pair<int, int>;

struct RestTarget;
class Driver;
class Force;
class Torque;
class Drag;
class Constraint;
class Contact;

/// What an effect does in a step: each is one of these six. std::monostate: nothing that a method knows.
using Role = std::variant<std::monostate, const Driver *, const Force *, const Torque *, const Drag *,
                          const Constraint *, const Contact *>;

/// Something that acts on points. Const and without memory of its own: all that changes is in the State.
class Effect
{
public:
    virtual ~Effect() = default;
    virtual Role role() const = 0;
    /// Names the effect in files: lower case with underscores.
    virtual std::string id() const = 0;
    /// What a learner calls it, in English; see SIM_TEXT.
    virtual std::string title() const = 0;
    virtual EffectKind kind() const = 0;
    /// The source that computes this effect, in the order in which it runs.
    virtual std::vector<Region> regions(DirectionRule directionRule) const = 0;
    /// How many pulls, or points, this effect computes among `points`.
    virtual int count(const State &state, PointRange points) const = 0;
    /// What decides whether what has come to rest may sleep, and what can be computed apart from the rest.
    virtual Dependence dependence() const { return Dependence::time; }
    /// Whether in `state`, and as long as nothing comes in from outside, it does not look at the number of the frame.
    virtual bool isTimeIndependent(const State &) const { return dependence() != Dependence::time; }
    /// Adds each two points that it ties together, once or more often. Only for one that sees what is tied.
    virtual void addCouplings(std::vector<Coupling> &) const {}
    /// Whether its own numbers are such that it can change nothing, wherever points are: gravity 0, a wall infinitely
    /// far away. Such an effect is left out when a scene is composed.
    virtual bool isIdle() const { return false; }
    /// Adds where each end that it can move would be at rest; both ends of what pulls both.
    virtual void addRestTargets(const State &, std::vector<RestTarget> &) const {}
    /// Adds itself to a plan of its scene, as a learner could have built it. Returns false for an effect that cannot be
    /// built.
    virtual bool addToDraft(BlueprintDraft &) const { return false; }
};

/// How accelerations change with places: the entries of that matrix of derivatives, in 1/frame^2. Entries for the
/// same row and column add up.
class Jacobian
{
public:
    struct Entry
    {
        int row = 0;    ///< whose acceleration: x of each point, then y of each point, then each angle
        int column = 0; ///< by whose place, in the same order
        double value = 0.0;
    };

    explicit Jacobian(int points) : m_points(points) {}
    /// The acceleration of `mover` by the place of `by`: along x by x, x by y, y by x, y by y.
    void add(int mover, int by, double xx, double xy, double yx, double yy)
    {
        m_entries.insert(m_entries.end(), {{mover, by, xx},
                                           {mover, m_points + by, xy},
                                           {m_points + mover, by, yx},
                                           {m_points + mover, m_points + by, yy}});
    }
    /// The angular acceleration of `mover` by the angle of `by`.
    void addAngular(int mover, int by, double value)
    {
        m_entries.push_back({2 * m_points + mover, 2 * m_points + by, value});
    }
    const std::vector<Entry> &entries() const { return m_entries; }

private:
    int m_points;
    std::vector<Entry> m_entries;
};

/// Adds accelerations of a part of a scene's points (px/frame^2) to their rows of `into`.
using AccelerationAdder = std::function<void(const State &state, Eigen::ArrayX2d &into)>;

/// Pushes points, and moves none.
class Force : public Effect
{
public:
    Role role() const final { return this; }
    /// Adds `scale` times the acceleration (px/frame^2) of each point of `movers` to its row of `into`, one pull
    /// after the other. Points that feel nothing get nothing. A force whose other end feels the opposite in the same
    /// moment adds that to the other end's row at once, whether or not it is among `movers`.
    virtual void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                     Eigen::ArrayX2d &into) const = 0;
    /// Finds out once what add() needs to know of the points of `runs`, which are in ascending order and hold all points
    /// that are tied to any of theirs: the result adds what add() does with them for DirectionRule::apart, and may be
    /// called again and again as long as this effect lives.
    virtual AccelerationAdder adderFor(const std::vector<PointRange> &ranges) const
    {
        return [this, ranges](const State &state, Eigen::ArrayX2d &into) {
            for (const PointRange &range : ranges)
                add(state, range, 1.0, DirectionRule::regularised, into);
        };
    }
    /// The acceleration straight down (px/frame^2), where it is the same for every point that feels forces and all that
    /// this force does.
    virtual std::optional<double> uniformGravity() const { return {}; }
    /// Adds `scale` times the derivatives of what add() adds. Returns false, and adds nothing, for a force that has
    /// none.
    virtual bool addJacobian(const State &, PointRange, double, DirectionRule, Jacobian &) const
    {
        return false;
    }
    /// What it has stored where things are in `state`, in mass * px^2/frame^2: the function of places of which what it
    /// adds, times the mass of each point, is minus the gradient. What else it depends on (a gait clock, say) counts
    /// as it stands in `state`. Points with inverse mass 0 are those that can never feel anything. Empty for a force
    /// that is no such gradient, as one that pulls one end only of two that can feel.
    /// Source: Goldstein, "Classical mechanics", section 1.1.
    virtual std::optional<double> potentialEnergy(const State &) const { return {}; }
    /// Whether what it adds, times masses, is in sum nothing where every point feels it: to each action a reaction.
    virtual bool conservesMomentum(const State &) const { return false; }
    /// The numbers behind what `mover` feels in `state`; the last one, "pull", is all of it.
    virtual std::vector<LiveValue> explain(const State &state, int mover,
                                           DirectionRule directionRule) const = 0;
};

/// Turns points that have angular inertia, and moves none.
class Torque : public Effect
{
public:
    Role role() const final { return this; }
    /// Adds `scale` times the angular acceleration (degrees/frame^2) of each point of `movers` to its row of `into`.
    virtual void add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const = 0;
    /// As for a Force.
    virtual bool addJacobian(const State &, PointRange, double, Jacobian &) const { return false; }
    /// As for a Force, in inertia * degrees^2/frame^2.
    virtual std::optional<double> potentialEnergy(const State &) const { return {}; }
    /// The inertia that it divides by, one entry a point; empty where it knows none.
    virtual Eigen::ArrayXd inertia() const { return {}; }
    virtual std::vector<LiveValue> explain(const State &state, int mover) const = 0;
};

/// Slows points, exactly: what it leaves of a velocity (or spin) after `h` frames does not depend on how many steps
/// they were taken in, as long as nothing else acts.
class Drag : public Effect
{
public:
    Role role() const final { return this; }
    virtual void apply(State &state, PointRange points, double h) const = 0;
    /// The share of its velocity that each of `points` keeps over `h` frames, where it is the same for all of them and
    /// all that this drag does.
    virtual std::optional<double> velocityFactor(PointRange, double) const { return {}; }
    /// The c of `point` (1/frame) for a drag that is v' = -c v: 0 for what it leaves alone, infinite for what it
    /// stops at once. Empty for any other kind of drag.
    virtual std::optional<double> dampingRate(int) const { return {}; }
    /// The numbers behind what it did to `point`; the last is the velocity with what it was before.
    virtual std::vector<LiveValue> explain(const State &before, const State &after, int point,
                                           double h) const = 0;
};

/// How what a driver does goes with time.
enum class DriverTiming {
    impulsive,  ///< once a step, by a jump: there is no rate behind it
    continuous, ///< steadily: in two parts it comes to the same, and a negative time undoes it
    dependent,  ///< it has no time: it puts in place what the rest of the state decides
};

/// Sets in motion or places what follows a rule of its own: a gait clock, a motor's impulse, a pointer that carries
/// a point, wind that turns branches. Drivers that a scene lists before everything else run at the start of a step,
/// the others at its end.
class Driver : public Effect
{
public:
    Role role() const final { return this; }
    virtual void drive(State &state, double h) const = 0;
    virtual DriverTiming timing() const { return DriverTiming::impulsive; }
    virtual std::vector<LiveValue> explain(const State &before, const State &after, int point) const = 0;
};

/// Moves points to where a condition wants them, after they moved by themselves. What it moves gets its velocity
/// from the way it came in the whole step: so one that moves nothing is not idle, as it decides what velocities are.
class Constraint : public Effect
{
public:
    Role role() const final { return this; }
    /// `points`: those whose turn it is; count() says whether any condition belongs to them.
    virtual void enforce(State &state, PointRange points, DirectionRule directionRule, double h) const = 0;
    virtual std::vector<LiveValue> explain(const State &before, const State &after, int point) const = 0;
};

/// What a surface does to the speed along it of a point that touches it.
enum class Grip {
    none, ///< nothing
    full, ///< takes all of it
};

/// A straight edge that a point may not pass: it is free where normal . x >= offset.
struct Surface
{
    Vec2 normal;         ///< of length 1, to where the point is free
    double offset = 0.0; ///< px
    double bounce = 0.0; ///< share of the speed into it that is kept, turned round
    Grip grip = Grip::none;
};

/// Corrects points after they moved.
class Contact : public Effect
{
public:
    Role role() const final { return this; }
    virtual void resolve(State &state, PointRange points) const = 0;
    /// The surfaces that `point` meets: what resolve() comes to when steps get small.
    virtual std::vector<Surface> surfaces(int point) const = 0;
};

/// Returns `effect` as a Force, a Drag, ...; null where it has another role.
template <class Type>
const Type *as(const Effect &effect)
{
    const Role role = effect.role();
    const auto *found = std::get_if<const Type *>(&role);
    return found ? *found : nullptr;
}

/// The same; null for null.
template <class Type>
const Type *as(const EffectPtr &effect)
{
    return effect ? as<Type>(*effect) : nullptr;
}

/// The same with a share in its ownership.
template <class Type>
std::shared_ptr<const Type> sharedAs(const EffectPtr &effect)
{
    const Type *found = as<Type>(effect);
    return found ? std::shared_ptr<const Type>(effect, found) : nullptr;
}

/// What changed of a point, position and then velocity, under the names "x" and "v": an explanation for effects
/// whose formula computes nothing else.
std::vector<LiveValue> motionChange(const State &before, const State &after, int point);

}

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

/// Marks a text for the translation tools. The library sim does not translate it; the app does.
#define SIM_TEXT(text) text

namespace sim {

/// Consecutive points, from `first` to end() - 1.
struct PointRange
{
    int first = 0;
    int count = 0;
    int end() const { return first + count; }
    bool contains(int point) const { return point >= first && point < end(); }
    friend bool operator==(const PointRange &, const PointRange &) = default;
};

/// The kind of an effect. It decides the colour in the window.
enum class EffectKind { spring, gravity, damping, contact, driver, wind, stick, motion, rule };

/// The numbers on which an effect's result for a point depends, besides the parameters of the effect.
enum class Dependence {
    coupledPoints, ///< that point and those that addCouplings() joins to it, directly or indirectly
    scene,         ///< anything in the State except the frame number
    time,          ///< the frame number too, for example because a random number is a hash of it
};

/// Two points. At least one of them feels the other.
using Coupling = std::pair<int, int>;

struct RestTarget;
class Driver;
class Force;
class Torque;
class Drag;
class Constraint;
class Contact;

/// The role of an effect in a step. std::monostate: none, methods ignore the effect.
using Role = std::variant<std::monostate, const Driver *, const Force *, const Torque *, const Drag *,
                          const Constraint *, const Contact *>;

/// Something that acts on points. An effect is immutable: everything that changes is in the State.
class Effect
{
public:
    virtual ~Effect() = default;
    virtual Role role() const = 0;
    /// Returns the name of the effect in files: lower case with underscores.
    virtual std::string id() const = 0;
    /// Returns the name that a learner sees, in English; see SIM_TEXT.
    virtual std::string title() const = 0;
    virtual EffectKind kind() const = 0;
    /// Returns the source code of this effect, in the order in which it runs.
    virtual std::vector<Region> regions(DirectionRule directionRule) const = 0;
    /// Returns how many forces (or points, or conditions) this effect computes for `points`; 0 if it does
    /// nothing to them.
    virtual int count(const State &state, PointRange points) const = 0;
    /// Returns what this effect depends on. It decides what may sleep and which points form an island.
    virtual Dependence dependence() const { return Dependence::time; }
    /// Returns whether this effect ignores the frame number from `state` on, as long as there is no new
    /// input.
    virtual bool isTimeIndependent(const State &) const { return dependence() != Dependence::time; }
    /// Adds each coupling that this effect makes, once or several times. Only for Dependence::coupledPoints.
    virtual void addCouplings(std::vector<Coupling> &) const {}
    /// Returns whether the parameters of this effect make it act on no state at all: gravity 0, a wall
    /// infinitely far away. Composing a scene leaves out such effects.
    virtual bool isIdle() const { return false; }
    /// Adds the rest target of each point that this effect can move. If a pair moves both its ends, adds
    /// both.
    virtual void addRestTargets(const State &, std::vector<RestTarget> &) const {}
    /// Adds this effect to a draft of a blueprint. Returns false if a blueprint cannot express the effect.
    virtual bool addToDraft(BlueprintDraft &) const { return false; }
};

/// The derivatives of accelerations by positions, in 1/frame^2, as a sparse matrix. Entries with the same row
/// and column add up.
class Jacobian
{
public:
    struct Entry
    {
        int row = 0;    ///< acceleration: x of each point, then y of each point, then each angle
        int column = 0; ///< position, in the same order
        double value = 0.0;
    };

    explicit Jacobian(int points) : m_points(points) {}
    /// Adds the derivative of the acceleration of `mover` by the position of `by`: of x by x, x by y, y by x,
    /// y by y.
    void add(int mover, int by, double xx, double xy, double yx, double yy)
    {
        m_entries.insert(m_entries.end(), {{mover, by, xx},
                                           {mover, m_points + by, xy},
                                           {m_points + mover, by, yx},
                                           {m_points + mover, m_points + by, yy}});
    }
    /// Adds the derivative of the angular acceleration of `mover` by the angle of `by`.
    void addAngular(int mover, int by, double value)
    {
        m_entries.push_back({2 * m_points + mover, 2 * m_points + by, value});
    }
    const std::vector<Entry> &entries() const { return m_entries; }

private:
    int m_points;
    std::vector<Entry> m_entries;
};

/// Adds the accelerations of certain points (px/frame^2) to their rows of `into`.
using AccelerationAdder = std::function<void(const State &state, Eigen::ArrayX2d &into)>;

/// An effect that accelerates points but does not move them.
class Force : public Effect
{
public:
    Role role() const final { return this; }
    /// Adds `scale` times the acceleration (px/frame^2) of each dynamic point of `movers` to its row of
    /// `into`, one force after the other. If the other end of a pair feels the opposite force at the same
    /// time, this function also adds it to the row of that end, whether or not that end is among `movers`.
    virtual void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                     Eigen::ArrayX2d &into) const = 0;
    /// Prepares add() for the points of `ranges` with DirectionRule::regularised, so that repeated calls are
    /// fast. The ranges are in ascending order and hold complete islands. The result is valid as long as this
    /// effect exists.
    virtual AccelerationAdder adderFor(const std::vector<PointRange> &ranges) const
    {
        return [this, ranges](const State &state, Eigen::ArrayX2d &into) {
            for (const PointRange &range : ranges)
                add(state, range, 1.0, DirectionRule::regularised, into);
        };
    }
    /// Returns whether the accelerations depend on velocities. Methods without velocities at all their stages reject such a
    /// force.
    virtual bool dependsOnVelocity() const { return false; }
    /// Returns the downward acceleration (px/frame^2) if this force gives every dynamic point the same one
    /// and does nothing else.
    virtual std::optional<double> uniformGravity() const { return {}; }
    /// Adds `scale` times the derivatives of the accelerations that add() adds. Returns false, and adds
    /// nothing, if this force has none.
    virtual bool addJacobian(const State &, PointRange, double, DirectionRule, Jacobian &) const
    {
        return false;
    }
    /// Returns the potential energy in mass * px^2/frame^2. Its negative gradient by the positions is the
    /// force: the acceleration that add() adds, times the mass. Anything else that it depends on, such as a
    /// gait clock, has its value in `state`. Points with inverse mass 0 are treated as fixed. Empty if the
    /// force has no potential, for example because it pulls only one of two dynamic ends.
    /// Source: Goldstein, "Classical mechanics", section 1.1.
    virtual std::optional<double> potentialEnergy(const State &) const { return {}; }
    /// Returns whether the forces on all points add up to zero, if every point is dynamic: each action has a
    /// reaction.
    virtual bool conservesMomentum(const State &) const { return false; }
    /// Returns the numbers that lead to the force on `mover` in `state`. The last one, "pull", is the result.
    virtual std::vector<LiveValue> explain(const State &state, int mover,
                                           DirectionRule directionRule) const = 0;
};

/// An effect that accelerates the rotation of points but does not turn them.
class Torque : public Effect
{
public:
    Role role() const final { return this; }
    /// Adds `scale` times the angular acceleration (degrees/frame^2) of each point of `movers` to its entry
    /// of `into`.
    virtual void add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const = 0;
    /// See Force::addJacobian().
    virtual bool addJacobian(const State &, PointRange, double, Jacobian &) const { return false; }
    /// See Force::potentialEnergy(). In inertia * degrees^2/frame^2.
    virtual std::optional<double> potentialEnergy(const State &) const { return {}; }
    /// Returns the angular inertia of each point that this torque divides by; empty if it uses none.
    virtual Eigen::ArrayXd inertia() const { return {}; }
    /// See Force::explain().
    virtual std::vector<LiveValue> explain(const State &state, int mover) const = 0;
};

/// An effect that slows points. It is exact: if nothing else acts, the velocity (or spin) after a time does
/// not depend on the number of steps.
class Drag : public Effect
{
public:
    Role role() const final { return this; }
    /// Slows `points` for `h` frames.
    virtual void apply(State &state, PointRange points, double h) const = 0;
    /// Returns the damping factor of `points`: the fraction of the velocity that remains after `h` frames.
    /// Empty if the factor differs between points or this drag does anything else.
    virtual std::optional<double> velocityFactor(PointRange, double) const { return {}; }
    /// Returns the damping rate c of `point` (1/frame) if this drag is v' = -c v. It is 0 for points that
    /// this drag does not affect and infinite for points that it stops at once. Empty for any other kind of
    /// drag.
    virtual std::optional<double> dampingRate(int) const { return {}; }
    /// Returns the numbers that lead to the new velocity of `point`. The last one is that velocity.
    virtual std::vector<LiveValue> explain(const State &before, const State &after, int point,
                                           double h) const = 0;
};

/// How the result of a driver depends on the length of a step.
enum class DriverTiming {
    impulsive,  ///< a jump, once per step: it has no rate
    continuous, ///< a rate: two half steps give the same as one step, and a negative time undoes it
    dependent,  ///< independent of time: it sets values that follow from the rest of the state
};

/// An effect that changes a state by a rule instead of a force: a gait clock, a motor's impulse, a pointer
/// that drags a point, wind that turns branches. Drivers that a scene lists before all other effects run at
/// the start of a step, the others at its end.
class Driver : public Effect
{
public:
    Role role() const final { return this; }
    /// Changes `state` for a step of `h` frames.
    virtual void drive(State &state, double h) const = 0;
    virtual DriverTiming timing() const { return DriverTiming::impulsive; }
    virtual std::vector<LiveValue> explain(const State &before, const State &after, int point) const = 0;
};

/// An effect that moves points until they satisfy a condition, after they moved by their velocities. The new
/// velocity is the displacement of the whole step divided by its length. So a constraint is never idle: even
/// if it moves nothing, it decides how velocities are computed.
class Constraint : public Effect
{
public:
    Role role() const final { return this; }
    /// Enforces the conditions of `points` at the end of a step of `h` frames. See count().
    virtual void enforce(State &state, PointRange points, DirectionRule directionRule, double h) const = 0;
    virtual std::vector<LiveValue> explain(const State &before, const State &after, int point) const = 0;
};

/// The change that a surface makes to the tangential velocity of a point that touches it.
enum class Traction {
    full, ///< sets it to 0
    none, ///< leaves it unchanged: ice
};

/// A straight edge that a point may not cross: the point has to satisfy normal . x >= offset.
struct Surface
{
    Vec2 normal;         ///< of length 1, towards the free side
    double offset = 0.0; ///< px
    double bounce = 0.0; ///< restitution: fraction of the normal velocity that remains, reversed
    Traction traction = Traction::none;
};

/// An effect that keeps points on the free side of surfaces, after they moved.
class Contact : public Effect
{
public:
    Role role() const final { return this; }
    /// Corrects the positions and velocities of `points`.
    virtual void resolve(State &state, PointRange points) const = 0;
    /// Returns the surfaces that `point` can meet: the limit of resolve() for small steps.
    virtual std::vector<Surface> surfaces(int point) const = 0;
};

/// Returns `effect` as a Force, a Drag, ...; null if it has another role.
template <class Type>
const Type *as(const Effect &effect)
{
    const Role role = effect.role();
    const auto *found = std::get_if<const Type *>(&role);
    return found ? *found : nullptr;
}

/// Returns `effect` as a Force, a Drag, ...; null if it is null or has another role.
template <class Type>
const Type *as(const EffectPtr &effect)
{
    return effect ? as<Type>(*effect) : nullptr;
}

/// Returns as<Type>(effect) as a shared pointer that keeps the effect alive.
template <class Type>
std::shared_ptr<const Type> sharedAs(const EffectPtr &effect)
{
    const Type *found = as<Type>(effect);
    return found ? std::shared_ptr<const Type>(effect, found) : nullptr;
}

/// Returns the position "x" and the velocity "v" of a point if they changed. It is the explanation of effects
/// whose formula has no other numbers.
std::vector<LiveValue> motionChange(const State &before, const State &after, int point);

}

#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// The points that a phase works on.
struct PhasePoints
{
    PointRange points;
    int group = -1; ///< index of their group in Scene::groups; -1: all groups at once
};

/// Returns the velocity after a step of `h` frames with the acceleration `a` (px/frame^2).
// The marker skips `inline`, which learners need not read.
// clang-format off
inline
//! [kick]
Vec2 kick(Vec2 v, Vec2 a, double h)
{
    v = v + h * a;
    return v;
}
//! [kick]
// clang-format on

/// Returns the position after a step of `h` frames with the velocity `v` (px/frame).
// The marker skips `inline`, which learners need not read.
// clang-format off
inline
//! [move]
Vec2 move(Vec2 x, Vec2 v, double h)
{
    x = x + h * v;
    return x;
}
//! [move]
// clang-format on

/// Returns the spin after a step of `h` frames with the angular acceleration `a` (degrees/frame^2).
// The marker skips `inline`, which learners need not read.
// clang-format off
inline
//! [kick_spin]
double kickSpin(double spin, double a, double h)
{
    spin = spin + h * a;
    return spin;
}
//! [kick_spin]
// clang-format on

/// Returns the angle after a step of `h` frames with the spin `spin` (degrees/frame).
// The marker skips `inline`, which learners need not read.
// clang-format off
inline
//! [turn]
double turn(double angle, double spin, double h)
{
    angle = angle + h * spin;
    return angle;
}
//! [turn]
// clang-format on

/// Returns the velocity of a point that constraints have moved: its displacement in a step, divided by the
/// `h` frames of the step.
/// Source: Jakobsen, "Advanced character physics", 2001, section 2; Mueller et al., "Position based
/// dynamics", 2007, line 13 of the algorithm.
// The marker skips `inline`, which learners need not read.
// clang-format off
inline
//! [velocity_update]
Vec2 velocityFromPositions(Vec2 x, Vec2 before, double h)
{
    Vec2 v = (1 / h) * (x - before);
    return v;
}
//! [velocity_update]
// clang-format on

/// Adds the accelerations of `force` on `movers` to an array of `state`. `h` is the length of a step in
/// frames.
using AddForce = void (*)(const Force &force, State &state, PointRange movers, double h);
/// Adds the angular accelerations of `torque` on `movers` to an array of `state`. `h` is the length of a step
/// in frames.
using AddTorque = void (*)(const Torque &torque, State &state, PointRange movers, double h);

/// The array of State to which forces are added.
enum class AccumulationTarget { acceleration, velocity };

/// How a method adds up forces and torques, with the source code of both functions.
struct ForceAccumulation
{
    AddForce force = nullptr;
    AddTorque torque = nullptr;
    Region forceRegion;
    Region torqueRegion;
    AccumulationTarget target = AccumulationTarget::acceleration;
};

/// Returns functions that add forces to State::acceleration and torques to State::angularAcceleration.
ForceAccumulation accelerationAccumulation();

/// A builder for the phases of one step. Methods call its functions in their own order. Most functions add
/// phases for a selection of points. An effect that does nothing to those points gets no phase.
class PhaseBuilder
{
public:
    /// `h` is the length of a step in frames.
    PhaseBuilder(const Scene &scene, DirectionRule directionRule, double h);

    /// Returns all points, without a group.
    PhasePoints allPoints() const;
    /// Returns the points of each group, in order.
    std::vector<PhasePoints> groups() const;

    /// Returns whether any dynamic point moves by its velocity.
    bool anyMoves() const { return !movingRanges(allPoints().points).empty(); }

    /// Adds the drivers that the scene lists before all other effects.
    void leadingDrivers();
    /// Adds the other drivers.
    void trailingDrivers();
    /// Adds the leading drivers that are impulsive.
    void leadingImpulses();
    /// Adds the trailing drivers that are impulsive.
    void trailingImpulses();
    /// Adds the continuous drivers for `fraction` of the step, then the dependent drivers.
    void continuousDrivers(double fraction);
    /// Adds each force, then each torque. `accumulation` says how they are added up.
    void forces(const PhasePoints &selection, const ForceAccumulation &accumulation);
    /// Adds the phases that sum all forces and torques at the current positions, starting from 0.
    void accumulateForces(const PhasePoints &selection);
    /// Adds the kick v = v + h a for `fraction` of the step, and the same for spins.
    void kick(const PhasePoints &selection, double fraction = 1.0);
    /// Adds each drag for `fraction` of the step.
    void damping(const PhasePoints &selection, double fraction = 1.0);
    /// Adds each drag that has no damping rate.
    void dampingWithoutRate(const PhasePoints &selection);
    /// Adds forces, torques and drags in the order in which the scene lists them.
    void effectsInSceneOrder(const PhasePoints &selection, const ForceAccumulation &accumulation);
    /// Adds the move x = x + h v for `fraction` of the step, or angle = angle + h spin if the scene has
    /// spins. Only for points that move by their velocity.
    void move(const PhasePoints &selection, double fraction = 1.0);
    /// Adds a phase that the method defines itself.
    void add(Phase phase) { m_phases.push_back(std::move(phase)); }
    /// Sets the previous positions to x - h v before the next phase. Methods whose step is not one kick and
    /// one move call it before constraints(). The velocity update then gives v plus the corrections of the
    /// constraints.
    void rewindPrevious(const PhasePoints &selection);
    /// Adds each constraint, then the velocity update from positions.
    void constraints(const PhasePoints &selection);
    /// Adds each contact.
    void contacts(const PhasePoints &selection);

    /// Returns the phases. The builder must not be used afterwards.
    std::vector<Phase> take();

private:
    template <class Type, class Visit>
    void forEach(const PhasePoints &selection, Visit &&visit) const;
    Phase phaseOf(const EffectPtr &effect, const PhasePoints &selection) const;
    Phase methodPhase(const char *id, const char *title, const PhasePoints &selection) const;
    template <class Accept>
    void drivers(std::size_t first, std::size_t end, double h, Accept &&accept);
    /// Returns how many drivers the scene lists before all other effects.
    std::size_t leadingDriverCount() const;
    /// Returns `points` without the points at either end that are not dynamic.
    PointRange trimToDynamic(PointRange points) const;
    /// Returns the ranges of `points` that move by their velocity and contain a dynamic point.
    std::vector<PointRange> movingRanges(PointRange points) const;
    bool hasSpin() const { return m_scene.start.spin.rows() > 0; }
    bool hasConstraint(const PhasePoints &selection) const;
    /// Returns a kernel that copies positions to State::previous; null if there are no constraints.
    std::function<void(State &, PointRange)> savePrevious(const PhasePoints &selection) const;

    void force(const std::shared_ptr<const Force> &force, const PhasePoints &selection,
               const ForceAccumulation &accumulation);
    void torque(const std::shared_ptr<const Torque> &torque, const PhasePoints &selection,
                const ForceAccumulation &accumulation);
    void drag(const std::shared_ptr<const Drag> &drag, const PhasePoints &selection, double fraction);
    void driver(const std::shared_ptr<const Driver> &driver, double h);
    void kickSpins(const PhasePoints &selection, double fraction);
    void turnAngles(const PhasePoints &selection, double fraction);
    void velocityUpdate(const PhasePoints &selection);

    const Scene &m_scene;
    DirectionRule m_directionRule;
    double m_h;
    std::vector<Phase> m_phases;
    bool m_accumulates = false;    ///< whether a phase of this step already accumulates forces
    std::size_t m_rewindPhase = 0; ///< index of the phase before which m_rewind runs
    /// Null if the scene has no constraint. See rewindPrevious().
    std::function<void(State &, PointRange)> m_rewind;
};

/// Returns a kernel that calls work(state, points). Divided, it calls `work` for each range.
template <class Work>
Kernel kernelOf(PointRange points, Work work)
{
    Kernel kernel;
    kernel.prepareFor = [work](const std::vector<PointRange> &ranges) {
        return [work, ranges](State &state) {
            for (const PointRange &range : ranges)
                work(state, range);
        };
    };
    kernel.run = [work = std::move(work), points](State &state) { work(state, points); };
    return kernel;
}

/// Appends a kernel that does `work` on the points of `phase`. `phase.effect` decides whether the kernel can
/// be divided.
template <class Work>
void appendKernel(Phase &phase, Work work)
{
    phase.kernels.push_back(kernelOf(phase.points, std::move(work)));
    if (phase.effect && phase.effect->dependence() != Dependence::coupledPoints)
        phase.kernels.back().prepareFor = nullptr;
}

/// Inserts a kernel that does `work` on the points of `phase` before its other kernels.
template <class Work>
void prependKernel(Phase &phase, Work work)
{
    phase.kernels.insert(phase.kernels.begin(), kernelOf(phase.points, std::move(work)));
}

template <class Type, class Visit>
void PhaseBuilder::forEach(const PhasePoints &selection, Visit &&visit) const
{
    for (const EffectPtr &effect : m_scene.effects) {
        const auto typed = sharedAs<Type>(effect);
        if (typed && typed->count(m_scene.start, selection.points) > 0)
            visit(typed);
    }
}

}

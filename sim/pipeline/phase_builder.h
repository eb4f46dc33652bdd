#pragma once

#include "sim/pipeline/method.h"

namespace sim {

/// Which of a scene's points a phase takes, and under which group's name.
struct PhasePoints
{
    PointRange points;
    int group = -1;
};

/// One step of velocity: h in frames, a in px/frame^2.
// The marker leaves out what learners need not read.
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

/// One step of position.
// The marker leaves out what learners need not read.
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

/// One step of a spin: h in frames, a in degrees/frame^2.
// The marker leaves out what learners need not read.
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

/// One step of an angle.
// The marker leaves out what learners need not read.
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

/// The velocity of a point that constraints have put in its place: the way it came in a step of `h` frames.
/// Source: Jakobsen, "Advanced character physics", 2001, section 2; Mueller et al., "Position based dynamics",
/// 2007, line 13 of the algorithm.
// The marker leaves out what learners need not read.
// clang-format off
inline
//! [came]
Vec2 velocityFromPositions(Vec2 x, Vec2 before, double h)
{
    Vec2 v = (1 / h) * (x - before);
    return v;
}
//! [came]
// clang-format on

/// How a method adds up one force: onto what, and how much of it. `h` in frames.
using AddForce = void (*)(const Force &force, State &state, PointRange movers, double h);
using AddTorque = void (*)(const Torque &torque, State &state, PointRange movers, double h);

/// What forces are added to.
enum class AccumulationTarget { acceleration, velocity };

/// Where the source of the two stands.
struct ForceAccumulation
{
    AddForce force = nullptr;
    AddTorque torque = nullptr;
    Region forceRegion;
    Region torqueRegion;
    AccumulationTarget target = AccumulationTarget::acceleration;
};

/// Adds every force to State::acceleration and every torque to State::turning.
ForceAccumulation accelerationAccumulation();

/// The phases of one step in the making, from the parts that methods are made of. Each function adds the phases of
/// a share of the points; an effect that has nothing to do there adds none.
class PhaseBuilder
{
public:
    /// `h` in frames.
    PhaseBuilder(const Scene &scene, DirectionRule directionRule, double h);

    /// All points at once.
    PhasePoints allPoints() const;
    /// The scene's groups, in order.
    std::vector<PhasePoints> groups() const;

    /// Whether any point can move and goes on by itself.
    bool anyMoves() const { return !movingRanges(allPoints().points).empty(); }

    /// Each driver that the scene lists before everything else.
    void leadingDrivers();
    /// Each of the other drivers.
    void trailingDrivers();
    /// The same for those only that act once a step.
    void leadingImpulses();
    void trailingImpulses();
    /// Each driver that flows, for `part` of the step; and each that follows from the rest of the state.
    void continuousDrivers(double part);
    /// Each force and torque of the scene as `adding` adds it up.
    void forces(const PhasePoints &share, const ForceAccumulation &accumulation);
    /// The sum of all forces, and of all torques, at the places where points are.
    void accumulateForces(const PhasePoints &share);
    /// v = v + h a, from the gathered accelerations, for `part` of the step; likewise the spin.
    void kick(const PhasePoints &share, double part = 1.0);
    /// Each drag of the scene, for `part` of the step.
    void damping(const PhasePoints &share, double part = 1.0);
    /// Each drag of the scene that has no rate.
    void dampingWithoutRate(const PhasePoints &share);
    /// Forces, torques and drags in the very order in which the scene lists them.
    void inSceneOrder(const PhasePoints &share, const ForceAccumulation &accumulation);
    /// x = x + h v, of the points that go on by themselves, for `part` of the step; likewise the angle.
    void move(const PhasePoints &share, double part = 1.0);
    /// A phase of the method's own, which runs on all points.
    void add(Phase phase) { m_phases.push_back(std::move(phase)); }
    /// Before constraints, where a step is not one kick and one move: takes for the place that a point came from the
    /// one from which its velocity has led it. So the velocity that constraints give it is that one and what they add.
    void rewindPrevious(const PhasePoints &share);
    /// Each constraint of the scene, then the velocities of what they moved.
    void constraints(const PhasePoints &share);
    /// Each contact of the scene.
    void contacts(const PhasePoints &share);

    std::vector<Phase> take();

private:
    template <class Type, class Visit>
    void forEach(const PhasePoints &share, Visit &&visit) const;
    Phase phaseOf(const EffectPtr &effect, const PhasePoints &share) const;
    Phase ownPhase(const char *id, const char *title, const PhasePoints &share) const;
    template <class Accept>
    void drivers(std::size_t first, std::size_t end, double h, Accept &&accept);
    /// How many effects the scene lists before the first that is not a driver.
    std::size_t leading() const;
    /// `points` without those at either end that never feel forces.
    PointRange trimToDynamic(PointRange points) const;
    /// The stretches of points that can move and go on by themselves.
    std::vector<PointRange> movingRanges(PointRange points) const;
    bool spins() const { return m_scene.start.spin.rows() > 0; }
    bool hasConstraint(const PhasePoints &share) const;
    /// Keeps the places of points in State::previous; null where no constraint asks for them.
    std::function<void(State &, PointRange)> savePrevious(const PhasePoints &share) const;

    void force(const std::shared_ptr<const Force> &force, const PhasePoints &share,
               const ForceAccumulation &accumulation);
    void torque(const std::shared_ptr<const Torque> &torque, const PhasePoints &share,
                const ForceAccumulation &accumulation);
    void drag(const std::shared_ptr<const Drag> &drag, const PhasePoints &share, double part);
    void driver(const std::shared_ptr<const Driver> &driver, double h);
    void kickSpins(const PhasePoints &share, double part);
    void turnAngles(const PhasePoints &share, double part);
    void velocities(const PhasePoints &share);

    const Scene &m_scene;
    DirectionRule m_directionRule;
    double m_h;
    std::vector<Phase> m_phases;
    bool m_gathers = false;       ///< whether a phase of the step gathers already
    std::size_t m_keepBefore = 0; ///< the phase before which m_keep runs
    std::function<void(State &, PointRange)> m_keep;
};

/// A kernel that does work(state, points) with all of `points`, and with parts of them run by run.
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

/// Gives `phase`, which knows its points and its effect, its own kernel.
template <class Work>
void setWork(Phase &phase, Work work)
{
    phase.kernels.push_back(kernelOf(phase.points, std::move(work)));
    if (phase.effect && phase.effect->dependence() != Dependence::coupledPoints)
        phase.kernels.back().prepareFor = nullptr;
}

/// The same for a kernel before that of `phase`, on the same points.
template <class Work>
void setWorkBefore(Phase &phase, Work before)
{
    phase.kernels.insert(phase.kernels.begin(), kernelOf(phase.points, std::move(before)));
}

template <class Type, class Visit>
void PhaseBuilder::forEach(const PhasePoints &share, Visit &&visit) const
{
    for (const EffectPtr &effect : m_scene.effects) {
        const auto typed = sharedAs<Type>(effect);
        if (typed && typed->count(m_scene.start, share.points) > 0)
            visit(typed);
    }
}

}

#pragma once

#include "sim/method.h"

namespace sim {

/// Which of a scene's points a phase takes, and under which group's name.
struct Share
{
    Points points;
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
Vec2 came(Vec2 x, Vec2 before, double h)
{
    Vec2 v = (1 / h) * (x - before);
    return v;
}
//! [came]
// clang-format on

/// How a method adds up one force: onto what, and how much of it. `h` in frames.
using AddForce = void (*)(const Force &force, State &state, Points movers, double h);
using AddTorque = void (*)(const Torque &torque, State &state, Points movers, double h);

/// Where the source of the two stands.
struct Adding
{
    AddForce force = nullptr;
    AddTorque torque = nullptr;
    Region forceShown;
    Region torqueShown;
};

/// The phases of one step in the making, from the parts that methods are made of. Each function adds the phases of
/// a share of the points; an effect that has nothing to do there adds none.
class PhaseList
{
public:
    /// `h` in frames.
    PhaseList(const Scene &scene, Directions directions, double h);

    /// All points at once.
    Share everything() const;
    /// The scene's groups, in order.
    std::vector<Share> groups() const;

    /// Each driver that the scene lists before everything else.
    void driversFirst();
    /// Each of the other drivers.
    void driversLast();
    /// Each force and torque of the scene as `adding` adds it up.
    void forces(const Share &share, const Adding &adding);
    /// v = v + h a, from the gathered accelerations; likewise the spin.
    void kick(const Share &share);
    /// Each drag of the scene.
    void damping(const Share &share);
    /// Forces, torques and drags in the very order in which the scene lists them.
    void asListed(const Share &share, const Adding &adding);
    /// x = x + h v, of the points that go on by themselves; likewise the angle.
    void move(const Share &share);
    /// Each constraint of the scene, then the velocities of what they moved.
    void constraints(const Share &share);
    /// Each contact of the scene.
    void contacts(const Share &share);

    std::vector<Phase> take() { return std::move(m_phases); }

private:
    template <class Type, class Visit>
    void forEach(const Share &share, Visit &&visit) const;
    Phase phaseOf(const EffectPtr &effect, const Share &share) const;
    Phase ownPhase(const char *id, const char *title, const Share &share) const;
    /// The stretches of points that can move and go on by themselves.
    std::vector<Points> inert(Points points) const;
    bool spins() const { return m_scene.start.spin.rows() > 0; }
    bool hasConstraint(const Share &share) const;

    void force(const std::shared_ptr<const Force> &force, const Share &share, const Adding &adding);
    void torque(const std::shared_ptr<const Torque> &torque, const Share &share, const Adding &adding);
    void drag(const std::shared_ptr<const Drag> &drag, const Share &share);
    void driver(const std::shared_ptr<const Driver> &driver);
    void kickSpins(const Share &share);
    void turnAngles(const Share &share);
    void velocities(const Share &share);

    const Scene &m_scene;
    Directions m_directions;
    double m_h;
    std::vector<Phase> m_phases;
};

}

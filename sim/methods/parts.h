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

/// What damping leaves of a velocity.
// The marker leaves out what learners need not read.
// clang-format off
inline
//! [damp]
Vec2 damp(Vec2 v, double keep)
{
    v = keep * v;
    return v;
}
//! [damp]
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

/// How a method adds up one force: onto what, and how much of it. `h` in frames.
using AddForce = void (*)(const Force &force, State &state, Points movers, double h);

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

    /// Each force of the scene as `add` adds it up; `shown` is the source of `add`.
    void forces(const Share &share, AddForce add, const Region &shown);
    /// v = v + h a, from the gathered accelerations.
    void kick(const Share &share);
    /// v = keep v, for each drag of the scene.
    void damping(const Share &share);
    /// x = x + h v.
    void move(const Share &share);
    /// Each contact of the scene.
    void contacts(const Share &share);

    std::vector<Phase> take() { return std::move(m_phases); }

private:
    template <class Type, class Visit>
    void forEach(const Share &share, Visit &&visit) const;
    Phase phaseOf(const EffectPtr &effect, const Share &share) const;
    bool canMove(Points points) const;

    const Scene &m_scene;
    Directions m_directions;
    double m_h;
    std::vector<Phase> m_phases;
};

}

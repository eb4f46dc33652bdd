#pragma once

#include "sim/method.h"

namespace sim {

/// Which of a scene's points a phase takes, and under which group's name.
struct Share
{
    Points points;
    int group = -1;
};

/// All points at once.
Share everything(const Scene &scene);

/// Whether any of `points` can move in `scene`.
bool canMove(const Scene &scene, Points points);

/// One step of velocity: h in frames, a in px/frame^2.
//! [kick]
inline Vec2 kick(Vec2 v, Vec2 a, double h)
{
    v = v + h * a;
    return v;
}
//! [kick]

/// What damping leaves of a velocity.
//! [damp]
inline Vec2 damp(Vec2 v, double keep)
{
    v = keep * v;
    return v;
}
//! [damp]

/// One step of position.
//! [move]
inline Vec2 move(Vec2 x, Vec2 v, double h)
{
    x = x + h * v;
    return x;
}
//! [move]

// The phases that methods are made of. A phase for an effect that has nothing to do among `share` is not added.

/// Each force of the scene, as `run` applies it; `shown` is the region that says how the method adds it up.
using RunForce = std::function<void(const Force &force, State &state)>;
void addForcePhases(std::vector<Phase> &phases, const Scene &scene, Share share, Directions directions,
                    const Region &shown, const RunForce &run);
/// v = v + h a, from the gathered accelerations.
void addKickPhase(std::vector<Phase> &phases, const Scene &scene, Share share, double h);
/// v = keep v, for each drag of the scene.
void addDampPhases(std::vector<Phase> &phases, const Scene &scene, Share share, Directions directions,
                   double h);
/// x = x + h v.
void addMovePhase(std::vector<Phase> &phases, const Scene &scene, Share share, double h);
/// Each contact of the scene.
void addContactPhases(std::vector<Phase> &phases, const Scene &scene, Share share, Directions directions);

}

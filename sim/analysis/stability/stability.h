#pragma once

#include "sim/analysis/stability/modes/dominant_effect.h"

#include <vector>

namespace sim {

/// What bounds the step of a run, in one state.
enum class Bound {
    stiffness, ///< the stiffest swing: see Stability::limit
    none,      ///< nothing: the method has no such bound
    tolerance, ///< the method keeps its own steps short enough
    noSprings, ///< nothing here swings: what acts has no stiffness
    unknown,   ///< pulls are not finite here
    tooLarge,  ///< more points than maxAnalysedPoints: it would take too long to find out
};

/// The most points whose swings are looked for together.
constexpr int maxAnalysedPoints = 20'000;

/// What growth looks like, from one step to the next.
enum class GrowthKind {
    alternating, ///< to the other side at each step, farther each time
    monotonic,   ///< off in one direction, faster and faster
    oscillating, ///< round and round, or to and fro, wider each time
};

/// How far a fixed step is from where a method begins to fail, in one state.
struct Stability
{
    Bound bound = Bound::unknown;
    double h = 0.0;      ///< frames
    double limit = 0.0;  ///< frames; 0: it grows at any step; infinity: damping holds every step
    double growth = 1.0; ///< a frame, beyond what the motion itself does; at most 1 where the step holds
    GrowthKind growthKind = GrowthKind::alternating; ///< at the limit, or of what grows
    DominantEffect dominant;
    std::vector<int> points;        ///< that move most in that pattern: up to three
    std::vector<EffectPtr> ignored; ///< that act here, and that this does not tell of
    double stiffness = 0.0;         ///< 1/frame^2, of the stiffest swing

    /// Of the limit: 1 is at it. Infinite where the limit is 0.
    double share() const;
    /// Whether small disturbances stay small.
    bool holds() const { return bound != Bound::unknown && growth <= 1.0; }
};

/// Measures `method` at steps of `h` frames on `scene` near `state`, contacts, constraints and jumps left out: the
/// pulls' slopes there are its springs. What must not grow is every disturbance that the motion itself lets rest or
/// fade: an eigenvalue of the method's own step that leaves the unit circle, farther than that of the motion, is the
/// step's doing. For a method that takes all points at once, under one drag, each swing of the scene is probed by
/// itself; for all others, one step of the whole scene.
/// @throws Error when the method cannot compute such a scene
Stability stabilityOf(const Scene &scene, const State &state, const Method &method, double h);

/// Only how much faster than the motion itself disturbances grow, a frame: at most 1 where the step holds. For methods
/// whose steps have a length; 1 where nothing swings.
double growthOf(const Scene &scene, const State &state, const Method &method, double h);

}

#pragma once

#include "sim/analysis/stability/modes/dominant_effect.h"

#include <vector>

namespace sim {

/// The reason why the step of a run is limited, or not, in one state.
enum class Bound {
    stiffness, ///< the stiffest mode, see Stability::limit
    none,      ///< nothing: the method has no stability limit
    tolerance, ///< nothing: the method adapts its steps to a tolerance
    noSprings, ///< nothing: no force here has stiffness
    unknown,   ///< unknown, because forces are not finite
    velocity,  ///< unknown, because a force depends on velocities, and only positions are analysed
    tooLarge,  ///< unknown, because more than maxAnalysedPoints points would take too long to analyse
};

/// The largest number of points of a scene that is analysed.
constexpr int maxAnalysedPoints = 20'000;

/// How a growing disturbance changes from step to step.
enum class GrowthKind {
    alternating, ///< changes sign at each step, and grows
    monotonic,   ///< grows in one direction
    oscillating, ///< rotates or oscillates, and grows
};

/// The distance of a fixed step from the stability limit of a method, in one state.
struct Stability
{
    Bound bound = Bound::unknown;
    double h = 0.0;     ///< frames
    double limit = 0.0; ///< frames; 0: unstable at any step; infinity: damping makes every step stable
    /// Factor per frame, without that of the motion itself; at most 1 if the step is stable.
    double growth = 1.0;
    /// Of the growing mode, or of the mode that grows first past the limit.
    GrowthKind growthKind = GrowthKind::alternating;
    DominantEffect dominant;        ///< in that mode
    std::vector<int> points;        ///< points that move most in that mode, up to three
    std::vector<EffectPtr> ignored; ///< effects that act here and that the analysis leaves out
    double stiffness = 0.0;         ///< 1/frame^2, of the stiffest mode

    /// Returns the step divided by the limit. Infinite if the limit is 0.
    double share() const;
    /// Returns whether small disturbances stay small.
    bool holds() const { return bound != Bound::unknown && bound != Bound::velocity && growth <= 1.0; }
};

/// Computes the stability of `method` at steps of `h` frames on `scene`, linearised at `state`. Contacts,
/// constraints and jumps are left out. The step is unstable if it has an eigenvalue outside the unit circle,
/// farther out than the motion itself accounts for.
///
/// The modes of the scene are analysed one by one if the method computes all points at once and all have the
/// same damping rate. Otherwise one step of the whole scene is analysed.
/// @throws Error when the method cannot compute such a scene
Stability stabilityOf(const Scene &scene, const State &state, const Method &method, double h);

/// Returns Stability::growth alone: the factor per frame by which disturbances grow faster than the motion
/// itself. At most 1 if the step is stable, and 1 if no force has stiffness. For methods with a fixed step.
double growthOf(const Scene &scene, const State &state, const Method &method, double h);

}

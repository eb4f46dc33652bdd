#pragma once

#include "sim/pipeline/method.h"

#include <complex>
#include <vector>

namespace sim {

/// How one effect's pulls change with places, near one state.
struct LinearPart
{
    EffectPtr effect;
    std::vector<Jacobian::Entry>
        entries; ///< in 1/frame^2, of all points at once; the same row and column add up
};

/// A scene near one state: every pull as its slopes there, q'' = J q - c q'. The scene in it goes with any method, so
/// that the method itself tells what its steps do to a small disturbance. Its places are how far things are from
/// where they were, in px (or degrees).
struct LinearisedScene
{
    Scene scene;
    /// The rows of q that go on by themselves: x of each point, then y of each, then each angle.
    std::vector<int> rows;
    std::vector<LinearPart> parts; ///< those that have a slope, in the scene's order
    /// What slopes don't tell and no step here computes: contacts, constraints, drivers that act once a step, drags
    /// without a rate.
    std::vector<EffectPtr> ignored;
    std::vector<double> rates; ///< the drag c of each of the rows, in 1/frame
    bool finite = true;        ///< whether all slopes are

    double leastRate() const;
    /// Whether one drag slows all rows alike.
    bool sameRate() const;
};

/// The scene near `state`, for `method`. What pushes apart is left out, for each pair of points: a spring pressed
/// together pushes sideways, and what grows by that grows in the motion itself. Forces that know no slopes give
/// differences.
LinearisedScene linearise(const Scene &scene, const State &state, const Method &method);

/// One point that swings, x'' = lambda x - c x': along a line, or, for a lambda that is not real, in the plane under the
/// matrix (re, -im; im, re). lambda in 1/frame^2, c in 1/frame.
LinearisedScene oscillator(const Method &method, std::complex<double> lambda, double c);

}

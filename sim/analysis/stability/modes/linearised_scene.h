#pragma once

#include "sim/pipeline/method.h"

#include <complex>
#include <vector>

namespace sim {

/// The Jacobian of one effect near one state.
struct EffectJacobian
{
    EffectPtr effect;
    std::vector<Jacobian::Entry> entries; ///< 1/frame^2, of all points; equal rows and columns add up
};

/// A scene linearised at one state: q'' = J q - c q', with the Jacobian J of all forces. It contains an
/// ordinary scene, so any method can compute what its steps do to a small disturbance. Positions in it are
/// displacements from that state, in px (or degrees).
struct LinearisedScene
{
    Scene scene;
    /// The dynamic rows of q. The order of q is x of each point, then y of each point, then each angle.
    std::vector<int> rows;
    std::vector<EffectJacobian> effectJacobians; ///< only effects with entries, in the scene's order
    /// Effects that are left out: contacts, constraints, drivers that act once per step, drags without a
    /// rate, and torques without a Jacobian.
    std::vector<EffectPtr> ignored;
    std::vector<double> rates; ///< 1/frame, damping rate c of each of the rows
    bool finite = true;        ///< whether all Jacobians are finite

    /// Returns the smallest damping rate of the rows, 1/frame.
    double minRate() const;
    /// Returns whether all rows have the same damping rate.
    bool hasUniformRate() const;
};

/// Returns `scene` linearised at `state`, for `method`. The Jacobian of each pair of points is projected to
/// the nearest negative semi-definite one. A compressed spring pushes sideways, but that growth belongs to
/// the motion itself. A force without a Jacobian is differentiated numerically.
LinearisedScene linearise(const Scene &scene, const State &state, const Method &method);

/// Returns one point with x'' = lambda x - c x'. It moves along a line or, for a complex lambda, in the plane
/// under the matrix (re, -im; im, re). lambda is in 1/frame^2, c in 1/frame.
LinearisedScene oscillator(const Method &method, std::complex<double> lambda, double c);

}

#pragma once

#include "sim/effects/pairs/pair_jacobian.h"

namespace sim {

/// Returns the matrix nearest to `jacobian` (in the Frobenius norm) with x . A x <= 0 for all x. The
/// symmetric part is projected onto the negative semi-definite matrices, and the antisymmetric part stays.
/// The result depends continuously on `jacobian`, so derivatives by finite differences give the same as exact
/// ones, up to their error. It has the units of `jacobian`, and is not finite if `jacobian` is not.
/// Source: Higham, "Computing a nearest symmetric positive semidefinite matrix", 1988, theorem 2.1.
PairJacobian nearestNegativeSemidefinite(PairJacobian jacobian);

/// Returns the entries of `jacobian` (of a scene of `points` points) with each block of 2 x 2 replaced by its
/// nearestNegativeSemidefinite(), in the order of Jacobian::entries(). For derivatives by the position of
/// another point, the negative block is replaced. Entries of angles stay the same.
///
/// A compressed spring pushes its ends sideways, and the more the farther they have moved (buckling). Without
/// that part, the matrix of an implicit method is positive definite (in the norm weighted by the masses).
/// Then an analysis of the stability of a step does not confuse buckling with instability of the method.
/// Source: Teran et al., "Robust quasistatic finite elements and flesh simulation", 2005, section 5 (for
/// elements); Choi and Ko, "Stable but responsive cloth", 2002, section 4.2 (for springs).
std::vector<Jacobian::Entry> nearestNegativeSemidefiniteBlocks(const Jacobian &jacobian, int points);

}

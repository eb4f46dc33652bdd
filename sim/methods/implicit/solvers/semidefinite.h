#pragma once

#include "sim/effects/pairs/pair_jacobian.h"

namespace sim {

/// Returns the part of `slope` that pushes in no direction: its symmetric part is projected onto the negative
/// semi-definite matrices, and its antisymmetric part stays. This is the nearest matrix (in the Frobenius norm) for
/// which x . A x > 0 nowhere. It depends continuously on `slope`: a slope found by differences, symmetric but for
/// rounding, gives the same as the exact one. Units as those of `slope`. A slope that is not finite gives one that is
/// not finite either.
/// Source: Higham, "Computing a nearest symmetric positive semidefinite matrix", 1988, theorem 2.1.
PairJacobian nearestNegativeSemidefinite(PairJacobian jacobian);

/// Returns the entries of `slopes` (of a scene of `points` points), each pull's block replaced by its nearestNegativeSemidefinite(); in
/// the order of Jacobian::entries(). How a point's pull changes with another point's place has the opposite sign. Angles
/// stay as they are.
///
/// A spring that is pressed together pushes its ends further sideways the farther they are off. Without that part the
/// matrix of an implicit method, with 1 on the diagonal, is positive definite (for equal masses; for others in the norm
/// that the masses make), and the stability of a step is not mixed up with a motion that grows by itself.
/// Source: Teran et al., "Robust quasistatic finite elements and flesh simulation", 2005, section 5 (the same for
/// elements); Choi and Ko, "Stable but responsive cloth", 2002, section 4.2 (for springs).
std::vector<Jacobian::Entry> nearestNegativeSemidefiniteBlocks(const Jacobian &jacobian, int points);

}

#pragma once

#include "sim/scene/effect.h"

#include <Eigen/Core>

#include <vector>

namespace sim {

/// The ways to solve for an implicit step, by what its matrix is like.
enum class Solver {
    dense,     ///< few unknowns: with all their zeros
    sparse,    ///< factors, without zeros
    conjugate, ///< conjugate gradients, spring by spring; where these find nothing, factors
};

/// Many points in a net of springs: there factors fill with numbers, as each round of springs closes. Chains, stars
/// and trees of springs have no rounds, and factors as short as themselves. `entries`: 1 on the diagonal left out.
Solver solverFor(const std::vector<Jacobian::Entry> &entries, int size);

/// The solution of (1 + entries) x = right; not a number where there is none. `weights`: what each row has to be
/// multiplied by so that a spring that pulls both its ends alike is the same on both sides of the diagonal: the mass,
/// over the share of a pull that the step takes.
Eigen::VectorXd solved(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &right,
                       const Eigen::VectorXd &weights);

}

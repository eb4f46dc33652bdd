#pragma once

#include "sim/scene/effect.h"

#include <Eigen/Core>

#include <vector>

namespace sim {

/// The solvers for the matrix of an implicit step.
enum class Solver {
    dense,     ///< LU factors of the full matrix, for few unknowns
    sparse,    ///< sparse LU factors
    conjugate, ///< conjugate gradients; sparse LU factors if they fail
};

/// Returns the fastest solver for a matrix of `size` rows. Large nets of springs get conjugate gradients,
/// because each cycle of springs fills the factors with further numbers. Chains, stars and trees have no
/// cycles, and their factors stay sparse. `entries`: the matrix without the 1 on the diagonal.
Solver solverFor(const std::vector<Jacobian::Entry> &entries, int size);

/// Returns the solution x of (1 + entries) x = right, or NaN if there is none. `weights`: the factors of the
/// rows that make the matrix symmetric if forces are: the mass divided by `share` of ImplicitStep::solve().
Eigen::VectorXd solved(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &right,
                       const Eigen::VectorXd &weights);

}

#pragma once

#include "sim/scene/effect.h"

#include <Eigen/Core>

#include <optional>
#include <utility>
#include <vector>

namespace sim {

/// The matrix 1 + entries of an implicit step, with each row multiplied by a weight that makes it symmetric.
/// It is stored as blocks of 2 x 2: one per point and, because of the symmetry, only one per spring.
class SpringMatrix
{
public:
    /// Returns the matrix of `entries` (rows: x of all points, then y of all points), each row multiplied by
    /// its weight. Returns nothing if it is not symmetric up to rounding or a weight is not finite.
    static std::optional<SpringMatrix> of(const std::vector<Jacobian::Entry> &entries,
                                          const Eigen::VectorXd &weights);

    int points() const { return static_cast<int>(m_pointBlocks.size()); }
    /// Computes the product with `x`. In both vectors x and y of a point are neighbours (see interleaved()).
    void multiply(const Eigen::VectorXd &x, Eigen::VectorXd &product) const;
    /// Returns the diagonal, in the same order.
    Eigen::VectorXd diagonal() const;

private:
    /// The derivatives of the force on point `a` by the position of point `b`.
    struct SpringBlock
    {
        int a = 0; ///< below b
        int b = 0;
        double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;
    };
    /// The derivatives of the force on a point by its position.
    struct PointBlock
    {
        double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;
    };

    void assemble(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &weights);
    bool isSymmetric(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &weights) const;

    std::vector<PointBlock> m_pointBlocks;
    std::vector<SpringBlock> m_springBlocks;
};

/// A solution by conjugate gradients.
struct ConjugateResult
{
    Eigen::VectorXd x;  ///< NaN if the method failed
    int iterations = 0; ///< number of products with the matrix
};

/// Returns the solution x of matrix x = right by conjugate gradients with the diagonal as preconditioner. In
/// both vectors x and y of a point are neighbours. Stops when the norm of the residual is `tolerance` times
/// that of `right`. Fails if the matrix is not positive definite, or after 20 products per point.
/// Source: Hestenes and Stiefel, 1952; Shewchuk, "An introduction to the conjugate gradient method without
/// the agonizing pain", 1994, section B3.
ConjugateResult conjugateGradients(const SpringMatrix &matrix, const Eigen::VectorXd &right,
                                   double tolerance);

/// Returns a vector of all x, then all y, reordered so that x and y of a point are neighbours.
Eigen::VectorXd interleaved(const Eigen::VectorXd &columns);
/// Returns the vector in the original order: all x, then all y.
Eigen::VectorXd separated(const Eigen::VectorXd &pairs);

}

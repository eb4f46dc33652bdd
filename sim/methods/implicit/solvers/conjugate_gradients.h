#pragma once

#include "sim/scene/effect.h"

#include <Eigen/Core>

#include <optional>
#include <utility>
#include <vector>

namespace sim {

/// The matrix of an implicit step, 1 + entries, as the springs that make it up: its product with a vector goes from
/// spring to spring, and no matrix is put together. Its rows are weighted so that a spring that pulls both its ends
/// alike is the same on both sides of the diagonal; of such springs one side is kept.
class SpringMatrix
{
public:
    /// Rows: x of each point, then y of each. `weights`: what each row is multiplied by. Empty where the two sides of
    /// the diagonal differ by more than rounding, and where a weight is not finite.
    static std::optional<SpringMatrix> of(const std::vector<Jacobian::Entry> &entries,
                                          const Eigen::VectorXd &weights);

    int points() const { return static_cast<int>(m_own.size()); }
    /// The product with `x`, whose numbers are x and y of each point in turn.
    void multiply(const Eigen::VectorXd &x, Eigen::VectorXd &into) const;
    /// Its diagonal, in that order.
    Eigen::VectorXd diagonal() const;

private:
    /// How one point's pull changes with another point's place.
    struct Between
    {
        int a = 0; ///< below b
        int b = 0;
        double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;
    };
    /// How it changes with its own.
    struct Own
    {
        double xx = 0.0, xy = 0.0, yx = 0.0, yy = 0.0;
    };

    void gather(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &weights);
    bool mirrors(const std::vector<Jacobian::Entry> &entries, const Eigen::VectorXd &weights) const;

    std::vector<Own> m_own;
    std::vector<Between> m_between;
};

/// A solution, and how many products it took.
struct Conjugate
{
    Eigen::VectorXd x; ///< not finite where there is none to be found in this way
    int iterations = 0;
};

/// The solution of matrix x = right, both with x and y of each point in turn, by conjugate gradients, each number
/// divided by its place on the diagonal. Stops when what is missed has become `tolerance` of `right`. Finds nothing
/// where the matrix has a negative part, or after 20 products a point.
/// Source: Hestenes and Stiefel, 1952; Shewchuk, "An introduction to the conjugate gradient method without the
/// agonizing pain", 1994, section B3.
Conjugate conjugateGradients(const SpringMatrix &matrix, const Eigen::VectorXd &right, double tolerance);

/// A vector of all x, then all y, as x and y of each point in turn; and back.
Eigen::VectorXd inTurn(const Eigen::VectorXd &columns);
Eigen::VectorXd inColumns(const Eigen::VectorXd &turns);

}

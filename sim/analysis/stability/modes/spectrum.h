#pragma once

#include <Eigen/Dense>

#include <complex>
#include <functional>
#include <vector>

namespace sim {

/// Some eigenvalues of a matrix in descending order of modulus, with their eigenvectors.
class Spectrum
{
public:
    using Vector = Eigen::VectorXd;
    /// Writes the matrix times `in` to `out`.
    using Product = std::function<void(const Vector &in, Vector &out)>;

    /// Up to this size all eigenvalues are computed, exact to rounding.
    static constexpr int maxDenseSize = 60;

    /// Computes the spectrum of the matrix of `size` rows that `product` multiplies by. Uses Arnoldi's method
    /// with a fixed start vector. It restarts from the largest eigenvectors until the first eigenvalue
    /// converges to 1e-6, or for 8 rounds. Of equal eigenvalues one is found.
    /// Source: Saad, "Numerical methods for large eigenvalue problems", algorithms 6.2 and 6.3.
    Spectrum(int size, const Product &product);

    const std::vector<std::complex<double>> &values() const { return m_values; }
    /// Returns a bound on the rounding errors of values(). A matrix with large entries gives small
    /// eigenvalues a large relative error.
    double rounding() const { return m_rounding; }
    /// Returns the modulus of the first value minus rounding(), at least 0.
    double radius() const;
    /// Returns the eigenvector of values()[index], of length 1.
    Eigen::VectorXcd vector(std::size_t index) const;

private:
    void solveDense(int size, const Product &product);
    void buildKrylovBasis(const Product &product, Vector start);
    void solveSmall(const Eigen::MatrixXd &small);

    Eigen::MatrixXd m_basis;         ///< orthonormal columns
    Eigen::MatrixXcd m_smallVectors; ///< eigenvectors in that basis, in the order of m_values
    std::vector<std::complex<double>> m_values;
    double m_residual = 0.0; ///< norm of the last product outside the basis
    double m_rounding = 0.0;
};

}

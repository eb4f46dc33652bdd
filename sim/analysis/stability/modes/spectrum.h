#pragma once

#include <Eigen/Dense>

#include <complex>
#include <functional>
#include <vector>

namespace sim {

/// Some eigenvalues of a matrix, the largest in modulus first, with their vectors.
class Spectrum
{
public:
    using Vector = Eigen::VectorXd;
    using Product = std::function<void(const Vector &in, Vector &out)>;

    /// Up to this size all eigenvalues are found, exactly but for rounding.
    static constexpr int maxDenseSize = 60;

    /// Of the matrix of `size` rows that `product` multiplies by: the method of Arnoldi from a start that is the same
    /// every time, begun again from the largest ones until they settle (to 1e-6) or for 8 rounds. Where eigenvalues
    /// are equal, one of them is found.
    /// Source: Saad, "Numerical methods for large eigenvalue problems", algorithms 6.2 and 6.3.
    Spectrum(int size, const Product &product);

    const std::vector<std::complex<double>> &values() const { return m_values; }
    /// By how much rounding may have moved the values: a matrix of large numbers moves small ones far.
    double rounding() const { return m_rounding; }
    /// The modulus of the first value, less what rounding may have added.
    double radius() const;
    /// The vector of values()[index], of length 1.
    Eigen::VectorXcd vector(std::size_t index) const;

private:
    void columnByColumn(int size, const Product &product);
    void round(const Product &product, Vector start);
    void sort(const Eigen::MatrixXd &small);

    Eigen::MatrixXd m_basis;  ///< a column each
    Eigen::MatrixXcd m_small; ///< vectors in that basis, in the order of m_values
    std::vector<std::complex<double>> m_values;
    double m_left = 0.0; ///< what the basis leaves of the last product
    double m_rounding = 0.0;
};

}

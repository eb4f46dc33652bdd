#pragma once

namespace sim {

/// The polynomial of degree 5 in s with given positions, velocities and accelerations at s = 0 and s = 1
/// (Hermite interpolation). In Newton form, the nodes are 0, 0, 0, 1, 1, 1 and the divided differences are
/// `c`. With s = t / h, its error for a smooth motion is of order h^6.
/// Source: Stoer and Bulirsch, "Introduction to numerical analysis", section 2.1.5.
struct Quintic
{
    double c[6] = {};

    /// Returns the polynomial through the given values at s = 0 and s = 1. Derivatives are by s.
    static Quintic through(double x0, double v0, double a0, double x1, double v1, double a1)
    {
        const double rise = x1 - x0;
        const double third = rise - v0 - a0 / 2; // [0, 0, 0, 1]
        const double fourth = v1 - rise - (rise - v0) - third;
        const double fifth = (a1 / 2 - (v1 - rise)) - (v1 - rise - (rise - v0)) - fourth;
        return {{x0, v0, a0 / 2, third, fourth, fifth}};
    }
};

/// The value of a polynomial in that Newton form and its derivative by s.
struct NewtonPolynomial
{
    double value = 0.0;
    double derivative = 0.0;

    /// Evaluates a polynomial with `terms` (6 or 7) coefficients, `stride` numbers apart in memory, at s. The
    /// factor of the seventh coefficient is s^3 (s - 1)^3.
    template <int terms>
    static NewtonPolynomial at(const double *coefficients, int stride, double s)
    {
        const double sMinus1 = s - 1;
        const double nodes[] = {s, s, s, sMinus1, sMinus1, sMinus1};
        NewtonPolynomial sum = {coefficients[(terms - 1) * stride], 0.0};
#pragma GCC unroll 8 // so that a loop over polynomials can be vectorised
        for (int j = terms - 2; j >= 0; --j) {
            sum.derivative = sum.derivative * nodes[j] + sum.value;
            sum.value = sum.value * nodes[j] + coefficients[j * stride];
        }
        return sum;
    }

    /// Returns the seventh coefficient for which the second derivative at s = 1/2 is `secondDerivative`,
    /// given the first six. The factor s^3 (s - 1)^3 and its first two derivatives are 0 at both ends. Its
    /// second derivative in the middle is 3/8.
    static double seventh(const double *c, int stride, double secondDerivative)
    {
        const double ofQuintic = 2 * c[2 * stride] + 3 * c[3 * stride] - c[5 * stride] / 2;
        return (secondDerivative - ofQuintic) * (8.0 / 3.0);
    }
};

}

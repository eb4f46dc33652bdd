#pragma once

namespace sim {

/// The polynomial of degree 5 in s that has given places, velocities and accelerations at s = 0 and s = 1, in Newton's
/// form: its nodes are 0, 0, 0, 1, 1, 1, and `c` its divided differences. With s = t / h and derivatives by s it is off
/// a smooth motion by h^6.
/// Source: Stoer and Bulirsch, "Introduction to numerical analysis", section 2.1.5.
struct Quintic
{
    double c[6] = {};

    /// @param x, v, a at 0 and at 1, with derivatives by s
    static Quintic through(double x0, double v0, double a0, double x1, double v1, double a1)
    {
        const double rise = x1 - x0;
        const double third = rise - v0 - a0 / 2; // [0, 0, 0, 1]
        const double fourth = v1 - rise - (rise - v0) - third;
        const double fifth = (a1 / 2 - (v1 - rise)) - (v1 - rise - (rise - v0)) - fourth;
        return {{x0, v0, a0 / 2, third, fourth, fifth}};
    }
};

/// Value and derivative at s of a polynomial in that form with `terms` coefficients, `apart` numbers apart in memory.
/// The seventh belongs to s^3 (s - 1)^3.
struct NewtonPolynomial
{
    double value = 0.0;
    double derivative = 0.0;

    template <int terms>
    static NewtonPolynomial at(const double *coefficients, int apart, double s)
    {
        const double back = s - 1;
        const double nodes[] = {s, s, s, back, back, back};
        NewtonPolynomial sum = {coefficients[(terms - 1) * apart], 0.0};
#pragma GCC unroll 8 // so that several polynomials run side by side
        for (int j = terms - 2; j >= 0; --j) {
            sum.derivative = sum.derivative * nodes[j] + sum.value;
            sum.value = sum.value * nodes[j] + coefficients[j * apart];
        }
        return sum;
    }

    /// Returns the seventh coefficient with which the second derivative at s = 1/2 is `wanted`, given the first six: a
    /// polynomial of degree 6. s^3 (s - 1)^3 is 0 at both ends up to its second derivative, and bends by 3/8 in the middle.
    static double seventh(const double *c, int apart, double wanted)
    {
        const double bends = 2 * c[2 * apart] + 3 * c[3 * apart] - c[5 * apart] / 2;
        return (wanted - bends) * (8.0 / 3.0);
    }
};

}

#pragma once

#include "sim/methods/adaptive/steps/step_rule.h"
#include "sim/methods/fixed/tableau.h"

namespace sim {

/// Where a step's numbers stand, for what a pair computes from them. Everything is in the numbers that damping does
/// not slow (see StageWeights): u is what v would be without it.
struct StepData
{
    const double *place = nullptr;  ///< at the start
    const double *speed = nullptr;  ///< v at the start, which is u there
    const double *speeds = nullptr; ///< the velocity of each stage: `size` numbers each
    const double *slopes = nullptr; ///< the acceleration of each stage
    int size = 0;
    int first = 0; ///< the rows that this is about, which all have the same rate
    int end = 0;
    double rate = 0.0;            ///< 1/frame
    double h = 0.0;               ///< frames
    const double *keep = nullptr; ///< what damping leaves of a velocity until each stage
};

/// What makes an adaptive Runge-Kutta method: a tableau whose last stage stands at the end of the step, an estimate
/// of the step's error, and a polynomial between its ends.
class EmbeddedPair
{
public:
    virtual ~EmbeddedPair() = default;
    virtual const Tableau &tableau() const = 0;
    /// The order of the step.
    virtual int order() const = 0;
    /// The error of a step, from weights: for the difference to a method of lower order, and for that to a still
    /// lower one (if it has one).
    virtual const Tableau::Row &error() const = 0;
    virtual const Tableau::Row &lowerError() const = 0;
    virtual bool hasLowerError() const = 0;

    /// How many more stages its polynomial needs: rows of the tableau past the last.
    virtual int extraStages() const = 0;
    /// How many columns of numbers are kept for the polynomial.
    virtual int denseColumns() const = 0;
    /// Computes the polynomial's columns for the rows of `step`.
    /// @param endPlace, endSpeed x and v at the end
    virtual void makeDense(const StepData &step, const double *endPlace, const double *endSpeed,
                           double *columns) const = 0;
    /// As StepRule has it.
    virtual void dense(const double *columns, int size, int first, int end, const DenseTime &when,
                       double *place, double *speed) const = 0;
};

/// Dormand and Prince's pair of orders 5 and 4; between the ends of a step the polynomial of degree 5 that has their
/// places, velocities and accelerations.
/// Source: Dormand and Prince, "A family of embedded Runge-Kutta formulae", 1980.
const EmbeddedPair &dormandPrincePair();

/// Hairer and Wanner's pair of order 8, with error estimates of orders 5 and 3, and their polynomial of order 7.
/// Source: Hairer, Norsett and Wanner, "Solving ordinary differential equations I", sections II.5 and II.6; the
/// numbers are those of their program DOP853.
const EmbeddedPair &dop853Pair();

}

#pragma once

#include "sim/methods/adaptive/steps/step_rule.h"
#include "sim/methods/fixed/tableau.h"

namespace sim {

/// The data of a finished step, from which a pair computes its dense output. Below, u is the undamped
/// velocity (see StageWeights). Each array has `size` numbers if not stated otherwise.
struct StepData
{
    const double *x = nullptr;             ///< positions at the start
    const double *v = nullptr;             ///< velocities v at the start, where u = v
    const double *velocities = nullptr;    ///< velocities of each stage, `size` numbers per stage
    const double *accelerations = nullptr; ///< accelerations of each stage, `size` numbers per stage
    int size = 0;                          ///< rows of q
    int first = 0;                ///< first row to compute; all rows to compute have the same damping rate
    int end = 0;                  ///< the row after the last one to compute
    double rate = 0.0;            ///< 1/frame, damping rate
    double h = 0.0;               ///< frames, length of the step
    const double *keep = nullptr; ///< damping factor at each stage
};

/// An embedded pair of explicit Runge-Kutta methods: a tableau whose last stage is at the end of the step, an
/// error estimate, and dense output.
class EmbeddedPair
{
public:
    virtual ~EmbeddedPair() = default;
    virtual const Tableau &tableau() const = 0;
    /// Returns the order of a step.
    virtual int order() const = 0;
    /// Returns the stage weights of the error estimate: the difference to a method of lower order.
    /// lowerError() is the difference to a method of still lower order, if hasLowerError().
    virtual const Tableau::Row &error() const = 0;
    virtual const Tableau::Row &lowerError() const = 0;
    virtual bool hasLowerError() const = 0;

    /// Returns the number of further stages for the dense output: rows of the tableau after the last stage.
    virtual int extraStages() const = 0;
    /// Returns the number of columns that the dense output needs.
    virtual int denseColumns() const = 0;
    /// Computes the columns of the dense output for the rows of `step`.
    /// @param endX, endV positions and velocities at the end
    virtual void makeDense(const StepData &step, const double *endX, const double *endV,
                           double *columns) const = 0;
    /// See StepRule::dense().
    virtual void dense(const double *columns, int size, int first, int end, const DenseTime &time, double *x,
                       double *v) const = 0;
};

/// Returns the pair of Dormand and Prince of orders 5 and 4. Its dense output is the polynomial of degree 5
/// with the positions, velocities and accelerations at both ends of the step.
/// Source: Dormand and Prince, "A family of embedded Runge-Kutta formulae", 1980.
const EmbeddedPair &dormandPrincePair();

/// Returns the pair of Hairer and Wanner of order 8, with error estimates of orders 5 and 3 and dense output
/// of order 7.
/// Source: Hairer, Norsett and Wanner, "Solving ordinary differential equations I", sections II.5 and II.6;
/// the coefficients are those of their program DOP853
const EmbeddedPair &dop853Pair();

}

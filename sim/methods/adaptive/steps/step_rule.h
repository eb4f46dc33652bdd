#pragma once

#include "sim/methods/adaptive/contact_accelerations.h"
#include "sim/methods/fixed/tableau.h"

#include <string>
#include <vector>

namespace sim {

/// What the weights of a Nystrom method come to for a step's length and a damping. See RungeKuttaNystrom.
struct NystromWeights;

/// A step in the making. Each pointer leads to Flow::size() numbers, if nothing else is said.
struct StepAttempt
{
    ContactAccelerations &accelerations;
    const OdeSystem &system;
    double start = 0.0; ///< frames since the last whole one
    double h = 0.0;     ///< frames

    const double *place = nullptr; ///< where it begins: x, v and a
    const double *speed = nullptr;
    const double *slope = nullptr;
    double *endPlace = nullptr; ///< where it ends
    double *endSpeed = nullptr;
    double *endSlope = nullptr;
    double *columns = nullptr; ///< of the polynomial: StepRule::denseColumns() times as many
    double *scratch = nullptr; ///< StepRule::scratchColumns() times as many

    std::vector<StageWeights> *weights = nullptr; ///< one a stretch; kept from step to step
    NystromWeights *nystrom = nullptr;
};

/// A moment inside a step, as a polynomial needs it.
struct DenseTime
{
    double h = 0.0;     ///< frames, the step's length
    double theta = 0.0; ///< share of it that is over
    double kept = 1.0;  ///< what damping leaves of a velocity until then
    double whole =
        0.0; ///< the way that a velocity of 1 px/frame at the start comes to in the step with damping alone, px
    double share = 0.0; ///< how much of that it has come until then, as a share
};

/// How a method that chooses its steps takes one: from which stages, how it measures its error, and a polynomial
/// between its ends.
class StepRule
{
public:
    virtual ~StepRule() = default;
    /// The order of a step, and the power of h with which what attempt() measures shrinks.
    virtual int order() const = 0;
    virtual int errorOrder() const { return order(); }
    /// How many columns of numbers a step needs while it is made, and how many stay for its polynomial.
    virtual int scratchColumns() const = 0;
    virtual int denseColumns() const = 0;
    /// What it asks of a scene besides smooth equations, as in Method::needs(), and whether these equations have it.
    virtual std::vector<std::string> requirements() const { return {}; }
    virtual bool fits(const OdeSystem &) const { return true; }

    /// Computes where the step ends. Returns how far it may be off in a place, or in the way of a frame: px; infinite
    /// where numbers stop being finite.
    virtual double attempt(const StepAttempt &step) const = 0;
    /// Computes the polynomial's columns of a step that attempt() has made, to its ends as they are in `step` now.
    virtual void makeDense(const StepAttempt &step) const = 0;
    virtual DenseTime instant(double rate, double h, double theta) const = 0;
    /// Place and velocity of the rows from `first` to before `end`, into one number each.
    virtual void dense(const double *columns, int size, int first, int end, const DenseTime &when,
                       double *place, double *speed) const = 0;
};

/// What damping leaves of a velocity after `time` frames. Rows that it stops at once stand still, so nothing is taken.
double dampingFactor(double rate, double time);

/// The largest of `size` numbers without their signs; infinite where one is not finite.
double maxAbs(const double *numbers, int size);

}

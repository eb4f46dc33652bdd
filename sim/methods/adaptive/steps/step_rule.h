#pragma once

#include "sim/methods/adaptive/contact_accelerations.h"
#include "sim/methods/fixed/tableau.h"

#include <string>
#include <vector>

namespace sim {

struct NystromWeights;

/// The data of an attempted step. Each array has OdeSystem::size() numbers if not stated otherwise.
struct StepAttempt
{
    ContactAccelerations &accelerations;
    const OdeSystem &system;
    double start = 0.0; ///< frames after the last whole frame
    double h = 0.0;     ///< frames, length of the step

    const double *x = nullptr; ///< positions at the start
    const double *v = nullptr; ///< velocities at the start
    const double *a = nullptr; ///< accelerations at the start
    double *endX = nullptr;    ///< positions at the end
    double *endV = nullptr;    ///< velocities at the end
    double *endA = nullptr;    ///< accelerations at the end
    double *columns = nullptr; ///< dense output, StepRule::denseColumns() columns
    double *scratch = nullptr; ///< StepRule::scratchColumns() columns

    std::vector<StageWeights> *weights = nullptr; ///< one per rate range, kept between steps
    NystromWeights *nystrom = nullptr;            ///< kept between steps
};

/// A time within a step, for dense output.
struct DenseTime
{
    double h = 0.0;     ///< frames, length of the step
    double theta = 0.0; ///< the time as a share of the step
    double kept = 1.0;  ///< damping factor from the start until then
    double whole = 0.0; ///< frames, s of NystromWeights at the end of the step
    double share = 0.0; ///< s at this time, as a share of `whole`
};

/// The rule by which an adaptive method makes a step, estimates its error and computes dense output.
class StepRule
{
public:
    virtual ~StepRule() = default;
    /// Returns the order of a step.
    virtual int order() const = 0;
    /// Returns the power of h with which the error of attempt() decreases.
    virtual int errorOrder() const { return order(); }
    /// Returns the number of scratch columns that an attempt needs.
    virtual int scratchColumns() const = 0;
    /// Returns the number of columns that the dense output of a step needs.
    virtual int denseColumns() const = 0;
    /// Returns what it requires of a scene besides smooth equations (see Method::requirements()).
    virtual std::vector<std::string> requirements() const { return {}; }
    /// Returns whether the equations meet these requirements.
    virtual bool fits(const OdeSystem &) const { return true; }

    /// Computes the end of the step. Returns its error in px (or degrees), in a position or in the
    /// displacement of a frame, or infinity if a number is not finite.
    virtual double attempt(const StepAttempt &step) const = 0;
    /// Computes the columns of the dense output after attempt(), from the values in `step`.
    virtual void makeDense(const StepAttempt &step) const = 0;
    /// Returns the time `theta` (a share of the step) for rows with damping rate `rate`.
    virtual DenseTime instant(double rate, double h, double theta) const = 0;
    /// Computes positions and velocities of the rows from `first` to `end` - 1 at a time. `x` and `v`
    /// get one number per row.
    virtual void dense(const double *columns, int size, int first, int end, const DenseTime &time, double *x,
                       double *v) const = 0;
};

/// Returns the damping factor e^(-rate time) after `time` frames. Returns 1 for an infinite rate: those
/// points stand still, so the factor does not matter.
double dampingFactor(double rate, double time);

/// Returns the largest absolute value of `size` numbers, or infinity if one is not finite.
double maxAbs(const double *numbers, int size);

}

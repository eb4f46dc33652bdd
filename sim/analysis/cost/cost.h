#pragma once

#include "sim/pipeline/pipeline.h"

#include <functional>
#include <memory>
#include <vector>

namespace sim {

/// The cost of one effect in a frame under a method.
struct EffectCost
{
    EffectPtr effect;
    int points = 0; ///< number of points that the effect works on
    /// Computations of the effect for all its points per frame, counted over the measured frames. 0 for
    /// damping that a method includes in its formulas.
    double evaluations = 0.0;
    double ns = 0.0;     ///< per frame, median of the rounds
    double spread = 0.0; ///< ns, half the distance between the quartiles of the rounds
};

/// The cost of a frame, split over its effects.
struct FrameCost
{
    double ns = 0.0;                 ///< whole frame, median of the rounds
    double spread = 0.0;             ///< ns, half the distance between the quartiles of the rounds
    std::vector<EffectCost> effects; ///< in the order in which they run
    double restNs = 0.0;             ///< time outside effects: kicks, moves, the method's arithmetic
    double restSpread = 0.0;
    int rounds = 0;

    /// Returns the effects plus the rest, in ns. All are measured separately from the whole frame. A sum near
    /// `ns` shows that the measurement went well.
    double sum() const;
};

/// Measures the cost of the frames of a run, in rounds. A round times the whole frame, each effect and the
/// rest in turn, so other programs disturb all of them alike. The measured run itself is not changed.
///
/// A phase that computes a single effect is timed while frames run in order, without its prelude. An effect
/// that a method computes inside its own phase is timed by replaying its calls with recorded arguments.
///
/// The rest is the method's own phases. If such a phase computes effects, their time is subtracted. It is
/// measured as the time that repeating each of their calls adds. No result is the whole frame minus other
/// results.
class CostMeter
{
public:
    /// Returns seconds since an arbitrary start.
    using Clock = std::function<double()>;

    /// Measures the frames after `from`, a state of `scene` between two output steps.
    /// @throws Error when scene, method and step do not fit
    CostMeter(const Scene &scene, const MethodPtr &method, StepSize step, State from);
    /// Uses `clock` for all measurements.
    CostMeter(const Scene &scene, const MethodPtr &method, StepSize step, State from, Clock clock);
    ~CostMeter();
    CostMeter(CostMeter &&) noexcept;
    CostMeter &operator=(CostMeter &&) noexcept;

    /// Measures one round: about two milliseconds, or some output steps if those take longer. The first round
    /// also chooses the sample size. Returns false, and discards the round, when `shouldContinue` returned
    /// false.
    bool round(const ShouldContinue &shouldContinue = {});
    /// Returns the result of the rounds so far. Before the first round it contains only the points of each
    /// effect.
    FrameCost result() const;
    /// Returns the measured pipeline. Effects that it omits cost nothing.
    const Pipeline &pipeline() const;

private:
    class Work;
    std::unique_ptr<Work> m_work;
};

}

#pragma once

#include "sim/pipeline/pipeline.h"

#include <functional>
#include <memory>
#include <vector>

namespace sim {

/// What one effect costs in a frame under a method.
struct EffectCost
{
    EffectPtr effect;
    int points = 0; ///< how many points (not pulls) it works on
    /// How often it is computed in a frame, for all its points: counted, over the frames that are measured. 0 for a
    /// damping that a method has in its own arithmetic.
    double evaluations = 0.0;
    double ns = 0.0;     ///< a frame, median of the rounds
    double spread = 0.0; ///< ns, half the distance between the quartiles of the rounds
};

struct FrameCost
{
    double ns = 0.0;                 ///< of the whole frame, median of the rounds
    double spread = 0.0;             ///< ns, as above
    std::vector<EffectCost> effects; ///< in the order in which they run
    double restNs = 0.0;             ///< what no effect takes: kicks, moves, the method's own arithmetic
    double restSpread = 0.0;
    int rounds = 0;

    /// What effects and rest come to, ns. Each is measured by itself, and so is the frame: the two are near each other
    /// where measuring went well.
    double sum() const;
};

/// Measures what the frames of a run cost, by rounds: each times the whole frame, each effect and the rest one after
/// the other, so that what a computer does besides meets them all alike. The run itself is left alone.
///
/// An effect with a phase of its own is timed as that phase, without its prelude, in the very course of the frames. One that
/// a method's own phase computes on its way is called again with what it was given there, and these calls are timed.
/// The rest is the method's own phases; of one that computes effects on its way, what stays when each call of them is
/// done twice and what that adds is taken off. Nothing here is what is left of something else.
class CostMeter
{
public:
    /// Seconds from any start on.
    using Clock = std::function<double()>;

    /// The frames that follow on `from`, a state of `scene` between two rows.
    /// @throws Error when scene, method and step do not fit
    CostMeter(const Scene &scene, const MethodPtr &method, StepSize step, State from);
    CostMeter(const Scene &scene, const MethodPtr &method, StepSize step, State from, Clock clock);
    ~CostMeter();
    CostMeter(CostMeter &&) noexcept;
    CostMeter &operator=(CostMeter &&) noexcept;

    /// One round: about two milliseconds, or some frames where those take longer. The first also finds out how many
    /// make a good sample. Asks `goesOn` on the way; when that says no it leaves off, returns false and forgets
    /// the round.
    bool round(const ShouldContinue &shouldContinue = {});
    /// What the rounds so far came to; points only, before the first.
    FrameCost result() const;
    /// What is measured. What it leaves out costs nothing.
    const Pipeline &pipeline() const;

private:
    class Work;
    std::unique_ptr<Work> m_work;
};

}

#pragma once

#include "sim/base/step_size.h"
#include "sim/pipeline/dense_segment.h"
#include "sim/scene/scene.h"

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace sim {

/// The work of a kernel on certain points: prepared once, run in each step.
using PreparedKernel = std::function<void(State &)>;

/// A simple kernel as a value: it applies one formula to each dynamic point.
struct PointOperation
{
    enum class Kind {
        addGravity, ///< a.y = a.y + amount, px/frame^2
        kick,       ///< kick() for `amount` frames
        damp,       ///< damp() with the damping factor `amount`
        move,       ///< move() for `amount` frames
    };
    Kind kind = Kind::move;
    double amount = 0.0;
    PointRange points; ///< contains every dynamic point that it changes
};

/// The work of a phase on its points.
struct Kernel
{
    /// Does the work on all points of the phase.
    std::function<void(State &)> run;
    /// Prepares the same work on the points of `ranges`, which are in ascending order. If the ranges of
    /// several calls are unions of islands and cover all points, running them in any order has the same
    /// result as `run`. Null if the work cannot be divided.
    std::function<PreparedKernel(const std::vector<PointRange> &ranges)> prepareFor;
    /// The same work as a value if it is simple enough, else empty. See fusedKernels().
    std::optional<PointOperation> operation = {};
};

/// The description of a phase for the window.
struct PhaseInfo
{
    std::string id;    ///< the effect's id, or "kick", "move"... for a phase of the method
    std::string title; ///< in English; see SIM_TEXT
    EffectKind kind = EffectKind::motion;
    EffectPtr effect;                    ///< the effect that it computes; null for a phase of the method
    std::vector<EffectPtr> innerEffects; ///< the effects that a phase of the method evaluates
    PointRange points;                   ///< the points that it works on
    int group = -1;                      ///< index of its group in Scene::groups; -1: all groups at once
    std::vector<Region> regions;         ///< its source code, in the order in which it runs
    bool consumesAcceleration = false;   ///< whether later phases ignore the accelerations summed so far
    double kickFrames = 0.0;             ///< frames for which it applies the accelerations to velocities
    bool integrates = false;             ///< whether forces and damping act continuously during it
    /// Returns the numbers behind the change of `point`, from the states before and after the phase.
    std::function<std::vector<LiveValue>(const State &before, const State &after, int point)> explain;
};

/// The smallest part of a step that a learner can stop after.
struct Phase : PhaseInfo
{
    /// In the order in which they run. The last one does the work that the learner sees. The ones before it
    /// prepare it, for example set sums to 0 or save positions. Running the preparation twice changes
    /// nothing.
    std::vector<Kernel> kernels;
    /// Does the same as the kernels, but can be cancelled. Returns whether it finished; if not, the state is
    /// invalid. Null for phases that are always fast.
    std::function<bool(State &, const ShouldContinue &)> runInterruptible;
    /// Does the same as the kernels and reports each dense segment. Null for methods that are not adaptive.
    std::function<void(State &, const SegmentVisitor &)> runWithDenseOutput;

    /// Runs all kernels.
    void run(State &state) const
    {
        for (const Kernel &kernel : kernels)
            kernel.run(state);
    }
    /// Runs only the kernels that prepare the last one.
    void prepare(State &state) const
    {
        for (std::size_t i = 0; i + 1 < kernels.size(); ++i)
            kernels[i].run(state);
    }
};

/// How the length of a method's steps is determined.
enum class Stepping {
    fixed,    ///< all steps have length h
    adaptive, ///< the method chooses each length so that the error stays within a tolerance
};
/// Whether a method preserves phase-space volume without damping, so that the energy error stays bounded.
enum class Symplectic { no, yes };

/// The stability limit for the step length of a method, in a scene that only oscillates.
enum class StepLimit {
    stiffness, ///< the stiffest spring sets a length; with longer steps oscillations grow without bound
    none,      ///< stable at any step length and stiffness
    tolerance, ///< the error control keeps the steps short enough
};

/// A time-stepping method: it advances a State by one step. It knows no concrete effect, only roles.
class Method
{
public:
    virtual ~Method() = default;
    /// Returns the name of the method in files.
    virtual std::string id() const = 0;
    /// Returns the name that a learner sees, in English; see SIM_TEXT.
    virtual std::string title() const = 0;
    /// Returns the order: the error is proportional to h^order. For adaptive methods, h is the length of each
    /// step.
    virtual int order() const = 0;
    virtual Symplectic symplectic() const { return Symplectic::no; }
    virtual Stepping stepping() const { return Stepping::fixed; }
    virtual StepLimit stepLimit() const { return StepLimit::stiffness; }
    /// Returns how many times a step computes all forces. 0: the number varies, see
    /// State::forceEvaluations().
    virtual int evaluationsPerStep() const { return 1; }
    /// Returns what a scene must have, as ids: "groups" (an update order), "smooth" (no constraints and no
    /// jumps, so the motion has a limit for small steps), "one_damping" (one damping rate for everything that
    /// moves), "jacobian" (forces that know their Jacobian). Empty: no requirements.
    virtual std::vector<std::string> requirements() const = 0;
    /// Returns how the effects compute directions under this method.
    virtual DirectionRule directionRule() const = 0;
    /// Returns the source code that puts the phases in order.
    virtual Region region() const = 0;
    /// Allocates the arrays of `state` that the phases use.
    virtual void prepareState(State &state) const = 0;
    /// Returns the phases of one step. An effect that the scene does not have gets no phase.
    /// @throws Error "method-does-not-fit" (method, effect) for an effect that the method cannot handle
    virtual std::vector<Phase> phases(const Scene &scene, StepSize step) const = 0;
};

}

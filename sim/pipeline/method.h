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

/// Work on some of a scene's points: found out once, done again each step.
using PreparedKernel = std::function<void(State &)>;

/// The same simple work for each point that feels forces, as a value.
struct PointOperation
{
    enum class Kind {
        addGravity, ///< a.y = a.y + by, px/frame^2
        kick,       ///< kick() for `by` frames
        damp,       ///< damp(): `by` is the share of its velocity that a point keeps
        move,       ///< move() for `by` frames
    };
    Kind kind = Kind::move;
    double amount = 0.0;
    PointRange points; ///< all that can feel forces, and that it works on, are among these
};

/// What runs in a phase: a piece of work that is the same for all of its points.
struct Kernel
{
    /// The work on all of them.
    std::function<void(State &)> run;
    /// Only where it works point by point, or on ties of effects that see what is tied: the same work on the points of
    /// some runs, which are in ascending order. DoubleDouble that no tie leads out of come, in any order, to what `run` does.
    std::function<PreparedKernel(const std::vector<PointRange> &ranges)> prepareFor;
    /// Where it is no more than this; see fusedKernels().
    std::optional<PointOperation> operation = {};
};

/// What a learner sees of a phase.
struct PhaseInfo
{
    std::string id;    ///< the effect's id, or the method's own: "kick", "move"
    std::string title; ///< in English; see SIM_TEXT
    EffectKind kind = EffectKind::motion;
    EffectPtr effect;                    ///< whose work it is; null for the method's own
    std::vector<EffectPtr> innerEffects; ///< the effects that a phase of the method's own computes on its way
    PointRange points;                   ///< what it works on
    int group = -1;                      ///< which of the scene's groups; -1: all at once
    std::vector<Region> regions;         ///< its source, in the order in which it runs
    bool consumesAcceleration = false;   ///< whether the gathered accelerations are spent after it
    double kickFrames = 0.0; ///< frames for which it lets gathered accelerations act on velocities
    bool integrates = false; ///< whether it is part of a step that forces and damping act in all along
    /// The numbers behind what the phase did to `point`, given the states around it.
    std::function<std::vector<LiveValue>(const State &before, const State &after, int point)> explain;
};

/// One part of a step: the smallest stretch of time that a learner can stop after.
struct Phase : PhaseInfo
{
    /// In the order in which they run. The last one is what is shown; those before it are the method's own preparation:
    /// sums that begin at nothing, places that are kept. To run one of those once more changes nothing.
    std::vector<Kernel> kernels;
    /// Only where it may take long: does the same as the kernels, and leaves off when nobody waits any more. Returns
    /// whether it is done; if not, the state is good for nothing.
    std::function<bool(State &, const ShouldContinue &)> runInterruptible;
    /// Where it takes steps of its own: runs it, and tells each smooth part of the way. Else null.
    std::function<void(State &, const SegmentVisitor &)> runBySegments;

    void run(State &state) const
    {
        for (const Kernel &kernel : kernels)
            kernel.run(state);
    }
    /// Runs the method's preparation alone.
    void prepare(State &state) const
    {
        for (std::size_t i = 0; i + 1 < kernels.size(); ++i)
            kernels[i].run(state);
    }
};

/// Whether a method's steps have a length or a tolerance.
enum class Stepping {
    fixed,    ///< all have length h
    adaptive, ///< it chooses each so that its error stays within a tolerance
};
enum class Symplectic { no, yes };

/// What bounds the length of a method's steps, where a scene only swings.
enum class StepLimit {
    stiffness, ///< past a length that the stiffest spring decides, what should swing grows without end
    none,      ///< nothing: it stays bounded at any length and stiffness
    tolerance, ///< it keeps its steps short enough itself, by the error that they make
};

/// A time-stepping method: how a State gets from one step to the next. Knows no effect by name.
class Method
{
public:
    virtual ~Method() = default;
    /// Names the method in files.
    virtual std::string id() const = 0;
    /// In English; see SIM_TEXT.
    virtual std::string title() const = 0;
    /// How the error shrinks with the step: as h^order; for an adaptive method, with its own steps.
    virtual int order() const = 0;
    /// Whether it keeps phase-space volume where nothing damps, so that energy stays bounded for ever.
    virtual Symplectic symplectic() const { return Symplectic::no; }
    /// Whether steps have a length, or a tolerance.
    virtual Stepping stepping() const { return Stepping::fixed; }
    /// What bounds the length of its steps.
    virtual StepLimit stepLimit() const { return StepLimit::stiffness; }
    /// How often a step computes all forces; 0: as often as it takes, counted in State::evaluations.
    virtual int evaluationsPerStep() const { return 1; }
    /// What a scene must offer, as ids: "groups" (an update order), "smooth" (a continuous limit: no constraints, no
    /// jumps), "one_damping" (the same for all that moves), "slopes" (forces that know their derivatives). Empty:
    /// nothing beyond forces.
    virtual std::vector<std::string> requirements() const = 0;
    /// How this method's effects find directions.
    virtual DirectionRule directionRule() const = 0;
    /// Where the order of the phases is written down.
    virtual Region region() const = 0;
    /// Gives `state` the scratch that the phases use.
    virtual void prepareState(State &state) const = 0;
    /// The phases of one step. What the scene does not list makes no phase.
    /// @throws Error "method-does-not-fit" (method, effect) for an effect that the method cannot handle
    virtual std::vector<Phase> phases(const Scene &scene, StepSize step) const = 0;
};

}

#pragma once

#include "sim/methods/adaptive/adaptive_stepper.h"

#include <vector>

namespace sim {

/// The integrators of all islands of a scene. No coupling joins islands, so each has its own steps. A contact
/// event in one does not end the steps of the others. Points without an integrator stand still.
class IslandIntegrators
{
public:
    /// `tolerance`: see IslandIntegrator.
    IslandIntegrators(const Scene &scene, const StepRule &rule, DirectionRule directionRule,
                      double tolerance);

    /// Advances `state` to the next frame. Returns true if all islands reached it or one got stuck (see
    /// AdaptiveStep::stuckPoint). Returns false if `shouldContinue` was false. The state is unusable then.
    bool toNextFrame(State &state, const ShouldContinue &shouldContinue) const;
    /// Does the same, and calls `visit` for the part of each finished step up to the next frame.
    bool toNextFrame(State &state, const ShouldContinue &shouldContinue, const SegmentVisitor &visit) const;

    /// Returns the integrator of the island of `point`, or null if the island cannot move.
    const IslandIntegrator *of(int point) const;

private:
    /// Calls `advance` for each island until it returns false or an island gets stuck. Returns as
    /// toNextFrame().
    template <class Advance>
    bool forEachIsland(State &state, Advance &&advance) const;

    std::vector<IslandIntegrator> m_integrators;
};

}

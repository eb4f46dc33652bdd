#pragma once

#include "sim/methods/adaptive/adaptive_stepper.h"

#include <vector>

namespace sim {

/// The courses of a scene's islands. Nothing ties them, so each goes on by steps of its own: a touch in one ends no step
/// of the others. What no course is for stands still.
class IslandIntegrators
{
public:
    /// `tolerance`: as Course has it.
    IslandIntegrators(const Scene &scene, const StepRule &rule, DirectionRule directionRule,
                      double tolerance);

    /// Takes `state` on to the next frame. Returns whether all have got there, or one has given up; if not, `goesOn` said
    /// no on the way, and the state is good for nothing.
    bool toNextFrame(State &state, const ShouldContinue &shouldContinue) const;
    /// The same; tells each step of each island as it is done, up to the frame.
    bool toNextFrame(State &state, const ShouldContinue &shouldContinue, const SegmentVisitor &visit) const;

    /// That of the island that `point` is in; null where it cannot move.
    const IslandIntegrator *of(int point) const;

private:
    /// `advance` takes one island on, and returns what toNextFrame() does.
    template <class One>
    bool each(State &state, One &&advance) const;

    std::vector<IslandIntegrator> m_integrators;
};

}

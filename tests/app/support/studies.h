#pragma once

#include "app/ui/window/main_window.h"

#include <vector>

/// Functions that take the place of measuring in suites of the window: real measurements take seconds.
namespace tests {

/// A study without rows.
inline sim::Accuracy noStudy(const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &)
{
    return {};
}

/// A measurement of costs that reports nothing.
inline void noCost(const app::CostSubject &, const sim::ShouldContinue &,
                   const std::function<void(const sim::FrameCost &)> &)
{
}

/// A study with one row, and a reference whose points stay 5 px away from where they start.
inline sim::Accuracy quickStudy(const sim::Script &script, const sim::StudyPlan &plan,
                                const sim::StudyProgress &)
{
    sim::Accuracy found;
    found.span = found.horizon = plan.frames;
    found.reference.disagreement = 2e-11;
    const sim::State start = sim::sceneOf(script, script.values).start;
    std::vector<sim::Vec2> places;
    for (int i = 0; i < start.pointCount(); ++i)
        places.push_back(start.positionOf(i) + sim::Vec2{3.0, 4.0});
    found.reference.trajectories.assign(static_cast<std::size_t>(plan.frames + 1), places);
    sim::AccuracyRow row;
    row.setup = *plan.inUse;
    row.outcome = sim::Outcome::measured;
    row.error = 3.7;
    row.nsPerFrame = 250.0;
    found.rows = {row};
    return found;
}

}

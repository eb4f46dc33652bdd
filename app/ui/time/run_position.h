#pragma once

#include "sim/run/timeline.h"

#include <QString>

namespace app {

/// The position of a run as a learner counts: inside a frame, the current step and the number of its phases that are
/// done.
struct Position
{
    std::int64_t frame = 0;
    int step = 0;  ///< number of the step within the output step, from 0
    int steps = 1; ///< steps in an output step
    int done = 0;  ///< phases of that step; 0 between two frames
    int phases = 0;

    bool isInside() const { return done > 0; }
    /// Returns the phase of the cursor after phase `index` of this step has run.
    int phaseAfter(int index) const { return step * phases + index + 1; }
    friend bool operator==(const Position &, const Position &) = default;
};

Position positionOf(const sim::Timeline &timeline);
/// Returns the last step of the frame just done, with all of its phases done. The run must be between two frames, after
/// frame 0.
Position endOf(const sim::Timeline &timeline);

/// Returns "2 of 5 phases done", after the step if an output step has several; empty between two frames.
QString progressOf(const Position &position);
/// Returns the same in brief: "2 of 5".
QString shortProgressOf(const Position &position);
/// Returns "step 3 of 8"; empty if an output step is one step.
QString stepOf(const Position &position);
/// Returns "Frame 41, after gravity, 2 of 5 phases done".
QString sentenceOf(const sim::Timeline &timeline);

}

#pragma once

#include "sim/run/timeline.h"

#include <QString>

namespace app {

/// Where a run stands, as a learner counts: inside a frame, the step that was last worked on and how many of its
/// phases are done.
struct Position
{
    std::int64_t frame = 0;
    int step = 0;  ///< which of the row's steps is shown, from 0
    int steps = 1; ///< steps a row
    int done = 0;  ///< phases of that step; 0 between two frames
    int phases = 0;

    bool isInside() const { return done > 0; }
    /// The cursor's phase after `index`, of this step, has run.
    int phaseAfter(int index) const { return step * phases + index + 1; }
    friend bool operator==(const Position &, const Position &) = default;
};

Position positionOf(const sim::Timeline &timeline);
/// Returns the last step of the frame just done, with all of its phases done. The run must stand between two frames, after
/// frame 0.
Position endOf(const sim::Timeline &timeline);

/// "2 of 5 phases done", with the step before it if a row has several; empty between two frames.
QString progressOf(const Position &position);
/// The same in few letters: "2 of 5".
QString shortProgressOf(const Position &position);
/// "step 3 of 8"; empty if a row is one step.
QString stepOf(const Position &position);
/// "Frame 41, after gravity, 2 of 5 phases done".
QString sentenceOf(const sim::Timeline &timeline);

}

#pragma once

#include <QString>

#include <cstdint>

namespace app {

class LineStepper;

/// Returns "before line 9, 3 of 12 lines run"; empty between two frames.
QString progressOf(const LineStepper &lines);
/// Returns the same in brief: "line 9".
QString shortProgressOf(const LineStepper &lines);
/// Returns "Frame 41, before line 9, 3 of 12 lines run", or "Frame 41" between two frames.
QString sentenceOf(const LineStepper &lines, std::int64_t frame);

}

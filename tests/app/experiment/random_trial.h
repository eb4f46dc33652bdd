#pragma once

#include "tests/app/experiment/random_experiment.h"

namespace random_experiments {

/// The outcome of reading and running an experiment.
struct Outcome
{
    enum class End {
        refused, ///< by the reader
        ran,     ///< to its last frame, or until the work that a trial may be was done
        stopped, ///< at a frame whose successor cannot be computed
    };
    End end = End::refused;
    QString fault; ///< what is wrong with the program; empty: nothing
    QString lesson;
    QString method;
};

/// Reads a file, writes it and reads it again, runs it forth and back, and works on it as a learner does, with the work
/// bounded. `draw` decides where to. Never throws.
Outcome tried(const QByteArray &text, const app::LessonLibrary &library, Draw &draw);

}

#pragma once

#include "lessons/api/explanation.h"
#include "lessons/api/step.h"

#include <vector>

namespace lessons {

/// What is told about a step besides its narration.
struct Teaching
{
    QString step; ///< id
    /// What a learner knows afterwards: one sentence, for the summary of the lesson.
    QString learnt;
    /// For each thing to try, in order, what to drag, to set or to press; without doing it.
    std::vector<QString> hints;
    std::vector<Term> terms;
    std::vector<Why> whys;
};

/// `steps` with what is told about them.
/// @throws std::invalid_argument for a step that is not there, and where hints and things to try are not as many
std::vector<Step> taught(std::vector<Step> steps, const std::vector<Teaching> &all);

}

#pragma once

#include "lessons/api/step.h"
#include "lessons/api/text/project.h"
#include "sim/forward.h"
#include "sim/run/script/script.h"

#include <cstdint>
#include <functional>
#include <optional>
#include <vector>

namespace app {

/// The judgement on what a learner built for a level of a project.
struct ProjectVerdict
{
    /// What the learner still has to mend, in one sentence. Empty if the level is passed.
    QString sentence = {};
    int demand = -1; ///< index in ProjectLevel::demands of the one that `sentence` is about; -1: none of them
    std::int64_t frame = 0;     ///< where that demand fails
    std::vector<bool> met = {}; ///< one for each of ProjectLevel::demands; empty if there was no run

    bool isPassed() const { return sentence.isEmpty(); }
    friend bool operator==(const ProjectVerdict &, const ProjectVerdict &) = default;
};

/// What is judged. It is complete by itself, so that another thread can work on it.
struct ProjectTrial
{
    lessons::ProjectLevel level;
    const lessons::Step *step = nullptr; ///< where the learner works; it must outlive the trial
    sim::Script start;                   ///< the run that the project starts with
    sim::Script built;                   ///< the learner's run
    bool hasDraft = false;               ///< whether it does not use the text that the learner has written
};

/// Returns the run that is judged: that of the learner without its input, with the changes of the level.
/// @throws UserError if the level names a parameter, body or method that does not exist
sim::Script judgedScript(const ProjectTrial &trial);

/// Computes the run of a trial and judges it. Calls `report` with the percentage of the frames that are computed, each time
/// that it grows. Returns nothing if `shouldContinue` returned false.
/// @throws UserError if a condition of the level is not valid; the lesson is at fault then
std::optional<ProjectVerdict> judgeProject(const ProjectTrial &trial,
                                           const std::function<void(int percent)> &report = {},
                                           const sim::ShouldContinue &shouldContinue = {});

/// Returns the names that conditions of projects can use besides bodies, parameters and `frame`: numbers of the whole scene.
QStringList projectNumbers();

}

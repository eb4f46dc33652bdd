#pragma once

#include "app/listing/values.h"
#include "lessons/api/step.h"
#include "sim/forward.h"
#include "sim/run/script/script.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace app {

/// The judgement on a listing that a learner wrote for a task.
struct Verdict
{
    enum class Kind {
        right,          ///< its runs agree with those of the step's listing
        nearMiss,       ///< its runs agree with those of a near miss of the task
        wrong,          ///< its runs differ in another way
        stopped,        ///< an error stopped one of its runs
        doesNotCompile, ///< there is no run
    };
    Kind kind = Kind::wrong;
    int nearMiss = -1;           ///< index in CodeTask::nearMisses
    std::int64_t frame = 0;      ///< wrong: the first frame that differs; stopped: the frame with the error
    std::string body = {};       ///< wrong: the body that differs most in that frame
    double distance = 0.0;       ///< px, from its right position; or degrees, if only its angle differs
    bool isAngle = false;        ///< whether `distance` is in degrees
    std::string held = {};       ///< wrong: the body that the hand holds in that frame; empty: none
    bool hasOtherValues = false; ///< wrong: with the default parameters, the run agrees
    std::optional<listing::RunError> runError = {};         ///< stopped: empty if a number became infinite
    std::optional<listing::CompileError> compileError = {}; ///< doesNotCompile: the first
};

/// Number of frames of each run that is compared.
constexpr int judgedFrames = 90;
/// Greatest difference that still counts as equal, in px and in degrees. Two right formulations round differently.
constexpr double judgeTolerance = 1e-9;

/// Returns the runs in which listings of `step` are compared, without their method: three with different parameters
/// and different input of every kind that the step accepts.
std::vector<sim::Script> judgeScripts(const lessons::Step &step);

/// Returns the body that the hand holds while the frame that ends at `frame` is computed; empty: none.
std::string heldBody(const sim::Script &script, std::int64_t frame);
/// Judges the listing `code`, written for `task` of `step`. Takes some milliseconds for a creature, and some seconds
/// for a large tree. Returns nothing if `shouldContinue` returned false.
/// @throws std::invalid_argument if the step's own listing or a near miss does not compile
std::optional<Verdict> judge(const lessons::Step &step, const lessons::CodeTask &task, const QString &code,
                             const sim::ShouldContinue &shouldContinue = {});

/// Returns what a learner should know about `verdict`, in one or two sentences.
QString sentenceFor(const Verdict &verdict, const lessons::CodeTask &task);

}

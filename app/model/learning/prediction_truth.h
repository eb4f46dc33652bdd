#pragma once

#include "lessons/api/step.h"
#include "sim/base/vec2.h"
#include "sim/forward.h"

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

namespace app {

/// An answer to a prediction, the learner's or the true one. The kind of the question tells which member counts.
struct PredictedAnswer
{
    sim::Vec2 place = {}; ///< px
    double number = 0.0;
    int curve = 0; ///< 0: the right curve; 1, 2: Prediction::otherCurves
    friend bool operator==(const PredictedAnswer &, const PredictedAnswer &) = default;
};

/// What the run of a prediction shows.
struct PredictionTruth
{
    std::int64_t end = 0;   ///< the frame at which the run ends
    bool isReached = false; ///< whether the condition of its end holds there
    PredictedAnswer answer = {};
    /// For a question about curves: the number by output steps from frame 0 to `end`, for the right curve and the two
    /// others.
    std::vector<std::vector<double>> curves = {};
};

/// Computes what the run of `prediction` shows. Returns nothing if cancelled.
/// @throws UserError, sim::Error if there is no such run, or a condition or a number of the prediction is wrong
std::optional<PredictionTruth> truthOf(const lessons::Prediction &prediction, const lessons::Step &step,
                                       const sim::ShouldContinue &shouldContinue = {});

/// Returns the curves in the order in which the learner sees them: always the same for a prediction.
std::array<int, 3> curveOrder(const lessons::Prediction &prediction);

/// Returns whether an answer is as good as the true one: a place within 10 px, a number within 2 % or half a unit, or the
/// right curve.
bool isGood(const lessons::Question &question, const PredictedAnswer &said, const PredictedAnswer &found);

/// Returns an answer as notes keep it: "300.0, 220.0", "12.5", "2".
QString notedAnswer(const lessons::Question &question, const PredictedAnswer &answer);
/// Reads what notedAnswer() returned; empty if the text is something else.
std::optional<PredictedAnswer> answerInNote(const lessons::Question &question, const QString &text);
/// Returns the kind of a question as notes keep it: "place", "number", "curve".
QString notedKind(const lessons::Question &question);

}

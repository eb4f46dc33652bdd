#pragma once

#include "app/model/learning/notes.h"
#include "app/model/learning/prediction_truth.h"

#include <QString>

namespace app {

// Sentences about predictions.

/// Returns an answer in words: "312, 220", "38 frames", "12.5 px", "curve 2".
QString answerWords(const lessons::Prediction &prediction, const PredictedAnswer &answer);
/// Returns what a learner said and what came out, in Markdown: "You said **40 frames**. It is **38 frames**: 2 less."
QString outcomeSentence(const lessons::Prediction &prediction, const PredictedAnswer &said,
                        const PredictedAnswer &found);
/// Returns the outcome of a prediction as the learner's notes have it; empty if there is no note.
QString notedOutcome(const Notes &notes, const QString &lesson, const QString &step,
                     const lessons::Prediction &prediction);
/// Returns a curve in words for screen readers: "from 300 to 200, highest 300, lowest 180".
QString curveWords(const std::vector<double> &curve);

}

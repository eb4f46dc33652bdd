#pragma once

#include "sim/analysis/accuracy/study.h"

#include <QString>

#include <optional>

namespace app {

class JsonWriter;

/// The result of a study of accuracy, with the request that it answers.
struct AccuracyReport
{
    QString experiment;
    std::optional<double> tolerance; ///< px, the largest error that the user accepts
    sim::MethodSetup inUse;
    sim::Accuracy found;
};

/// Returns a step as messages and tables show it: "h 0.5", "tolerance 1e-6".
QString stepText(sim::StepSize step);
/// Writes the field "h" or "tolerance" of a step.
void writeStep(sim::StepSize step, JsonWriter &json);

/// Returns the report for people: the reference, a table, and the most important numbers in sentences.
QString accuracyTable(const AccuracyReport &report);

/// Returns the report as JSON, as springstep(1) describes it.
QString accuracyJson(const AccuracyReport &report);

}

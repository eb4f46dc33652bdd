#pragma once

#include "sim/analysis/accuracy/study.h"

#include <QString>

#include <optional>

namespace app {

/// What a study of accuracy found, and what was asked.
struct AccuracyReport
{
    QString experiment;
    std::optional<double> tolerance; ///< px: the error that was asked for
    sim::MethodSetup inUse;
    sim::Accuracy found;
};

/// How messages and tables write a step: "h 0.5", "tolerance 1e-6".
QString stepText(sim::StepSize step);

/// The report for people: a table, the reference, and the numbers that matter in words.
QString accuracyTable(const AccuracyReport &report);

/// The report as JSON, as the README describes it.
QString accuracyJson(const AccuracyReport &report);

}

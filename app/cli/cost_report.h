#pragma once

#include "sim/analysis/cost/cost.h"

#include <QString>

#include <vector>

namespace app {

/// An effect of a step that no frame computes.
struct UnusedEffect
{
    QString id;
    QString why;
};

/// What a scene's frames cost.
struct CostReport
{
    QString experiment;
    sim::MethodPtr method;
    sim::StepSize step;
    sim::FrameCost cost;
    std::vector<UnusedEffect> unused;
};

/// The report for people: a table, and whether it adds up.
QString costTable(const CostReport &report);

/// The report as JSON, as the README describes it.
QString costJson(const CostReport &report);

}

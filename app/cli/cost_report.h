#pragma once

#include "sim/analysis/cost/cost.h"

#include <QString>

#include <vector>

namespace app {

/// An effect of a scene that no frame computes.
struct UnusedEffect
{
    QString id;
    QString why;
};

/// The measured cost of a scene's frames.
struct CostReport
{
    QString experiment;
    sim::MethodPtr method;
    sim::StepSize step;
    sim::FrameCost cost;
    std::vector<UnusedEffect> unused;
};

/// Returns the report for people: a table, and how near the sum of its parts is to the whole frame.
QString costTable(const CostReport &report);

/// Returns the report as JSON, as springstep(1) describes it.
QString costJson(const CostReport &report);

}

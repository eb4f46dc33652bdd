#pragma once

#include "sim/catalogue/judge.h"

#include <QString>

namespace app {

/// The result of one hard case under one method.
struct HardRow
{
    std::string hardCase; ///< id
    std::string method;   ///< id
    sim::Verdict verdict;
};

/// Returns the rows as JSON, as springstep(1) describes it.
QString hardJson(const std::vector<HardRow> &rows);

/// Returns the lines above the rows of a case, and one row, for people. Each ends with a line break.
QString hardHeading(const sim::HardCase &hard);
QString hardLine(const HardRow &row);

/// Returns a sentence about all rows, which lists the broken claims.
QString hardSummary(const std::vector<HardRow> &rows);

}

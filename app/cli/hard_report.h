#pragma once

#include "sim/catalogue/judge.h"

#include <QJsonObject>
#include <QString>

namespace app {

/// One case under one method.
struct HardRow
{
    std::string hard; ///< the case's id
    std::string method;
    sim::Verdict verdict;
};

/// As the README describes it.
QJsonObject hardRowJson(const HardRow &row);

/// What stands above the rows of a case, and one row, for people; each ends its line.
QString hardHeading(const sim::HardCase &hard);
QString hardLine(const HardRow &row);

/// What came of all of them, in a sentence; and which claims were broken.
QString hardSummary(const std::vector<HardRow> &rows);

}

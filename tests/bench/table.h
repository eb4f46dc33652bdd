#pragma once

#include "results.h"
#include "rows.h"

namespace bench {

/// The rows of which both sides were measured, as a table in Markdown, ratios first; below it how costs grow with size;
/// above it the machine. What was asked for and missed is said in its row.
std::string table(const Results &results, const std::vector<Row> &rows,
                  const std::vector<GrowingRow> &growing);

}

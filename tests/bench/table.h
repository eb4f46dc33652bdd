#pragma once

#include "tests/bench/results.h"
#include "tests/bench/rows.h"

namespace bench {

/// Returns a Markdown table. The machine comes first, then the rows of which both sides were measured, ratios
/// first, then the growth of costs with size. A row says if it misses its target.
std::string table(const Results &results, const std::vector<Row> &rows,
                  const std::vector<GrowingRow> &growing);

}

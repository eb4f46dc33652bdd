#pragma once

#include "tests/bench/results.h"

#include <string>
#include <vector>

namespace bench {

/// What a row of the table compares.
enum class Ratio {
    oursByTheirs, ///< ours / theirs: smaller is better
    theirsByOurs, ///< theirs / ours: larger is better
    time,         ///< only ours, in ns: smaller is better
};

/// A comparison of two benchmarks of one run, by name, with its target.
struct Row
{
    std::string work;
    std::string ours;
    std::string theirs;     ///< empty for Ratio::time
    std::string title = {}; ///< the other's name in the table
    Ratio ratio = Ratio::oursByTheirs;
    double atLeast = 0.0; ///< 0 for no target
    double aim = 0.0;
};

/// Returns all rows of the table in order. Each listing among `medians` has a row.
std::vector<Row> allRows(const Measurements &medians);

/// A benchmark whose growth is shown, and the unit of its size.
struct GrowingRow
{
    std::string work;
    std::string name;
    std::string item;                   ///< empty if the total cost is shown
    std::vector<std::string> arguments; ///< of the benchmark, in ascending order
    std::vector<double> sizes;          ///< in items, in the same order
};

std::vector<GrowingRow> allGrowingRows();

}

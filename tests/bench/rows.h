#pragma once

#include <string>
#include <vector>

namespace bench {

/// Which way a row of the table is to be read.
enum class Ratio {
    oursByTheirs, ///< ours / another's: the smaller, the better
    theirsByOurs, ///< another's / ours: the larger, the better
    time,         ///< ours alone, in ns: the smaller, the better
};

/// A comparison of two benchmarks of one run, by name; and what it should come to.
struct Row
{
    std::string work;
    std::string ours;
    std::string theirs;     ///< empty for Ratio::time
    std::string title = {}; ///< what the other is called
    Ratio ratio = Ratio::oursByTheirs;
    double atLeast = 0.0; ///< 0: nothing was asked for
    double aim = 0.0;
};

/// All of the table, in its order.
std::vector<Row> allRows();

/// A benchmark whose growth is shown, and what one of its items is.
struct GrowingRow
{
    std::string work;
    std::string name;
    std::string item;                   ///< empty: what is shown is the whole cost
    std::vector<std::string> arguments; ///< those of the benchmark, in rising order
    std::vector<double> sizes;          ///< in items, likewise
};

std::vector<GrowingRow> allGrowingRows();

}

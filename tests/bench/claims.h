#pragma once

#include <map>
#include <string>

namespace bench {

/// Says that `ours` is to be read beside `alternative`, both names of benchmarks; `claim` is the sentence that
/// the ratio of their times completes.
struct Claim
{
    std::string claim;
    std::string ours;
    std::string alternative;
};

/// The median of the runs of a benchmark.
struct Measured
{
    double nanoseconds = 0.0; ///< one iteration
    std::string label;        ///< as the benchmark set it
};
using Measurements = std::map<std::string, Measured>; ///< by the benchmark's name

/// Adds a claim to the table that is printed after the benchmarks.
int claim(Claim one);

}

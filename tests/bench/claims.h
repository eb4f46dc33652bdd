#pragma once

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

/// Adds a claim to the table that is printed after the benchmarks.
int claim(Claim one);

}

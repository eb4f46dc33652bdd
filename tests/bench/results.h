#pragma once

#include <QByteArray>

#include <map>
#include <string>
#include <vector>

namespace bench {

/// The median of the runs of a benchmark.
struct Measured
{
    double nanoseconds = 0.0; ///< one iteration: of processor time, or what it measures in place of that
    std::string label;        ///< as the benchmark set it
};
using Measurements =
    std::map<std::string, Measured>; ///< by the benchmark's name with its argument: "creatures/100"

/// How the time of a benchmark goes with its size, as Google Benchmark fits it.
struct Growth
{
    std::string as;           ///< "N", "NlgN", "(1)", ...
    double nanoseconds = 0.0; ///< times that function of the size
    double off = 0.0;         ///< the root of the mean square of what the fit is off, as a share of the mean
};
using Growths = std::map<std::string, Growth>; ///< by the benchmark's name: "creatures"

/// What programs with Google Benchmark have written.
struct Results
{
    Measurements medians;
    Growths growths;
    std::map<std::string, std::string> refused; ///< by name: why it did not run
    std::map<std::string, std::string> machine; ///< "processor", "compiler", "cores", "load", as far as known
};

/// Adds what a file of `--benchmark_out_format=json` has. A run without repetitions is its own median. Returns what is
/// wrong with the file, or nothing.
std::string addResults(const QByteArray &json, Results &results);

}

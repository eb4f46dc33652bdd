#pragma once

#include <QByteArray>

#include <map>
#include <string>
#include <vector>

namespace bench {

/// The median of a benchmark's runs.
struct QuantityKind
{
    double nanoseconds = 0.0; ///< per iteration: processor time, or the benchmark's own measurement
    std::string label;        ///< set by the benchmark
};
using Measurements =
    std::map<std::string, QuantityKind>; ///< by the benchmark's name with its argument: "creatures/100"

/// The growth of a benchmark's time with its size, as fitted by Google Benchmark.
struct Growth
{
    std::string as;           ///< "N", "NlgN", "(1)", ...
    double nanoseconds = 0.0; ///< factor of that function
    double off = 0.0;         ///< the root mean square error of the fit, as a fraction of the mean
};
using Growths = std::map<std::string, Growth>; ///< by the benchmark's name: "creatures"

/// The output of programs with Google Benchmark.
struct Results
{
    Measurements medians;
    Growths growths;
    std::map<std::string, std::string> refused; ///< why a benchmark did not run, by name
    std::map<std::string, std::string> machine; ///< "processor", "compiler", "cores", "load", if known
};

/// Adds the content of a file from `--benchmark_out_format=json`. A run without repetitions counts as its own
/// median. Returns an error message, or an empty text.
std::string addResults(const QByteArray &json, Results &results);

}

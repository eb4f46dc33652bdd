#include "claims.h"

#include "race_figure.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <fstream>
#include <optional>
#include <string_view>
#include <vector>

namespace bench {

namespace {

std::vector<Claim> &claims()
{
    static std::vector<Claim> all;
    return all;
}

/// Prints as usual, and remembers the medians.
class Medians : public benchmark::ConsoleReporter
{
public:
    void ReportRuns(const std::vector<Run> &runs) override
    {
        for (const Run &run : runs) {
            if (run.aggregate_name != "median")
                continue;
            const bool byTheWall = run.run_name.time_type == "real_time";
            const double time = byTheWall ? run.GetAdjustedRealTime() : run.GetAdjustedCPUTime();
            m_medians[run.run_name.function_name] = {
                time * 1e9 / benchmark::GetTimeUnitMultiplier(run.time_unit), run.report_label};
        }
        ConsoleReporter::ReportRuns(runs);
    }

    const Measurements &medians() const { return m_medians; }

private:
    Measurements m_medians;
};

void printClaims(const Measurements &medians)
{
    std::printf("\nRatios of medians (ours / alternative):\n");
    for (const Claim &one : claims()) {
        const auto ours = medians.find(one.ours);
        const auto other = medians.find(one.alternative);
        if (ours == medians.end() || other == medians.end())
            continue;
        const double a = ours->second.nanoseconds, b = other->second.nanoseconds;
        std::printf("%-72s %8.2f   (%.0f ns / %.0f ns)\n", one.claim.c_str(), a / b, a, b);
    }
}

/// Takes "--figure FILE" out of the arguments. Returns FILE, or nothing.
std::optional<std::string> takeFigure(int &argc, char **argv)
{
    for (int i = 1; i + 1 < argc; ++i) {
        if (std::string_view(argv[i]) != "--figure")
            continue;
        const std::string file = argv[i + 1];
        std::copy(argv + i + 2, argv + argc + 1, argv + i); // with the null that ends them
        argc -= 2;
        return file;
    }
    return {};
}

/// Returns the exit code.
int writeFigure(const std::string &file, const Measurements &medians)
{
    const std::string picture = raceFigure(medians);
    if (picture.empty()) {
        std::fprintf(stderr,
                     "No figure: run the benchmarks \"springstep|odeint|cvode\", with repetitions.\n");
        return 1;
    }
    std::ofstream out(file, std::ios::binary);
    out << picture << std::flush;
    if (!out)
        std::fprintf(stderr, "The figure cannot be written to %s.\n", file.c_str());
    return out ? 0 : 2;
}

}

int claim(Claim one)
{
    claims().push_back(std::move(one));
    return 0;
}

}

int main(int argc, char **argv)
{
    const std::optional<std::string> figure = bench::takeFigure(argc, argv);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    bench::Medians reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    bench::printClaims(reporter.medians());
    return figure ? bench::writeFigure(*figure, reporter.medians()) : 0;
}

#include "claims.h"

#include <benchmark/benchmark.h>

#include <cstdio>
#include <map>
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
            if (run.aggregate_name == "median")
                m_nanoseconds[run.run_name.function_name] =
                    run.GetAdjustedCPUTime() * 1e9 / benchmark::GetTimeUnitMultiplier(run.time_unit);
        }
        ConsoleReporter::ReportRuns(runs);
    }

    void printClaims() const
    {
        for (const Claim &one : claims()) {
            const auto ours = m_nanoseconds.find(one.ours);
            const auto other = m_nanoseconds.find(one.alternative);
            if (ours == m_nanoseconds.end() || other == m_nanoseconds.end())
                continue;
            std::printf("%-72s %8.2f   (%.0f ns / %.0f ns)\n", one.claim.c_str(),
                        ours->second / other->second, ours->second, other->second);
        }
    }

private:
    std::map<std::string, double> m_nanoseconds;
};

}

int claim(Claim one)
{
    claims().push_back(std::move(one));
    return 0;
}

}

int main(int argc, char **argv)
{
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    bench::Medians reporter;
    benchmark::RunSpecifiedBenchmarks(&reporter);
    std::printf("\nRatios of medians (ours / alternative):\n");
    reporter.printClaims();
    return 0;
}

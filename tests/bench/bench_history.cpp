// Seeking any frame of a ten-minute run that has been computed before, compared with computing it from the
// start.

#include "tests/sim/support/support.h"

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>

namespace {

constexpr int tenMinutes = 18'000; // frames, at 30 a second
constexpr std::size_t tinyBudget = 64 << 10;

sim::Script creature()
{
    return support::script(support::sample("creature in a room"), "published");
}

/// Seeks within a run of as many frames as the benchmark's argument.
void seekWithin(benchmark::State &run, std::size_t budget)
{
    using Clock = std::chrono::steady_clock;
    sim::Timeline timeline(creature(), budget);
    const int frames = static_cast<int>(run.range(0));
    timeline.seek({frames, 0});
    support::Dice dice(1);
    std::vector<double> microseconds;
    for (auto _ : run) {
        const int frame = dice.whole(0, frames);
        const auto start = Clock::now();
        timeline.seek({frame, 0});
        microseconds.push_back(std::chrono::duration<double, std::micro>(Clock::now() - start).count());
    }
    std::sort(microseconds.begin(), microseconds.end());
    run.counters["median_us"] = microseconds[microseconds.size() / 2];
    run.counters["worst_us"] = microseconds.back();
    run.counters["kept_bytes"] = static_cast<double>(timeline.keyframeBytes());
    run.counters["kept_states"] = static_cast<double>(timeline.track().keyframeCount());
    run.SetComplexityN(frames);
}

void seekAnywhere(benchmark::State &run)
{
    seekWithin(run, sim::Timeline::defaultBudget);
}
void seekTinyBudget(benchmark::State &run)
{
    seekWithin(run, tinyBudget);
}

/// Seeks the middle frame without keyframes, which costs as much as the average frame.
void computeStraight(benchmark::State &run)
{
    const int frames = static_cast<int>(run.range(0));
    for (auto _ : run) {
        sim::Track fresh(creature(), 0);
        fresh.seek({frames / 2, 0});
        benchmark::DoNotOptimize(fresh.state().position.data());
    }
    run.SetComplexityN(frames);
}

/// Computes the live values beside the code, which the window needs after each frame.
void liveValues(benchmark::State &run)
{
    sim::Timeline timeline(creature());
    timeline.seek({1000, 0});
    for (auto _ : run)
        benchmark::DoNotOptimize(timeline.track().explainPhases("body"));
}

/// Advances by one frame, as playback does.
void playFrame(benchmark::State &run)
{
    sim::Timeline timeline(creature());
    for (auto _ : run) {
        timeline.nextOutputStep();
        if (timeline.cursor().frame == tenMinutes) {
            run.PauseTiming();
            timeline = sim::Timeline(creature());
            run.ResumeTiming();
        }
    }
}

/// Drags a body while the run continues.
void dragFrame(benchmark::State &run)
{
    sim::Timeline timeline(creature());
    timeline.applyInput(sim::Grab{"foot0"});
    for (auto _ : run) {
        const double x = 200.0 + static_cast<double>(timeline.cursor().frame % 100);
        timeline.applyInput(sim::Move{{x, 100.0}});
        timeline.nextOutputStep();
        if (timeline.cursor().frame == 1000) {
            run.PauseTiming();
            timeline = sim::Timeline(creature());
            timeline.applyInput(sim::Grab{"foot0"});
            run.ResumeTiming();
        }
    }
}

BENCHMARK(seekAnywhere)->Arg(1'000)->Arg(tenMinutes)->Arg(108'000)->Complexity();
BENCHMARK(seekTinyBudget)->Arg(tenMinutes);
BENCHMARK(computeStraight)->Arg(1'000)->Arg(tenMinutes)->Arg(108'000)->Complexity();
BENCHMARK(liveValues);
BENCHMARK(playFrame);
BENCHMARK(dragFrame);

}

#include "tests/bench/scenes/crowd_runs.h"

#include "tests/sim/support/support.h"

#include "sim/methods/methods.h"
#include "sim/pipeline/run_step.h"

namespace bench::crowd {

namespace {

class Pipelined : public Runner
{
public:
    Pipelined(const sim::Scene &scene, int creatures)
        : m_creatures(creatures), m_pipeline(sim::compose(scene, *sim::findMethod("semi_implicit_euler"),
                                                          sim::StepSize::ofLength(1.0))),
          m_start(scene.start)
    {
        sim::findMethod("semi_implicit_euler")->prepareState(m_start);
        m_now = m_start;
    }

    void restart() override { m_now = m_start; }
    void frame() override
    {
        ++m_now.frame;
        sim::runStep(m_pipeline, m_now);
    }
    sim::Vec2 at(int creature, int foot) const override
    {
        return m_now.positionOf(pointOf(m_creatures, creature, foot));
    }

private:
    int m_creatures;
    sim::Pipeline m_pipeline;
    sim::State m_start;
    sim::State m_now;
};

/// Returns the mean distance between the runner's points and those of our pipeline after 20 frames, px.
double apartFrom(const sim::Scene &scene, int creatures, Runner &runner)
{
    constexpr int soon = 20;
    const sim::State right = support::plainRun(scene, "semi_implicit_euler", 1.0, soon);
    for (int i = 0; i < soon; ++i)
        runner.frame();
    double sum = 0.0;
    for (int creature = 0; creature < creatures; ++creature) {
        for (int foot = -1; foot < feet; ++foot)
            sum +=
                sim::length(runner.at(creature, foot) - right.positionOf(pointOf(creatures, creature, foot)));
    }
    return sum / right.pointCount();
}

void run(benchmark::State &bench, const Entry &entry)
{
    if (!entry.needs.empty()) {
        bench.SkipWithError(entry.needs.c_str());
        return;
    }
    const int creatures = static_cast<int>(bench.range(0));
    const sim::Scene scene = entry.scene(creatures);
    const std::unique_ptr<Runner> runner = entry.make(scene, creatures);
    const double apart = apartFrom(scene, creatures, *runner);
    if (!(apart <= entry.apart)) {
        bench.SkipWithError(("computes something else: " + std::to_string(apart) + " px off").c_str());
        return;
    }
    runner->restart();
    int done = 0;
    for (auto _ : bench) {
        if (done == frames) {
            runner->restart();
            done = 0;
        }
        runner->frame();
        ++done;
        benchmark::ClobberMemory();
    }
    bench.counters["px_apart"] = apart;
    bench.SetComplexityN(creatures);
}

}

benchmark::internal::Benchmark *enter(Entry entry)
{
    return benchmark::RegisterBenchmark(entry.name.c_str(),
                                        [entry](benchmark::State &bench) { run(bench, entry); })
        ->Arg(100)
        ->Arg(1'000)
        ->Arg(10'000)
        ->Complexity();
}

std::unique_ptr<Runner> ours(const sim::Scene &scene, int creatures)
{
    return std::make_unique<Pipelined>(scene, creatures);
}

}

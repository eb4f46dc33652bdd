// The cost of accuracy: a creature in the air through the usual pipeline, compared with hand-written
// equations in Boost's odeint and in SUNDIALS. See creature_in_air.h.

#include "sim/pipeline/pipeline.h"
#include "sim/run/script/script.h"
#include "tests/bench/peers/creature_in_air.h"
#include "tests/sim/support/support.h"

#include "sim/effects/drags/damping.h"
#include "sim/methods/methods.h"

#include <benchmark/benchmark.h>

namespace {

using namespace bench;

sim::Scene scene()
{
    sim::Scene creature = scenes::springCreature(air::feet, air::k, air::radius);
    const air::Row<double> start = air::start();
    for (int i = 0; i < air::points; ++i)
        creature.start.place(i, {start[std::size_t(i)], start[std::size_t(air::points + i)]});
    scenes::add<sim::Damping>(creature, air::damp);
    return creature;
}

/// Our pipeline, as the app runs it.
class Pipelined : public air::Solver
{
public:
    Pipelined(const sim::MethodPtr &method, sim::StepSize step)
    {
        sim::Script script = support::script(scene(), method->id());
        script.step = step;
        const sim::Scene prepared = sim::sceneOf(script, script.values);
        m_start = prepared.start;
        m_pipeline = sim::compose(prepared, *method, step);
    }

    void run(air::MeasureSeries &series) override
    {
        sim::State state = m_start;
        write(state, series[0]);
        for (std::size_t frame = 1; frame <= air::frames; ++frame) {
            state.frame = static_cast<std::int64_t>(frame);
            for (int step = 0; step < m_pipeline.step.stepsPerOutput; ++step) {
                for (const sim::Phase &phase : m_pipeline.phases)
                    phase.run(state);
            }
            write(state, series[frame]);
        }
    }

private:
    static void write(const sim::State &state, std::array<double, 2 * air::points> &row)
    {
        std::copy_n(state.position.data(), row.size(), row.data());
    }

    sim::State m_start;
    sim::Pipeline m_pipeline;
};

/// Enters every method, with steps of 1/n frame or with tolerances.
int enterAll()
{
    std::vector<double> steps;
    for (const int n : {1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 192, 256})
        steps.push_back(1.0 / n);
    for (const sim::MethodPtr &method : sim::allMethods()) {
        const bool adaptive = method->stepping() == sim::Stepping::adaptive;
        const auto make = [method, adaptive](double size) {
            return std::make_unique<Pipelined>(method, adaptive ? sim::StepSize::withTolerance(size)
                                                                : sim::StepSize::ofLength(size));
        };
        air::enter({"springstep", method->id(), adaptive ? air::tolerancesDownTo(1e-12) : steps, make});
    }
    return 0;
}

void race(benchmark::State &run, const std::string &team, double target)
{
    air::Champion &champion = air::champion(team, target);
    if (!champion.solver) {
        run.SkipWithError("nobody of this team is here, or exact enough");
        return;
    }
    air::MeasureSeries series{};
    for (auto _ : run) {
        champion.solver->run(series);
        benchmark::DoNotOptimize(series);
    }
    run.SetLabel(champion.name);
    run.counters["per_frame"] = benchmark::Counter(static_cast<double>(run.iterations()) * air::frames,
                                                   benchmark::Counter::kIsRate | benchmark::Counter::kInvert);
}

int registerAll()
{
    for (const double error : air::errors) {
        for (const std::string team : air::teams) {
            const std::string name = air::nameOf(team, error);
            benchmark::RegisterBenchmark(name.c_str(),
                                         [team, error](benchmark::State &run) { race(run, team, error); });
        }
    }
    return 0;
}

const int entered = enterAll();
const int registered = registerAll();

}

// A frame of each listing of the lessons, and of the compiled pipeline under the method of the same step. Runs
// start again before all bodies rest.

#include "tests/bench/bench_listings.h"

#include "app/listing/listing_method.h"
#include "sim/pipeline/run_step.h"
#include "sim/simd/flush_denormals.h"
#include "tests/lessons/support/support.h"

#include <benchmark/benchmark.h>

#include <memory>
#include <stdexcept>

namespace bench {

namespace {

/// A run starts again after this many frames.
constexpr int listingFrames = 100;

std::shared_ptr<const listing::Program> programOf(const lessons::Step &step, const sim::Scene &scene)
{
    listing::Compiled compiled =
        listing::Program::compile(step.listing.text.toStdString(), listing::vocabularyOf(scene));
    if (!compiled.program)
        throw std::runtime_error(compiled.errors.front().sentence);
    return compiled.program;
}

/// Returns the number of lines that the frame in the middle of a run has.
double linesOfFrame(const listing::Program &program, const sim::Scene &scene)
{
    const listing::Binding binding = listing::bind(program.vocabulary(), scene);
    sim::State state = scene.start;
    for (state.frame = 1; state.frame < listingFrames / 2; ++state.frame)
        program.run(state, binding);
    return static_cast<double>(program.trace(state, binding).lines.size());
}

/// Measures a frame of `script`.
void frames(benchmark::State &run, const sim::Script &script)
{
    const sim::FlushDenormals flush; // as all code that computes a run
    const sim::Scene scene = sim::sceneOf(script, script.values);
    const sim::Pipeline composed = sim::compose(scene, *script.method, script.step);
    sim::State state = scene.start;
    for (auto _ : run) {
        if (state.frame == listingFrames)
            state = scene.start;
        ++state.frame;
        sim::runStep(composed, state);
        benchmark::DoNotOptimize(state.position.data());
        benchmark::ClobberMemory();
    }
    if (state.stepFailed)
        run.SkipWithError("the listing stopped with a mistake");
}

void addStep(const QString &lesson, const lessons::Step &step)
{
    const std::string name = QString("/%1/%2").arg(lesson, step.id).toStdString();
    const sim::Script compiled = support::scriptOf(step, step.method.toStdString());
    const sim::Scene scene = sim::sceneOf(compiled, compiled.values);
    const std::shared_ptr<const listing::Program> program = programOf(step, scene);
    sim::Script written = compiled;
    written.method = std::make_shared<listing::ListingMethod>(program);
    benchmark::RegisterBenchmark(("listing" + name).c_str(), [=](benchmark::State &run) {
        frames(run, written);
        run.counters["lines"] = linesOfFrame(*program, sim::sceneOf(written, written.values));
    });
    benchmark::RegisterBenchmark(("listing_compiled" + name).c_str(),
                                 [=](benchmark::State &run) { frames(run, compiled); });
}

}

void addListings()
{
    for (const QString &lesson : support::lessonIds()) {
        for (const lessons::Step &step : support::loadLesson(lesson).steps) {
            if (!step.listing.isEmpty())
                addStep(lesson, step);
        }
    }
}

}

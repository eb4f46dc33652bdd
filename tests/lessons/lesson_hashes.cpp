// Prints a hash of 1000 frames (300 under the sanitizers) of every step of every lesson: one line a step and method.
// What it prints must not depend on the instructions that it runs with, nor on how it gets from frame to frame:
//   lesson_hashes      as the app does: what has come to rest sleeps, and neighbouring phases run as one
//   lesson_hashes 1    each row is computed phase by phase, by one thread, what hangs together at a time
//   lesson_hashes 2    the same by two threads

#include "sim/run/finite.h"
#include "sim/run/script/composed_interval.h"
#include "tests/lessons/support.h"
#include "tests/sizes.h"

#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/run_step.h"
#include "sim/run/script/output_step.h"
#include "sim/run/track.h"
#include "sim/simd/dispatch.h"
#include "sim/simd/flush_denormals.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>

namespace {

/// Source: Fowler, Noll and Vo, FNV-1a with 64 bits.
std::uint64_t hashed(std::uint64_t hash, const sim::State &state)
{
    sim::visitBytes(state, [&](const void *data, std::size_t bytes) {
        const auto *byte = static_cast<const unsigned char *>(data);
        for (std::size_t i = 0; i < bytes; ++i)
            hash = (hash ^ byte[i]) * 0x100000001b3u;
    });
    return hash;
}

constexpr std::uint64_t begun = 0xcbf29ce484222325u;
constexpr int frames = tests::sized(1000, 300);
constexpr int looks = 10; ///< frames from one look at the state to the next

std::uint64_t hashOfRun(const sim::Script &script)
{
    sim::Track run(script, 0);
    std::uint64_t hash = begun;
    for (int frame = looks; frame <= frames; frame += looks) {
        run.seek({frame, 0});
        hash = hashed(hash, run.state());
    }
    return hash;
}

/// The same run computed row by row, each step phase by phase, in as many blocks as there are islands. It stays where
/// numbers stop being finite, as a Track does.
std::uint64_t hashOfRows(const sim::Script &script, int threads)
{
    const sim::FlushDenormals flush;
    const sim::ComposedIntervals intervals(script);
    sim::ThreadPool pool(threads);
    auto interval = intervals.at(script, 0);
    sim::Pipeline pipeline = interval->pipeline;
    pipeline.blocks = sim::cacheBlocksOf(interval->scene, pipeline.phases, {1, 1});
    sim::State state = interval->scene.start;
    std::uint64_t hash = begun;
    bool goesOn = true;
    const int row = script.step.framesPerOutput;
    for (int frame = looks; frame <= frames; frame += looks) {
        while (goesOn && state.frame + row <= frame) {
            sim::State next = state;
            sim::beginOutputStep(next, script, interval, interval, state.frame + row);
            for (int step = 0; step < script.step.stepsPerOutput; ++step)
                sim::runStep(pipeline, next, pool);
            goesOn = sim::firstStuckPoint(next) < 0 && sim::firstNonFinitePoint(next) < 0;
            if (goesOn)
                state = std::move(next);
        }
        hash = hashed(hash, state);
    }
    return hash;
}

/// An implicit method solves for all of a crowd together, and one that chooses its steps takes some for each touch: a
/// thousand frames of those take too long here.
bool takesLong(const sim::Script &script)
{
    const std::vector<std::string> needs = script.method->requirements();
    const bool solves = std::find(needs.begin(), needs.end(), "slopes") != needs.end();
    return (solves || script.step.isAdaptive()) &&
           sim::sceneOf(script, script.values).start.pointCount() > 500;
}

}

int main(int count, char **arguments)
{
    const int threads = count > 1 ? std::atoi(arguments[1]) : 0;
    constexpr const char *names[] = {"baseline", "avx2", "avx512"};
    std::printf("%s\n", names[static_cast<int>(sim::instructionSet())]);
    for (const QString &lesson : support::lessonIds()) {
        for (const lessons::Step &step : support::loadLesson(lesson).steps) {
            for (const sim::MethodPtr &method : sim::allMethods()) {
                try {
                    const sim::Script script = support::scriptOf(step, method->id());
                    if (takesLong(script))
                        continue;
                    const std::uint64_t hash = threads == 0 ? hashOfRun(script) : hashOfRows(script, threads);
                    std::printf("%s/%s %s %016llx\n", qPrintable(lesson), qPrintable(step.id),
                                method->id().c_str(), static_cast<unsigned long long>(hash));
                } catch (const sim::Error &) {
                    continue; // the method does not fit this step
                }
            }
        }
    }
    return 0;
}

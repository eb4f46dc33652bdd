// Prints one line per lesson step and method, with a hash of 1000 frames (300 under the sanitizers).
// The output must not depend on the instruction set, nor on how the frames are computed:
//   lesson_hashes      as in the app, with sleeping islands and fused phases
//   lesson_hashes 1    without sleeping, one cache block per island, on one thread
//   lesson_hashes 2    the same on two threads

#include "sim/run/finite.h"
#include "sim/run/script/composed_interval.h"
#include "tests/hash.h"
#include "tests/lessons/support/support.h"
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

constexpr int frames = tests::sized(1000, 300);
constexpr int hashInterval = 10; ///< frames from one hashed state to the next

std::uint64_t hashOfRun(const sim::Script &script)
{
    sim::Track run(script, 0);
    std::uint64_t hash = tests::emptyHash;
    for (int frame = hashInterval; frame <= frames; frame += hashInterval) {
        run.seek({frame, 0});
        hash = tests::updatedHash(hash, run.state());
    }
    return hash;
}

/// Returns the same hash, computed step by step with one cache block per island. Like a Track, the run stays
/// at the last finite state.
std::uint64_t hashWithBlocks(const sim::Script &script, int threads)
{
    const sim::FlushDenormals flush;
    const sim::ComposedIntervals intervals(script);
    sim::ThreadPool pool(threads);
    auto interval = intervals.at(script, 0);
    sim::Pipeline pipeline = interval->pipeline;
    pipeline.blocks = sim::cacheBlocksOf(interval->scene, pipeline.phases, {1, 1});
    sim::State state = interval->scene.start;
    std::uint64_t hash = tests::emptyHash;
    bool isRunning = true;
    const int framesPerOutput = script.step.framesPerOutput;
    for (int frame = hashInterval; frame <= frames; frame += hashInterval) {
        while (isRunning && state.frame + framesPerOutput <= frame) {
            sim::State next = state;
            sim::beginOutputStep(next, script, interval, interval, state.frame + framesPerOutput);
            for (int step = 0; step < script.step.stepsPerOutput; ++step)
                sim::runStep(pipeline, next, pool);
            isRunning = sim::firstStuckPoint(next) < 0 && sim::firstNonFinitePoint(next) < 0;
            if (isRunning)
                state = std::move(next);
        }
        hash = tests::updatedHash(hash, state);
    }
    return hash;
}

/// Returns whether a thousand frames take too long here. In a large crowd, an implicit method solves for all
/// points at once, and an adaptive method takes extra steps for each contact.
bool isTooSlow(const sim::Script &script)
{
    const std::vector<std::string> needs = script.method->requirements();
    const bool isImplicit = std::find(needs.begin(), needs.end(), "jacobian") != needs.end();
    return (isImplicit || script.step.isAdaptive()) &&
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
                    if (isTooSlow(script))
                        continue;
                    const std::uint64_t hash =
                        threads == 0 ? hashOfRun(script) : hashWithBlocks(script, threads);
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

// Prints a hash of 1000 frames of every step of every lesson: one line a step and method. What it prints must not depend
// on the instructions that it runs with.

#include "tests/lessons/support.h"

#include "sim/error.h"
#include "sim/methods/methods.h"
#include "sim/track.h"
#include "sim/wide.h"

#include <algorithm>
#include <cstdio>

namespace {

/// Source: Fowler, Noll and Vo, FNV-1a with 64 bits.
std::uint64_t hashed(std::uint64_t hash, const sim::State &state)
{
    sim::visitMemory(state, [&](const void *data, std::size_t bytes) {
        const auto *byte = static_cast<const unsigned char *>(data);
        for (std::size_t i = 0; i < bytes; ++i)
            hash = (hash ^ byte[i]) * 0x100000001b3u;
    });
    return hash;
}

std::uint64_t hashOfRun(const sim::Script &script)
{
    sim::Track run(script, 0);
    std::uint64_t hash = 0xcbf29ce484222325u;
    for (int frame = 10; frame <= 1000; frame += 10) {
        run.seek({frame, 0});
        hash = hashed(hash, run.now());
    }
    return hash;
}

/// In a crowd each touch ends a step of a method that chooses its steps, for all of them, and an implicit one solves for
/// all of them together: a frame of those takes up to seconds.
bool takesLong(const sim::Script &script)
{
    const std::vector<std::string> needs = script.method->needs();
    const bool solves = std::find(needs.begin(), needs.end(), "slopes") != needs.end();
    return (solves || script.step.adaptive()) && sim::sceneOf(script, script.values).start.points() > 500;
}

}

int main()
{
    std::printf("%s\n", sim::hasWideInstructions() ? "wide" : "baseline");
    for (const QString &lesson : support::lessonIds()) {
        for (const lessons::Step &step : support::loadLesson(lesson).steps) {
            for (const sim::MethodPtr &method : sim::allMethods()) {
                try {
                    const sim::Script script = support::scriptOf(step, method->id());
                    if (takesLong(script))
                        continue;
                    const std::uint64_t hash = hashOfRun(script);
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

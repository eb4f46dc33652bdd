#include "lessons/api/checks/exact_run.h"

#include "sim/analysis/accuracy/study_run.h"
#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/run/track.h"

#include <algorithm>
#include <limits>
#include <memory>

namespace lessons {

namespace {

constexpr std::size_t maxCachedRuns = 3;             ///< run, comparison run and edited run
constexpr std::size_t memory = std::size_t{4} << 20; ///< bytes per run

bool differOnlyInMethod(const sim::Script &a, const sim::Script &b)
{
    return a.values == b.values && a.bodies == b.bodies && a.effectsOff == b.effectsOff && a.input == b.input;
}

}

struct ExactRun::CachedRun
{
    sim::Script script;
    std::unique_ptr<sim::Track> track; ///< null for a scene without a continuous limit
};

ExactRun::ExactRun() = default;
ExactRun::~ExactRun() = default;

sim::Track *ExactRun::trackOf(const sim::Script &script)
{
    const auto found = std::find_if(m_cache.begin(), m_cache.end(), [&](const CachedRun &cached) {
        return differOnlyInMethod(cached.script, script);
    });
    if (found != m_cache.end()) {
        m_cache.splice(m_cache.begin(), m_cache, found);
        return m_cache.front().track.get();
    }
    CachedRun cached = {
        sim::scriptFor(script, {sim::findMethod("dop853"), sim::StepSize::withTolerance(tolerance)}), {}};
    try {
        cached.track = std::make_unique<sim::Track>(cached.script, memory);
    } catch (const sim::Error &) { // the scene has no continuous limit
        cached.track = nullptr;
    }
    m_cache.push_front(std::move(cached));
    if (m_cache.size() > maxCachedRuns)
        m_cache.pop_back();
    return m_cache.front().track.get();
}

const sim::State *ExactRun::at(const sim::Script &script, std::int64_t frame)
{
    sim::Track *track = frame >= 0 && frame <= maxFrames ? trackOf(script) : nullptr;
    if (!track)
        return nullptr;
    track->seek({std::min(frame, track->computed()), 0});
    while (track->cursor().frame < frame && track->state().forceEvaluations() < maxEvaluations &&
           !track->stop())
        track->seek({track->cursor().frame + 1, 0});
    return track->cursor().frame == frame ? &track->state() : nullptr;
}

double ExactRun::distance(const sim::Script &script, const sim::State &state, std::int64_t frame)
{
    constexpr double unknown = std::numeric_limits<double>::quiet_NaN();
    const sim::State *exact = at(script, frame);
    if (!exact || exact->pointCount() != state.pointCount())
        return unknown;
    return sim::distanceFrom(sim::placesOf(*exact), state);
}

}

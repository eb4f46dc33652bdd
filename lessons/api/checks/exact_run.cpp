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

constexpr std::size_t keptRuns = 3; ///< the run, its ghost, and the one that a change has just made
constexpr std::size_t memory = std::size_t{4} << 20;

bool sameButForMethod(const sim::Script &a, const sim::Script &b)
{
    return a.values == b.values && a.bodies == b.bodies && a.effectsOff == b.effectsOff && a.input == b.input;
}

}

struct ExactRun::CachedRun
{
    sim::Script script;
    std::unique_ptr<sim::Track> track; ///< null where the scene has none
};

ExactRun::ExactRun() = default;
ExactRun::~ExactRun() = default;

sim::Track *ExactRun::trackOf(const sim::Script &script)
{
    const auto found = std::find_if(m_kept.begin(), m_kept.end(), [&](const CachedRun &kept) {
        return sameButForMethod(kept.script, script);
    });
    if (found != m_kept.end()) {
        m_kept.splice(m_kept.begin(), m_kept, found);
        return m_kept.front().track.get();
    }
    CachedRun kept = {
        sim::scriptFor(script, {sim::findMethod("dop853"), sim::StepSize::withTolerance(tolerance)}), {}};
    try {
        kept.track = std::make_unique<sim::Track>(kept.script, memory);
    } catch (const sim::Error &) { // it has no continuous limit: nothing to compare with
        kept.track = nullptr;
    }
    m_kept.push_front(std::move(kept));
    if (m_kept.size() > keptRuns)
        m_kept.pop_back();
    return m_kept.front().track.get();
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

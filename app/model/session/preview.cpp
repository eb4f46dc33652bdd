#include "app/model/session/preview.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

/// Force evaluations, summed over all points, that a preview may cost: a few milliseconds.
constexpr double mostEvaluations = 200'000.0;

/// Estimates the force evaluations, summed over all points, on the way of `run` to `at`.
double evaluationsTo(const sim::Track &run, sim::Cursor at)
{
    const sim::Script &script = run.script();
    const std::int64_t framesPerOutput = run.framesPerOutput();
    const std::int64_t outputSteps =
        (at.frame - run.cachedFrameBefore(at.frame)) / framesPerOutput + (at.phase > 0 ? 1 : 0);
    // An adaptive method is expected to take as many steps as until now.
    const double counted =
        run.state().forceEvaluations() / static_cast<double>(std::max<std::int64_t>(1, run.cursor().frame));
    const double planned =
        double(std::max(1, script.method->evaluationsPerStep())) * script.step.stepsPerOutput;
    const double perOutputStep = std::max(planned, counted * static_cast<double>(framesPerOutput));
    return static_cast<double>(outputSteps) * perOutputStep * run.state().pointCount();
}

}

bool Preview::canShow(sim::Cursor at) const
{
    if (m_isBusy())
        return false;
    const sim::Track *comparison = m_run.timeline().comparison();
    return evaluationsTo(m_run.timeline().track(), at) +
               (comparison ? evaluationsTo(*comparison, {at.frame, 0}) : 0.0) <=
           mostEvaluations;
}

void Preview::show(sim::Cursor at)
{
    const sim::Timeline &timeline = m_run.timeline();
    const std::int64_t framesPerOutput = timeline.track().framesPerOutput();
    at.frame = std::clamp<std::int64_t>(at.frame, 0, timeline.computed()) / framesPerOutput * framesPerOutput;
    if (m_marked == at && m_shown)
        return;
    if (at == timeline.cursor() || !canShow(at)) {
        mark(at);
        return;
    }
    std::optional<sim::Timeline> shown = std::exchange(m_shown, std::nullopt);
    if (!shown)
        shown.emplace(timeline);
    shown->seek(at);
    set(at, std::move(shown));
}

void Preview::mark(sim::Cursor at)
{
    if (m_marked != at || m_shown)
        set(at, std::nullopt);
}

void Preview::set(sim::Cursor at, std::optional<sim::Timeline> shown)
{
    m_marked = at;
    m_shown = std::move(shown);
    m_run.changes().announce(ChangeKind::preview);
}

void Preview::end()
{
    if (!m_marked)
        return;
    m_marked.reset();
    m_shown.reset();
    m_run.changes().announce(ChangeKind::preview);
}

void Preview::endIfShown()
{
    if (m_shown)
        end();
}

}

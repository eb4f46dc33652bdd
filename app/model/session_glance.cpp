// Looking at another moment than the one where the run stands.

#include "app/model/session.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

/// How often points may feel their forces anew on the way to a moment that is looked at: a few milliseconds.
constexpr double mostWork = 200'000.0;

/// How often that is on the way of `run` to `at`.
double workTo(const sim::Track &run, sim::Cursor at)
{
    const sim::Script &script = run.script();
    const std::int64_t framesPerOutput = run.framesPerOutput();
    const std::int64_t rows =
        (at.frame - run.cachedFrameBefore(at.frame)) / framesPerOutput + (at.phase > 0 ? 1 : 0);
    // A method that chooses its steps takes as many as it took until now.
    const double counted =
        run.state().forceEvaluations() / static_cast<double>(std::max<std::int64_t>(1, run.cursor().frame));
    const double planned =
        double(std::max(1, script.method->evaluationsPerStep())) * script.step.stepsPerOutput;
    const double turns = std::max(planned, counted * static_cast<double>(framesPerOutput));
    return static_cast<double>(rows) * turns * run.state().pointCount();
}

}

bool Session::canShow(sim::Cursor at) const
{
    if (isPlaying() || m_goingTo || m_coming || m_holding || m_pointerDown || m_companionDue)
        return false;
    const sim::Track *ghost = m_timeline->comparison();
    return workTo(m_timeline->track(), at) + (ghost ? workTo(*ghost, {at.frame, 0}) : 0.0) <= mostWork;
}

void Session::glance(sim::Cursor at)
{
    const std::int64_t framesPerOutput = m_timeline->track().framesPerOutput();
    at.frame =
        std::clamp<std::int64_t>(at.frame, 0, m_timeline->computed()) / framesPerOutput * framesPerOutput;
    if (m_marked == at && m_look)
        return;
    if (at == m_timeline->cursor() || !canShow(at)) {
        mark(at);
        return;
    }
    std::optional<sim::Timeline> look = std::exchange(m_look, std::nullopt);
    if (!look)
        look.emplace(*m_timeline);
    look->seek(at);
    setMarked(at, std::move(look));
}

void Session::mark(sim::Cursor at)
{
    if (m_marked != at || m_look)
        setMarked(at, std::nullopt);
}

void Session::setMarked(sim::Cursor at, std::optional<sim::Timeline> look)
{
    const bool wasElsewhere = m_look || look;
    m_marked = at;
    m_look = std::move(look);
    if (m_look)
        bringCompanion(); // what takes longer is not shown
    else if (wasElsewhere)
        bringCompanionLater();
    emit glanceChanged();
}

void Session::endGlance()
{
    if (!m_marked)
        return;
    m_marked.reset();
    if (std::exchange(m_look, std::nullopt))
        bringCompanionLater();
    emit glanceChanged();
}

void Session::lookNoMore()
{
    if (m_look)
        endGlance();
}

}

#include "sim/run/timeline.h"

#include "sim/run/script/composed_interval.h"

#include <algorithm>

namespace sim {

Timeline::Timeline(Script script, std::size_t budget)
    : m_track(std::move(script), budget / 2), m_budget(budget)
{
}

const Values &Timeline::values() const
{
    return m_track.nextInterval()->values;
}

void Timeline::seek(Cursor target)
{
    m_track.seek(target);
    if (m_ghost)
        m_ghost->seek({m_track.cursor().frame, 0});
}

void Timeline::nextPhase()
{
    seek({cursor().frame, cursor().phase + 1});
}

void Timeline::previousPhase()
{
    if (cursor().phase > 0) {
        seek({cursor().frame, cursor().phase - 1});
    } else if (cursor().frame > 0) {
        seek({cursor().frame - m_track.framesPerOutput(), 0});
        seek({cursor().frame, m_track.phasesPerOutput() - 1});
    }
}

void Timeline::nextOutputStep()
{
    seek({cursor().frame + m_track.framesPerOutput(), 0});
}

void Timeline::previousOutputStep()
{
    seek({cursor().phase > 0 ? cursor().frame : cursor().frame - m_track.framesPerOutput(), 0});
}

bool Timeline::openOutputStep(std::int64_t frame)
{
    m_track.seek({cursor().frame, 0});
    if (computed() == cursor().frame)
        return false;
    becomeComparison(frame);
    return true;
}

void Timeline::becomeComparison(std::int64_t fork)
{
    m_ghost = m_track;
    m_ghost->setBudget(m_budget / 2);
    m_ghost->seek({cursor().frame, 0});
    m_fork = fork;
}

namespace {

/// Whether of two events in one row the first has no effect, because the second says the same thing anew.
bool replaces(const Event &second, const Event &first)
{
    if (first.frame != second.frame || first.what.index() != second.what.index())
        return false;
    const auto *was = std::get_if<Pointer>(&first.what);
    const auto *is = std::get_if<Pointer>(&second.what);
    return std::holds_alternative<Move>(first.what) || (was && is->down == was->down);
}

}

bool Timeline::applyInput(const Input &what)
{
    const std::int64_t frame = cursor().frame + m_track.framesPerOutput();
    const Event event = eventOf(frame, what);
    checkFinite(event);
    const int phase = cursor().phase;
    const bool forked = openOutputStep(frame);
    std::vector<Event> input = script().input;
    std::erase_if(input, [&](const Event &other) { return other.frame > frame; });
    if (!input.empty() && replaces(event, input.back()))
        input.pop_back();
    input.push_back(event);
    m_track.replaceInput(m_track.prepareInput(std::move(input), frame));
    m_fork = std::min(m_fork, frame);
    seek({cursor().frame, phase});
    return forked;
}

bool Timeline::setParameter(const std::string &parameter, double value)
{
    if (cursor().frame == 0) {
        Script changed = script();
        changed.values.set(parameter, value);
        return replaceScript(std::move(changed));
    }
    const std::int64_t frame = cursor().frame + m_track.framesPerOutput();
    std::vector<Event> input = script().input;
    std::erase_if(input, [&](const Event &event) {
        const Set *set = std::get_if<Set>(&event.what);
        return event.frame == frame && set && set->parameter == parameter;
    });
    input.push_back({frame, Set{parameter, value}});
    sortByFrame(input);
    Track::NewInput changed = m_track.prepareInput(std::move(input), frame);
    const int phase = cursor().phase;
    const bool forked = openOutputStep(frame);
    m_track.replaceInput(std::move(changed));
    m_fork = std::min(m_fork, frame);
    seek({cursor().frame, phase});
    return forked;
}

bool Timeline::replaceScript(Script script)
{
    Track next(std::move(script), m_budget / 2);
    const Cursor was = cursor();
    const bool forked = computed() > 0;
    if (forked)
        becomeComparison(0);
    m_track = std::move(next);
    seek({was.frame, 0});
    if (was.phase > 0)
        seek({was.frame, std::min(was.phase, m_track.phasesPerOutput() - 1)});
    return forked;
}

bool Timeline::replaceInput(std::vector<Event> input)
{
    if (input == script().input)
        return false;
    const std::int64_t frame = firstDifference(script().input, input);
    Track::NewInput changed = m_track.prepareInput(std::move(input), frame);
    const Cursor was = cursor();
    m_track.seek({std::min(was.frame, std::max<std::int64_t>(0, frame - 1)), 0});
    const bool forked = computed() > cursor().frame;
    if (forked)
        becomeComparison(frame);
    m_track.replaceInput(std::move(changed));
    m_fork = std::min(m_fork, frame);
    seek(was);
    return forked;
}

bool Timeline::isFinished() const
{
    return m_track.isFinished() && cursor().frame >= computed() && (!m_ghost || m_ghost->isFinished());
}

bool Timeline::hasPendingInput() const
{
    if (cursor().phase != 0 || computed() > cursor().frame)
        return false;
    const std::int64_t frame = cursor().frame + m_track.framesPerOutput();
    const std::vector<Event> &input = script().input;
    return std::any_of(input.begin(), input.end(), [&](const Event &event) {
        return event.frame <= frame && event.frame > cursor().frame - (cursor().frame == 0 ? 1 : 0);
    });
}

void Timeline::dropComparison()
{
    m_ghost.reset();
}

void Timeline::setComparison(Track run, std::int64_t fork)
{
    m_ghost = std::move(run);
    m_ghost->setBudget(comparisonBudget());
    m_ghost->seek({cursor().frame, 0});
    m_fork = fork;
}

void Timeline::swapWithComparison()
{
    std::swap(m_track, *m_ghost);
    seek({std::max(cursor().frame, m_ghost->cursor().frame), 0});
}

}

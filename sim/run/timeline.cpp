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
    return m_track.next()->values;
}

void Timeline::seek(Cursor target)
{
    m_track.seek(target);
    if (m_ghost)
        m_ghost->seek({m_track.at().frame, 0});
}

void Timeline::stepPhase()
{
    seek({at().frame, at().phase + 1});
}

void Timeline::stepPhaseBack()
{
    if (at().phase > 0) {
        seek({at().frame, at().phase - 1});
    } else if (at().frame > 0) {
        seek({at().frame - m_track.rowFrames(), 0});
        seek({at().frame, m_track.phasesPerRow() - 1});
    }
}

void Timeline::stepRow()
{
    seek({at().frame + m_track.rowFrames(), 0});
}

void Timeline::stepRowBack()
{
    seek({at().phase > 0 ? at().frame : at().frame - m_track.rowFrames(), 0});
}

bool Timeline::openRow(std::int64_t frame)
{
    m_track.seek({at().frame, 0});
    if (computed() == at().frame)
        return false;
    becomeGhost(frame);
    return true;
}

void Timeline::becomeGhost(std::int64_t fork)
{
    m_ghost = m_track;
    m_ghost->setBudget(m_budget / 2);
    m_ghost->seek({at().frame, 0});
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

bool Timeline::hand(const Input &what)
{
    const std::int64_t frame = at().frame + m_track.rowFrames();
    const Event event = eventOf(frame, what);
    checkFinite(event);
    const int phase = at().phase;
    const bool forked = openRow(frame);
    std::vector<Event> input = script().input;
    std::erase_if(input, [&](const Event &other) { return other.frame > frame; });
    if (!input.empty() && replaces(event, input.back()))
        input.pop_back();
    input.push_back(event);
    m_track.replaceInput(m_track.prepared(std::move(input), frame));
    m_fork = std::min(m_fork, frame);
    seek({at().frame, phase});
    return forked;
}

bool Timeline::set(const std::string &parameter, double value)
{
    if (at().frame == 0) {
        Script changed = script();
        changed.values.set(parameter, value);
        return replace(std::move(changed));
    }
    const std::int64_t frame = at().frame + m_track.rowFrames();
    std::vector<Event> input = script().input;
    std::erase_if(input, [&](const Event &event) {
        const Set *set = std::get_if<Set>(&event.what);
        return event.frame == frame && set && set->parameter == parameter;
    });
    input.push_back({frame, Set{parameter, value}});
    sortByFrame(input);
    Track::NewInput changed = m_track.prepared(std::move(input), frame);
    const int phase = at().phase;
    const bool forked = openRow(frame);
    m_track.replaceInput(std::move(changed));
    m_fork = std::min(m_fork, frame);
    seek({at().frame, phase});
    return forked;
}

bool Timeline::replace(Script script)
{
    Track next(std::move(script), m_budget / 2);
    const Cursor was = at();
    const bool forked = computed() > 0;
    if (forked)
        becomeGhost(0);
    m_track = std::move(next);
    seek({was.frame, 0});
    if (was.phase > 0)
        seek({was.frame, std::min(was.phase, m_track.phasesPerRow() - 1)});
    return forked;
}

bool Timeline::replaceInput(std::vector<Event> input)
{
    if (input == script().input)
        return false;
    const std::int64_t frame = firstDifference(script().input, input);
    Track::NewInput changed = m_track.prepared(std::move(input), frame);
    const Cursor was = at();
    m_track.seek({std::min(was.frame, std::max<std::int64_t>(0, frame - 1)), 0});
    const bool forked = computed() > at().frame;
    if (forked)
        becomeGhost(frame);
    m_track.replaceInput(std::move(changed));
    m_fork = std::min(m_fork, frame);
    seek(was);
    return forked;
}

bool Timeline::isOver() const
{
    return m_track.isOver() && at().frame >= computed() && (!m_ghost || m_ghost->isOver());
}

bool Timeline::hasPending() const
{
    if (at().phase != 0 || computed() > at().frame)
        return false;
    const std::int64_t frame = at().frame + m_track.rowFrames();
    const std::vector<Event> &input = script().input;
    return std::any_of(input.begin(), input.end(), [&](const Event &event) {
        return event.frame <= frame && event.frame > at().frame - (at().frame == 0 ? 1 : 0);
    });
}

void Timeline::forgetGhost()
{
    m_ghost.reset();
}

void Timeline::showBeside(Track run, std::int64_t fork)
{
    m_ghost = std::move(run);
    m_ghost->setBudget(ghostBudget());
    m_ghost->seek({at().frame, 0});
    m_fork = fork;
}

void Timeline::swapWithGhost()
{
    std::swap(m_track, *m_ghost);
    seek({std::max(at().frame, m_ghost->at().frame), 0});
}

}

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
    if (m_comparison)
        m_comparison->seek({m_track.cursor().frame, 0});
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

bool Timeline::prepareEdit(std::int64_t frame)
{
    m_track.seek({cursor().frame, 0});
    if (computed() == cursor().frame)
        return false;
    copyToComparison(frame);
    return true;
}

void Timeline::copyToComparison(std::int64_t forkFrame)
{
    m_comparison = m_track;
    m_comparison->setBudget(m_budget / 2);
    m_comparison->seek({cursor().frame, 0});
    m_forkFrame = forkFrame;
}

namespace {

/// Returns whether `second` cancels the effect of `first` in the same output step: both move the same
/// pointer, or the dragged body.
bool replaces(const Event &second, const Event &first)
{
    if (first.frame != second.frame || first.what.index() != second.what.index())
        return false;
    const auto *firstPointer = std::get_if<Pointer>(&first.what);
    const auto *secondPointer = std::get_if<Pointer>(&second.what);
    return std::holds_alternative<Move>(first.what) ||
           (firstPointer && secondPointer->down == firstPointer->down);
}

}

bool Timeline::applyInput(const Input &what)
{
    const std::int64_t frame = cursor().frame + m_track.framesPerOutput();
    const Event event = eventOf(frame, what);
    checkFinite(event);
    const int phase = cursor().phase;
    const bool forked = prepareEdit(frame);
    std::vector<Event> input = script().input;
    std::erase_if(input, [&](const Event &other) { return other.frame > frame; });
    if (!input.empty() && replaces(event, input.back()))
        input.pop_back();
    input.push_back(event);
    m_track.replaceInput(m_track.prepareInput(std::move(input), frame));
    m_forkFrame = std::min(m_forkFrame, frame);
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
    const bool forked = prepareEdit(frame);
    m_track.replaceInput(std::move(changed));
    m_forkFrame = std::min(m_forkFrame, frame);
    seek({cursor().frame, phase});
    return forked;
}

bool Timeline::replaceScript(Script script)
{
    Track next(std::move(script), m_budget / 2);
    const Cursor before = cursor();
    const bool forked = computed() > 0;
    if (forked)
        copyToComparison(0);
    m_track = std::move(next);
    seek({before.frame, 0});
    if (before.phase > 0)
        seek({before.frame, std::min(before.phase, m_track.phasesPerOutput() - 1)});
    return forked;
}

void Timeline::correctScript(Script script)
{
    Track next(std::move(script), m_budget / 2);
    const Cursor before = cursor();
    m_track = std::move(next);
    m_forkFrame = 0;
    seek({before.frame, 0});
}

bool Timeline::replaceInput(std::vector<Event> input)
{
    if (input == script().input)
        return false;
    const std::int64_t frame = firstDifference(script().input, input);
    Track::NewInput changed = m_track.prepareInput(std::move(input), frame);
    const Cursor before = cursor();
    m_track.seek({std::min(before.frame, std::max<std::int64_t>(0, frame - 1)), 0});
    const bool forked = computed() > cursor().frame;
    if (forked)
        copyToComparison(frame);
    m_track.replaceInput(std::move(changed));
    m_forkFrame = std::min(m_forkFrame, frame);
    seek(before);
    return forked;
}

bool Timeline::isFinished() const
{
    return m_track.isFinished() && cursor().frame >= computed() &&
           (!m_comparison || m_comparison->isFinished());
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
    m_comparison.reset();
}

void Timeline::setComparison(Track run, std::int64_t forkFrame)
{
    m_comparison = std::move(run);
    m_comparison->setBudget(comparisonBudget());
    m_comparison->seek({cursor().frame, 0});
    m_forkFrame = forkFrame;
}

void Timeline::swapWithComparison()
{
    std::swap(m_track, *m_comparison);
    seek({std::max(cursor().frame, m_comparison->cursor().frame), 0});
}

}

// How a run sleeps: what is known of it without computing, and when it has come to rest.

#include "sim/run/script/row_start.h"
#include "sim/run/track.h"

#include <algorithm>
#include <limits>

namespace sim {

namespace {

/// Bytes that the states of one round may take, if they are several.
constexpr std::size_t mostOfARound = std::size_t{16} << 20;

}

std::int64_t Track::knownBefore(std::int64_t frame) const
{
    const std::int64_t kept = m_history.before(frame);
    const Sleep *sleep = m_history.sleepBefore(frame);
    const std::int64_t row = frame / rowFrames() * rowFrames();
    return sleep ? std::max(kept, std::min(row, lastOf(*sleep))) : kept;
}

State Track::known(std::int64_t frame) const
{
    const std::int64_t nearest = knownBefore(frame);
    const Sleep *sleep = sleepAt(nearest);
    return sleep ? sleep->at(nearest) : m_history.at(nearest);
}

const Sleep *Track::sleepAt(std::int64_t frame) const
{
    const Sleep *sleep = m_history.sleepBefore(frame);
    return sleep && frame <= lastOf(*sleep) ? sleep : nullptr;
}

std::int64_t Track::lastOf(const Sleep &sleep) const
{
    const std::optional<std::int64_t> wakes = nextInput(m_script, sleep.from());
    return wakes ? *wakes - rowFrames() : std::numeric_limits<std::int64_t>::max();
}

bool Track::isOver() const
{
    if (m_stop && m_at.frame == m_stop->frame)
        return true;
    const Sleep *sleep = this->sleep();
    return m_at.phase == 0 && sleep && sleep->isStill() && !nextInput(m_script, sleep->from());
}

void Track::fallAsleep()
{
    if (m_sleeping == Sleeping::never)
        return;
    blocksFallAsleep();
    const std::optional<SleepWatch::Again> again = m_watch.look(m_now, rowFrames());
    const std::int64_t rows = again ? (m_at.frame - again->since) / rowFrames() : 0;
    const bool fits = rows == 1 || static_cast<std::size_t>(rows) * memoryOf(m_now) <= mostOfARound;
    if (!again || !fits || nextInput(m_script, again->since).value_or(m_at.frame + 1) <= m_at.frame ||
        keepsAwake(m_segment->pipeline, m_now))
        return;
    // The round that has just ended is the one that comes, too, unless something comes in: so input to come, which may
    // be another one by then, is not in it.
    std::vector<std::shared_ptr<const State>> round;
    State state = *m_watch.mark();
    while (static_cast<std::int64_t>(round.size()) < rows) {
        auto later = std::make_shared<State>(state);
        later->frame += rows * rowFrames();
        later->evaluations += again->evaluations;
        round.push_back(std::move(later));
        if (static_cast<std::int64_t>(round.size()) < rows)
            runRow(state, state.frame + rowFrames(), {});
    }
    m_history.add(Sleep(std::move(round), rowFrames(), again->evaluations));
}

void Track::blocksFallAsleep()
{
    const State *mark = m_watch.mark();
    if (!m_segment->pipeline.blocks.empty() && mark && mark->frame + rowFrames() == m_at.frame &&
        m_segments.isSameStretch(mark->frame, m_at.frame))
        m_blocks.look(m_segment->pipeline, *mark, m_now);
}

bool Track::sleepOn(std::int64_t frame)
{
    const Sleep *sleep = sleepAt(m_at.frame);
    const std::int64_t to = sleep ? std::min(frame, lastOf(*sleep)) : m_at.frame;
    if (to <= m_at.frame)
        return false;
    sleep->take(m_now, to);
    m_at = {to, 0};
    m_segment = segmentAt(to);
    m_computed = std::max(m_computed, to);
    return true;
}

}

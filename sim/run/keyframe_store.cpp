#include "sim/run/keyframe_store.h"

#include <algorithm>
#include <iterator>

namespace sim {

namespace {

/// Returns the memory of a keyframe, with the map's node, the pointer's counters and the allocator's headers.
std::size_t costOf(const State &state)
{
    constexpr std::size_t bookkeeping = 192;
    return byteSize(state) + bookkeeping;
}

}

void KeyframeStore::store(const State &state)
{
    const std::int64_t outputStep = state.frame / m_framesPerOutput;
    if (outputStep % m_spacing != 0 || (m_budget == 0 && outputStep > 0) || m_keyframes.contains(state.frame))
        return;
    m_keyframes.emplace(state.frame, std::make_shared<const State>(state));
    m_bytes += costOf(state);
    dropExcess();
}

std::int64_t KeyframeStore::lastAtOrBefore(std::int64_t frame) const
{
    return std::prev(m_keyframes.upper_bound(frame))->first;
}

void KeyframeStore::add(Sleep sleep)
{
    const auto after =
        std::upper_bound(m_sleeps.begin(), m_sleeps.end(), sleep.from(),
                         [](std::int64_t frame, const Sleep &other) { return frame < other.from(); });
    m_sleepBytes += sleep.bytes();
    m_sleeps.insert(after, std::move(sleep));
    dropExcess();
}

void KeyframeStore::dropSleep(std::vector<Sleep>::iterator sleep)
{
    m_sleepBytes -= sleep->bytes();
    m_sleeps.erase(sleep);
}

const Sleep *KeyframeStore::lastSleepAtOrBefore(std::int64_t frame) const
{
    const auto after =
        std::upper_bound(m_sleeps.begin(), m_sleeps.end(), frame,
                         [](std::int64_t at, const Sleep &sleep) { return at < sleep.from(); });
    return after == m_sleeps.begin() ? nullptr : &*std::prev(after);
}

void KeyframeStore::forget(std::int64_t frame)
{
    while (m_keyframes.rbegin()->first >= frame) { // from the end: a drag edits there many times a second
        m_bytes -= costOf(*m_keyframes.rbegin()->second);
        m_keyframes.erase(std::prev(m_keyframes.end()));
    }
    while (!m_sleeps.empty() && m_sleeps.back().from() >= frame)
        dropSleep(std::prev(m_sleeps.end()));
}

void KeyframeStore::setBudget(std::size_t budget)
{
    m_budget = budget;
    dropExcess();
}

void KeyframeStore::dropExcess()
{
    while (m_keyframes.size() > 1 && m_bytes > m_budget) {
        m_spacing *= 2;
        std::erase_if(m_keyframes, [this](const auto &keyframe) {
            const bool isDropped = keyframe.first / m_framesPerOutput % m_spacing != 0;
            m_bytes -= isDropped ? costOf(*keyframe.second) : 0;
            return isDropped;
        });
    }
    while (m_sleeps.size() > 1 && m_sleepBytes > m_budget)
        dropSleep(m_sleeps.begin());
}

}

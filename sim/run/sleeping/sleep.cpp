#include "sim/run/sleeping/sleep.h"

#include "sim/pipeline/pipeline.h"

#include <algorithm>
#include <cstring>

namespace sim {

namespace {

/// How far apart two states are in what a learner sees.
double apart(const State &a, const State &b)
{
    const auto most = [](const auto &x, const auto &y) {
        return x.size() == 0 ? 0.0 : static_cast<double>((x - y).abs().maxCoeff());
    };
    double largest = most(a.gait, b.gait);
    forEachColumn([&](Column kind, auto values) {
        if (kind == Column::motion)
            largest = std::max(largest, most(a.*values, b.*values));
    });
    return largest;
}

template <class Array>
bool sameNumbers(const Array &a, const Array &b)
{
    return a.size() == b.size() &&
           (a.size() == 0 ||
            std::memcmp(a.data(), b.data(), static_cast<std::size_t>(a.size()) * sizeof *a.data()) == 0);
}

}

Sleep::Sleep(std::vector<std::shared_ptr<const State>> states, int rowFrames, std::int64_t evaluations)
    : m_states(std::move(states)), m_rowFrames(rowFrames), m_evaluations(evaluations),
      m_isStill(std::all_of(m_states.begin(), m_states.end(), [this](const auto &state) {
          constexpr double seen = 1e-6;
          return apart(*state, *m_states.front()) <= seen;
      }))
{
}

std::size_t Sleep::indexAt(std::int64_t frame) const
{
    return static_cast<std::size_t>((frame - from()) / m_rowFrames % period());
}

State Sleep::at(std::int64_t frame) const
{
    State state = *m_states[indexAt(frame)];
    take(state, frame);
    return state;
}

void Sleep::take(State &state, std::int64_t frame) const
{
    const std::size_t index = indexAt(frame);
    if (indexAt(state.frame) != index)
        state = *m_states[index];
    const std::int64_t rounds = (frame - from()) / m_rowFrames / period();
    state.frame = frame;
    state.evaluations = m_states[index]->evaluations + rounds * m_evaluations;
}

std::size_t Sleep::bytes() const
{
    std::size_t total = 0;
    for (const auto &state : m_states)
        total += memoryOf(*state);
    return total;
}

std::optional<SleepWatch::Again> SleepWatch::look(const State &state, int rowFrames)
{
    const std::int64_t rows = m_mark ? (state.frame - m_mark->frame) / rowFrames : 0;
    if (rows > 0 && rows <= longest && runOnAlike(*m_mark, state))
        return Again{m_mark->frame, state.evaluations - m_mark->evaluations};
    if (rows <= 0 || rows >= longest)
        m_mark = state;
    return {};
}

void SleepWatch::forget(std::int64_t frame)
{
    if (m_mark && m_mark->frame >= frame)
        m_mark.reset();
}

bool runOnAlike(const State &a, const State &b)
{
    // First what differs while anything moves: it costs next to nothing.
    bool same = true;
    forEachColumn([&](Column kind, auto values) {
        same = same && (kind != Column::motion || sameNumbers(a.*values, b.*values));
    });
    if (!same || !sameNumbers(a.gait, b.gait) || a.ahead != b.ahead)
        return false;
    State later = b;
    later.frame = a.frame;
    later.evaluations = a.evaluations;
    return sameBits(a, later);
}

EffectPtr keepsAwake(const Pipeline &pipeline, const State &state)
{
    for (const Phase &phase : pipeline.phases) {
        if (phase.effect && !phase.effect->isTimeless(state))
            return phase.effect;
        for (const EffectPtr &effect : phase.within) {
            if (!effect->isTimeless(state))
                return effect;
        }
    }
    return nullptr;
}

}

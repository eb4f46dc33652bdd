#include "sim/run/sleeping/sleep.h"

#include "sim/pipeline/pipeline.h"

#include <algorithm>
#include <cstring>

namespace sim {

namespace {

/// Returns the largest difference of two states in the visible columns.
double visibleDifference(const State &a, const State &b)
{
    const auto difference = [](const auto &x, const auto &y) {
        return x.size() == 0 ? 0.0 : static_cast<double>((x - y).abs().maxCoeff());
    };
    double largest = difference(a.gait, b.gait);
    forEachColumn([&](ColumnKind kind, auto values) {
        if (kind == ColumnKind::motion)
            largest = std::max(largest, difference(a.*values, b.*values));
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

Sleep::Sleep(std::vector<std::shared_ptr<const State>> states, int framesPerOutput, std::int64_t evaluations)
    : m_states(std::move(states)), m_framesPerOutput(framesPerOutput), m_evaluations(evaluations),
      m_isStill(std::all_of(m_states.begin(), m_states.end(), [this](const auto &state) {
          constexpr double invisible = 1e-6;
          return visibleDifference(*state, *m_states.front()) <= invisible;
      }))
{
}

std::size_t Sleep::indexAt(std::int64_t frame) const
{
    return static_cast<std::size_t>((frame - from()) / m_framesPerOutput % period());
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
    const std::int64_t cycles = (frame - from()) / m_framesPerOutput / period();
    state.frame = frame;
    state.pointEvaluations = m_states[index]->pointEvaluations + cycles * m_evaluations;
}

std::size_t Sleep::bytes() const
{
    std::size_t total = 0;
    for (const auto &state : m_states)
        total += byteSize(*state);
    return total;
}

std::optional<CycleDetector::Repetition> CycleDetector::check(const State &state, int framesPerOutput)
{
    const std::int64_t period = m_mark ? (state.frame - m_mark->frame) / framesPerOutput : 0;
    if (period > 0 && period <= longest && continueIdentically(*m_mark, state))
        return Repetition{m_mark->frame, state.pointEvaluations - m_mark->pointEvaluations};
    if (period <= 0 || period >= longest)
        m_mark = state;
    return {};
}

void CycleDetector::forget(std::int64_t frame)
{
    if (m_mark && m_mark->frame >= frame)
        m_mark.reset();
}

bool continueIdentically(const State &a, const State &b)
{
    // First the columns that differ while anything moves: this test is cheap.
    bool same = true;
    forEachColumn([&](ColumnKind kind, auto values) {
        same = same && (kind != ColumnKind::motion || sameNumbers(a.*values, b.*values));
    });
    if (!same || !sameNumbers(a.gait, b.gait) || a.adaptiveSteps != b.adaptiveSteps)
        return false;
    State later = b;
    later.frame = a.frame;
    later.pointEvaluations = a.pointEvaluations;
    return sameBits(a, later);
}

EffectPtr preventsSleep(const Pipeline &pipeline, const State &state)
{
    for (const Phase &phase : pipeline.phases) {
        if (phase.effect && !phase.effect->isTimeIndependent(state))
            return phase.effect;
        for (const EffectPtr &effect : phase.innerEffects) {
            if (!effect->isTimeIndependent(state))
                return effect;
        }
    }
    return nullptr;
}

}

#pragma once

#include "sim/forward.h"
#include "sim/scene/state.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace sim {

/// Whether a run that repeats itself may sleep.
enum class Sleeping {
    allowed, ///< output steps that repeat are not computed again
    never,   ///< every output step is computed
};

/// A part of a run that repeats a cycle of a few states until the next input.
class Sleep
{
public:
    /// `states`: one cycle, at the ends of consecutive output steps. `evaluations`: the increase of
    /// State::pointEvaluations per cycle.
    Sleep(std::vector<std::shared_ptr<const State>> states, int framesPerOutput, std::int64_t evaluations);

    /// Returns the first frame of the sleep.
    std::int64_t from() const { return m_states.front()->frame; }
    /// Returns the number of output steps in a cycle.
    int period() const { return static_cast<int>(m_states.size()); }
    /// Returns the state at `frame`, which is from() or later.
    State at(std::int64_t frame) const;
    /// Changes `state`, one of this sleep, into the state at `frame`.
    void take(State &state, std::int64_t frame) const;
    /// Returns whether the sleep shows no motion: all states differ by at most 1e-6 px (px/frame, degrees,
    /// degrees/frame, rad) from the first one.
    bool isStill() const { return m_isStill; }
    /// Returns the memory of the states, in bytes.
    std::size_t bytes() const;

private:
    /// Returns the index of the state at `frame`.
    std::size_t indexAt(std::int64_t frame) const;

    std::vector<std::shared_ptr<const State>> m_states;
    int m_framesPerOutput;
    std::int64_t m_evaluations;
    bool m_isStill;
};

/// Detects that a run repeats itself. It remembers one state and compares all later ones with it. After
/// `longest` output steps it remembers a new one. The comparison mostly ends at the first number.
/// Source: Brent, "An improved Monte Carlo factorization algorithm", BIT 20, 1980, section 2, with a bounded
/// period
class CycleDetector
{
public:
    /// The longest cycle that is detected, in output steps.
    static constexpr int longest = 64;

    /// A repetition: the run has reached a state again.
    struct Repetition
    {
        std::int64_t since = 0;       ///< the frame of the first occurrence
        std::int64_t evaluations = 0; ///< increase of State::pointEvaluations since then
    };
    /// Compares `state`, the end of an output step of `framesPerOutput` frames, with the remembered one.
    /// Returns the repetition if they have the same future.
    std::optional<Repetition> check(const State &state, int framesPerOutput);
    /// Returns the remembered state, or null.
    const State *mark() const { return m_mark ? &*m_mark : nullptr; }
    /// Forgets the remembered state if it is at or after `frame`.
    void forget(std::int64_t frame);

private:
    std::optional<State> m_mark;
};

/// Returns whether two states have the same future: all bits except State::frame and State::pointEvaluations
/// are equal.
bool continueIdentically(const State &a, const State &b);

/// Returns the first effect in `pipeline` that depends on the frame number in `state`, which prevents sleep,
/// or null.
EffectPtr preventsSleep(const Pipeline &pipeline, const State &state);

}

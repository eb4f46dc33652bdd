#pragma once

#include "sim/forward.h"
#include "sim/scene/state.h"

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

namespace sim {

/// Whether a run that has come to rest may sleep.
enum class Sleeping {
    allowed, ///< it does not compute again what can only be the same
    never,   ///< it computes each row
};

/// Rows of a run that go through the same few states over and over, until something comes in from outside.
class Sleep
{
public:
    /// `states`: those of one round, at the ends of neighbouring rows. `evaluations`: by how much a round raises
    /// State::evaluations.
    Sleep(std::vector<std::shared_ptr<const State>> states, int framesPerOutput, std::int64_t evaluations);

    /// The frame at which the round is first seen to begin.
    std::int64_t from() const { return m_states.front()->frame; }
    /// Rows in a round.
    int period() const { return static_cast<int>(m_states.size()); }
    /// The state at the end of the row at `frame`, which is from() or later.
    State at(std::int64_t frame) const;
    /// The same, for a state of this sleep: takes it on, or back, to `frame`.
    void take(State &state, std::int64_t frame) const;
    /// Whether there is nothing to see in it: nothing is ever farther than 1e-6 px (px/frame, degrees, rad) from where
    /// it was. It then differs in the last digits only.
    bool isStill() const { return m_isStill; }
    std::size_t bytes() const;

private:
    /// Which of the states it is in at `frame`.
    std::size_t indexAt(std::int64_t frame) const;

    std::vector<std::shared_ptr<const State>> m_states;
    int m_framesPerOutput;
    std::int64_t m_evaluations;
    bool m_isStill;
};

/// Finds out that a run has come to rest. It remembers one state and compares each that follows with it; after `longest`
/// rows it takes another one. The comparison mostly ends at the first number.
/// Source: Brent, "An improved Monte Carlo factorization algorithm", BIT 20, 1980, section 2, with the period bounded.
class CycleDetector
{
public:
    /// The longest round that is noticed, in rows.
    static constexpr int longest = 64;

    /// That a run is in a state again.
    struct Again
    {
        std::int64_t since = 0; ///< the frame at which it was in it
        std::int64_t evaluations =
            0; ///< how often forces were computed from there on, see State::evaluations
    };
    /// Looks at `state`, which a run is in at the end of a row of `rowFrames` frames.
    std::optional<Again> check(const State &state, int framesPerOutput);
    /// The state that it remembers; null if none.
    const State *mark() const { return m_mark ? &*m_mark : nullptr; }
    /// Forgets what it remembers from `frame` on.
    void forget(std::int64_t frame);

private:
    std::optional<State> m_mark;
};

/// Whether two states run on alike: all bits are the same, but for the number of the frame and State::evaluations.
bool continueIdentically(const State &a, const State &b);

/// The first effect in `pipeline` that looks at the number of the frame when the scene is in `state`: it keeps awake
/// what rests. Null if there is none.
EffectPtr preventsSleep(const Pipeline &pipeline, const State &state);

}

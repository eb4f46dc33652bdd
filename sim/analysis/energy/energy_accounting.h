#pragma once

#include "sim/analysis/energy/power_integrals.h"
#include "sim/run/track.h"

namespace sim {

/// Keeps the books of one segment of a run: what each phase of a row does to energy and momentum.
class EnergyAccounting
{
public:
    /// The segment's scene must have energy: see Meter::whyNot(). `segment` must outlive this.
    EnergyAccounting(const ComposedInterval &interval, DirectionRule directionRule);

    const StoredEnergyReader &meter() const { return m_reader; }
    /// Runs the phases of a row on `state`, which has taken the row's input already, and books what they do.
    void row(State &state, Balance &into) const;

private:
    /// What a force has gathered and no kick has spent.
    struct Gathered
    {
        EffectPtr effect;
        Eigen::ArrayX2d pull;
        Eigen::ArrayXd turn;
        Vec2 heldPush; ///< see heldPush()
    };
    struct Gathering
    {
        std::vector<Gathered> forces;
        bool isSpent = false; ///< a kick has been: what comes next is gathered anew
    };

    /// A clock that ran on in a step.
    struct Tick
    {
        State before;
        State after;
    };
    /// What a step has done so far that cannot be booked yet.
    struct Open
    {
        Gathering gathering;
        std::vector<Tick> ticks;
    };

    void step(State &state, Balance &into) const;
    void wholeStep(State &state, std::size_t first, std::size_t last, Balance &into) const;
    void onePhase(const Phase &phase, State &state, Open &open, Balance &into) const;
    void gather(const Phase &phase, const State &before, const State &after, Gathering &gathering,
                Balance &into) const;
    void kick(const Phase &phase, const State &before, const State &after, Gathering &gathering,
              Balance &into) const;
    /// What a clock that turns legs, say, adds to what is stored, where things stood when the step began and where they
    /// stand at its end: half of each, as a clock runs while they move, whenever in the step the method looks at it.
    void clock(const Tick &tick, const State &start, const State &end, Balance &into) const;
    void change(Account account, const State &before, const State &after, Balance &into) const;

    const ComposedInterval &m_interval;
    DirectionRule m_directionRule;
    StoredEnergyReader m_reader;
    PowerIntegrals m_integrals;
};

}

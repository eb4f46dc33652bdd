#pragma once

#include "sim/scene/effect.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace sim {

/// One call of an effect, with all that it was given, to be done again on what is its own.
class Replay
{
public:
    virtual ~Replay() = default;
    virtual void run(int times) = 0;
};

/// `call` as a Replay: only the first of many in a row costs more than the call itself.
template <class Call>
std::unique_ptr<Replay> replayOf(Call call)
{
    class Again : public Replay
    {
    public:
        explicit Again(Call again) : m_call(std::move(again)) {}
        void run(int times) override
        {
            for (int i = 0; i < times; ++i)
                m_call();
        }

    private:
        Call m_call;
    };
    return std::make_unique<Again>(std::move(call));
}

/// Calls of one kind.
struct Calls
{
    std::int64_t count = 0;
    std::int64_t every = 0; ///< keeps the first of each so many; 0: none
    std::vector<std::unique_ptr<Replay>> kept;

    /// Counts one, and keeps what `make()` gives if it is its turn.
    template <class Make>
    void add(Make &&make)
    {
        if (every > 0 && count % every == 0)
            kept.push_back(make());
        ++count;
    }
};

/// What a method asked of one effect.
class CallCounter
{
public:
    /// `movers`: for each point whether the effect computes something when it is that point's turn.
    explicit CallCounter(std::vector<char> movers);

    Calls acts;   ///< that did what the effect is for
    Calls slopes; ///< that asked for derivatives
    /// How often all points had their turn; a call for one group counts as its part of them.
    double evaluations = 0.0;
    /// How many more times each call is done, on numbers that nobody reads.
    int repeats = 0;
    Eigen::ArrayX2d pulls; ///< where repeated calls of forces add to
    Eigen::ArrayXd turns;  ///< the same of torques
    State state;           ///< what repeated calls of drivers drive
    Jacobian found{0};     ///< where repeated calls for derivatives put them

    /// Nothing was asked so far. What is kept stays.
    void restart()
    {
        acts.count = slopes.count = 0;
        evaluations = 0.0;
    }
    /// Counts the turn of `points`.
    void turn(PointRange points) { evaluations += shareOf(points); }
    /// Makes room for repeated calls on what looks like `like`, as soon as there may be any.
    void makeRoom(const State &like)
    {
        if ((acts.every == 0 && repeats == 0) || state.pointCount() == like.pointCount())
            return;
        state = like;
        pulls.setZero(like.pointCount(), 2);
        turns.setZero(like.pointCount());
    }

private:
    double shareOf(PointRange points);

    std::vector<char> m_movers;
    std::ptrdiff_t m_all; ///< movers
    /// Those asked for before, by first point and count: one that computes island by island asks for many.
    std::map<std::pair<int, int>, double> m_shares;
};

}

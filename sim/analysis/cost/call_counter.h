#pragma once

#include "sim/scene/effect.h"

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <utility>
#include <vector>

namespace sim {

/// A recorded call of an effect. It keeps copies of its arguments and can be repeated on them.
class Replay
{
public:
    virtual ~Replay() = default;
    virtual void run(int times) = 0;
};

/// Returns `call` as a Replay. The virtual call happens once per run(), so many repetitions cost no more than
/// direct calls.
template <class Call>
std::unique_ptr<Replay> replayOf(Call call)
{
    class CallReplay : public Replay
    {
    public:
        explicit CallReplay(Call recorded) : m_call(std::move(recorded)) {}
        void run(int times) override
        {
            for (int i = 0; i < times; ++i)
                m_call();
        }

    private:
        Call m_call;
    };
    return std::make_unique<CallReplay>(std::move(call));
}

/// Counts calls of one kind, and records some of them.
struct Calls
{
    std::int64_t count = 0;
    std::int64_t every = 0;                    ///< every how many calls one is recorded; 0: never
    std::vector<std::unique_ptr<Replay>> kept; ///< the recorded calls

    /// Counts one call, and records the Replay that `make()` returns if this call is due.
    template <class Make>
    void add(Make &&make)
    {
        if (every > 0 && count % every == 0)
            kept.push_back(make());
        ++count;
    }
};

/// Counts the calls of a method to one effect. Calls can also be repeated or recorded, to measure their time.
class CallCounter
{
public:
    /// @param movers for each point 1 if the effect computes anything for it, else 0; see affectedPoints()
    explicit CallCounter(std::vector<char> movers);

    Calls effectCalls;   ///< calls that compute the effect
    Calls jacobianCalls; ///< calls for its Jacobian
    /// How often the effect was computed for all its points. A call for one range counts as the fraction of
    /// these points in it.
    double evaluations = 0.0;
    /// How many more times each call is repeated, on scratch data.
    int repeats = 0;
    Eigen::ArrayX2d accelerationScratch;       ///< for repeated calls of forces
    Eigen::ArrayXd angularAccelerationScratch; ///< for repeated calls of torques
    State stateScratch;                        ///< for repeated calls of drivers
    Jacobian jacobianScratch{0};               ///< for repeated calls for Jacobians

    /// Sets all counts to 0. Recorded calls stay.
    void restart()
    {
        effectCalls.count = jacobianCalls.count = 0;
        evaluations = 0.0;
    }

    /// Counts one computation of the effect for `points`.
    void countPoints(PointRange points) { evaluations += shareOf(points); }

    /// Prepares the scratch data for states of the size of `model`, if calls are repeated or recorded.
    void allocateScratch(const State &model)
    {
        if ((effectCalls.every == 0 && repeats == 0) || stateScratch.pointCount() == model.pointCount())
            return;
        stateScratch = model;
        accelerationScratch.setZero(model.pointCount(), 2);
        angularAccelerationScratch.setZero(model.pointCount());
    }

private:
    double shareOf(PointRange points);

    std::vector<char> m_affected;
    std::ptrdiff_t m_affectedCount; ///< number of ones in m_affected
    /// Results of shareOf() by first point and count, because a method that computes islands asks for many
    /// ranges.
    std::map<std::pair<int, int>, double> m_shares;
};

}

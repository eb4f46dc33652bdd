#pragma once

#include "sim/scene/effect.h"
#include "sim/scene/scene.h"

#include <memory>
#include <vector>

namespace sim {

/// A scene as a system of ordinary differential equations, q'' = a(q, t) - c q'. q is one row of numbers: x of each
/// point, then y of each, then the angle of each that has a spin; velocities and accelerations go in the same
/// order. What the scene does by jumps (contacts, constraints, drivers that act once a step) is not in it.
class OdeSystem
{
public:
    OdeSystem(const Scene &scene, DirectionRule directionRule);
    /// Of one island of the scene: q holds the numbers of the points of `runs`, which are in ascending order and have
    /// among them all that any of their points is tied to. Drivers that flow or follow are the whole scene's.
    OdeSystem(const Scene &scene, DirectionRule directionRule, std::vector<PointRange> ranges);

    /// Numbers in q: 2 a point, and 1 for each that has a spin.
    int size() const { return m_size; }
    /// Points in q, and which they are.
    int points() const { return m_points; }
    const std::vector<PointRange> &ranges() const { return m_ranges; }
    /// The scene's number of the point in row `row` of q, below points().
    int pointAt(int row) const;

    /// Rows of q with the same c, in 1/frame.
    struct RateRange
    {
        int first = 0;
        int count = 0;
        double rate = 0.0;
        int end() const { return first + count; }
    };
    /// Together they are all rows, in order.
    const std::vector<RateRange> &rateRanges() const { return m_rateRanges; }

    /// The rate at which everything that goes on by itself is slowed, but for what is stopped at once: 1/frame. Empty
    /// where there are several.
    std::optional<double> uniformRate() const { return m_oneRate; }

    /// Reads places and velocities. What does not go on by itself (a handle, what a hand holds) has velocity 0 here.
    void readState(const State &state, double *q, double *v) const;
    /// Puts places back.
    void writePositions(const double *q, State &state) const;
    /// Puts velocities back, of what goes on by itself.
    void writeVelocities(const double *v, State &state) const;
    /// a(q, t), without damping, where `state` is. Uses its scratch.
    void accelerations(State &state, double *a) const;
    /// The same of one force alone, also on points that do not go on by themselves.
    void forceAccelerations(const Force &force, State &state, double *a) const;
    /// What a method has gathered in State::acceleration and State::turning, as one row like a(q, t).
    void readAccumulated(State &state, double *a) const;
    /// The derivatives of a by q. False if a force of the scene has none.
    bool jacobian(const State &state, Jacobian &jacobian) const;
    /// Whether anything goes by a clock: drivers that flow.
    bool hasContinuousDrivers() const { return !m_flowing.empty(); }
    /// Takes time on by `h` frames, without moving anything: the drivers that flow.
    void advanceDrivers(State &state, double h) const;
    /// Gives `state` the scratch that accelerations() uses.
    void prepare(State &state) const;

    /// The effects that are in the equations, in the scene's order.
    const std::vector<EffectPtr> &effects() const { return m_effects; }
    /// The first effect that is not, or nothing: a contact, a constraint, a driver that acts once a step, or a drag
    /// that has no rate. `contacts` says whether contacts count.
    enum class Contacts { allowed, excluded };
    static EffectPtr firstDiscontinuity(const Scene &scene, Contacts contacts);

private:
    bool movesByVelocity(const State &state, int point, int row) const
    {
        return state.isDynamic(point) && m_inert[static_cast<std::size_t>(row)];
    }
    void runDependentDrivers(State &state) const;
    /// Sets to 0 what is gathered.
    void clear(State &state) const;
    void take(const State &state, double *a) const;
    void listEffects(const Scene &scene);
    /// Calls `visit(point, row)` for each point of it.
    template <class Visit>
    void forEach(Visit &&visit) const
    {
        int row = 0;
        for (const PointRange &range : m_ranges) {
            for (int point = range.first; point < range.end(); ++point)
                visit(point, row++);
        }
    }
    /// Calls `visit(run, row)` for each run, with the row of its first point.
    template <class Visit>
    void forEachRun(Visit &&visit) const
    {
        int row = 0;
        for (const PointRange &range : m_ranges) {
            visit(range, row);
            row += range.count;
        }
    }

    DirectionRule m_directionRule;
    std::vector<PointRange> m_ranges;
    int m_points = 0;
    int m_spins = 0;
    int m_size = 0;
    std::vector<char> m_inert; ///< a row each
    std::vector<int> m_idle;   ///< the numbers of the other points
    std::vector<RateRange> m_rateRanges;
    std::optional<double> m_oneRate;
    std::vector<EffectPtr> m_effects;
    std::vector<std::shared_ptr<const Force>> m_forces;
    std::vector<AccelerationAdder> m_pulls; ///< of each force, on all points
    std::vector<std::shared_ptr<const Torque>> m_torques;
    std::vector<std::shared_ptr<const Driver>> m_flowing;
    std::vector<std::shared_ptr<const Driver>> m_following;
};

}

#pragma once

#include "sim/scene/effect.h"
#include "sim/scene/scene.h"

#include <memory>
#include <vector>

namespace sim {

/// Returns whether `drag` has a damping rate for each of `points`.
bool hasDampingRate(const Drag &drag, PointRange points);

/// A scene as a system of ordinary differential equations, q'' = a(q, t) - c q'. The vector q holds x of all
/// points, then y of all points, then the angles if the points have spins. Velocities and accelerations have
/// the same order. Units are px, degrees and frames. Effects that act by jumps (contacts, constraints,
/// impulsive drivers) are not included.
class OdeSystem
{
public:
    /// Makes the system of the whole scene.
    OdeSystem(const Scene &scene, DirectionRule directionRule);
    /// Makes the system of one island: the points of `ranges`, in ascending order. No coupling joins them to
    /// other points. Drivers still act on the whole scene.
    OdeSystem(const Scene &scene, DirectionRule directionRule, std::vector<PointRange> ranges);

    /// Returns the length of q: 2 per point, or 3 if the points have spins.
    int size() const { return m_size; }
    /// Returns the number of points in q.
    int points() const { return m_points; }
    const std::vector<PointRange> &ranges() const { return m_ranges; }
    /// Returns the index in the scene of the point with x in row `row` of q (0 to points() - 1).
    int pointAt(int row) const;

    /// Neighbouring rows of q with the same damping rate c.
    struct RateRange
    {
        int first = 0;
        int count = 0;
        double rate = 0.0; ///< 1/frame; infinite: damping stops the point at once
        int end() const { return first + count; }
    };
    /// Returns the ranges of all rows, in order.
    const std::vector<RateRange> &rateRanges() const { return m_rateRanges; }

    /// Returns the damping rate (1/frame) of all points that move by their velocities and that damping does
    /// not stop at once. Returns 0 if there are none, and nothing if the rates differ.
    std::optional<double> uniformRate() const { return m_uniformRate; }

    /// Reads positions and velocities. Handles, the dragged point and points with prescribed motion get
    /// velocity 0.
    void readState(const State &state, double *q, double *v) const;
    /// Writes positions to `state` and runs the dependent drivers. If the points have spins, writes only the
    /// angles: the positions follow from them.
    void writePositions(const double *q, State &state) const;
    /// Writes the velocities of the points that move by them.
    void writeVelocities(const double *v, State &state) const;
    /// Returns whether a depends on the velocities, too. Then writeVelocities() belongs to each evaluation.
    bool readsVelocities() const { return m_readsVelocities; }
    /// Returns the first force that depends on velocities, or null.
    EffectPtr firstVelocityForce() const;
    /// Computes a(q, t), without damping, at the positions of `state`. Overwrites its sums of accelerations.
    void accelerations(State &state, double *a) const;
    /// Computes the accelerations by `force` alone, also of points with prescribed motion.
    void forceAccelerations(const Force &force, State &state, double *a) const;
    /// Reads a(q, t) from the sums in State::acceleration and State::angularAcceleration. Sets them to 0 for
    /// points with prescribed motion.
    void readAccumulated(State &state, double *a) const;
    /// Adds the derivatives of a by q to `jacobian`. Returns false if a force or torque has none.
    bool jacobian(const State &state, Jacobian &jacobian) const;
    /// Returns whether a(q, t) depends on t, by continuous drivers.
    bool hasContinuousDrivers() const { return !m_continuousDrivers.empty(); }
    /// Runs the continuous drivers for `h` frames. No point moves by its velocity.
    void advanceDrivers(State &state, double h) const;
    /// Gives `state` the arrays that accelerations() uses.
    void prepare(State &state) const;

    /// Returns the effects in the equations, in the order of the scene.
    const std::vector<EffectPtr> &effects() const { return m_effects; }
    /// Whether firstDiscontinuity() accepts contacts.
    enum class Contacts { allowed, excluded };
    /// Returns the first effect that the equations cannot include, or null: a constraint, an impulsive
    /// driver, a drag without a rate, or, if `contacts` excludes them, a contact.
    static EffectPtr firstDiscontinuity(const Scene &scene, Contacts contacts);

private:
    bool movesByVelocity(const State &state, int point, int row) const
    {
        return state.isDynamic(point) && m_movesByVelocity[static_cast<std::size_t>(row)];
    }
    void runDependentDrivers(State &state) const;
    /// Sets the sums of accelerations to 0.
    void clear(State &state) const;
    void copyAccelerations(const State &state, double *a) const;
    void listEffects(const Scene &scene);
    /// Calls `visit(point, row)` for each point.
    template <class Visit>
    void forEachPoint(Visit &&visit) const
    {
        int row = 0;
        for (const PointRange &range : m_ranges) {
            for (int point = range.first; point < range.end(); ++point)
                visit(point, row++);
        }
    }
    /// Calls `visit(range, row)` for each range, with the row of its first point.
    template <class Visit>
    void forEachRange(Visit &&visit) const
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
    std::vector<char> m_movesByVelocity; ///< per point in q, as Scene::movesByVelocity()
    std::vector<int> m_prescribedPoints; ///< the points with prescribed motion
    std::vector<RateRange> m_rateRanges;
    std::optional<double> m_uniformRate;
    bool m_readsVelocities = false;
    std::vector<EffectPtr> m_effects;
    std::vector<std::shared_ptr<const Force>> m_forces;
    std::vector<AccelerationAdder> m_adders; ///< one per force, for all points
    std::vector<std::shared_ptr<const Torque>> m_torques;
    std::vector<std::shared_ptr<const Driver>> m_continuousDrivers;
    std::vector<std::shared_ptr<const Driver>> m_dependentDrivers;
};

}

#pragma once

#include "sim/scene/scene.h"

#include <vector>

namespace sim {

/// Returns the speed (px/frame) below which a point that hits a surface rests on it instead of bouncing.
/// Otherwise bounces would follow each other faster and faster without end. `acceleration` (px/frame^2)
/// presses the point against the surface. A bounce at this speed rises a tenth of `tolerance` (px). The
/// result is at least 0.001 px/frame: at an acceleration of 0.5, that is a rise of a millionth of a pixel.
double restingSpeed(double acceleration, double tolerance);

/// The surfaces that the points of an island can touch.
class ContactCandidates
{
public:
    /// `ranges`: the points of the island, as OdeSystem::ranges().
    ContactCandidates(const Scene &scene, const std::vector<PointRange> &ranges);

    /// A surface that a point can touch.
    struct Candidate
    {
        int point = 0;
        int row = 0; ///< row of the point in the OdeSystem of the island
        int bit = 0; ///< bit of the surface in State::restingContacts
        Surface surface;
    };
    const std::vector<Candidate> &all() const { return m_candidates; }
    bool any() const { return !m_candidates.empty(); }

private:
    std::vector<Candidate> m_candidates;
};

/// Returns the distance of `x` from a surface in px, negative behind it.
inline double gap(const Surface &surface, Vec2 x)
{
    return dot(surface.normal, x) - surface.offset;
}

/// Returns the component of `v` along the normal of a surface, positive away from it.
inline double normalVelocity(const Surface &surface, Vec2 v)
{
    return dot(surface.normal, v);
}

/// Returns the velocity after a point hits a surface with velocity `v`.
Vec2 bounced(const Surface &surface, Vec2 v);
/// Returns the part of an acceleration (or velocity) that a surface does not balance for a point that rests
/// on it.
Vec2 restingAcceleration(const Surface &surface, Vec2 a);

/// Returns the root of `f` between `low`, with f >= 0, and `high`, with f < 0, to 1e-15.
template <class Function>
double firstRoot(Function &&f, double low, double high)
{
    // The Illinois variant of false position. Source: Dowell and Jarratt, 1971.
    double atLow = f(low), atHigh = f(high);
    int side = 0;
    for (int i = 0; i < 80 && high - low > 1e-15; ++i) {
        double middle = low + (high - low) * atLow / (atLow - atHigh);
        if (!(middle > low && middle < high))
            middle = 0.5 * (low + high);
        const double value = f(middle);
        if (value == 0.0)
            return middle;
        if (value > 0.0) {
            low = middle;
            atLow = value;
            atHigh *= side == 1 ? 0.5 : 1.0;
            side = 1;
        } else {
            high = middle;
            atHigh = value;
            atLow *= side == -1 ? 0.5 : 1.0;
            side = -1;
        }
    }
    return high;
}

}

#pragma once

#include "sim/scene/scene.h"

#include <vector>

namespace sim {

/// Points that come slower than this (px/frame) onto a surface against which `pull` (px/frame^2) presses them stay on
/// it: so bounces that pile up come to an end. A bounce of that speed would rise a tenth of `tolerance` (px); but
/// 0.001 px/frame is always slow enough: under a pull of 0.5 that is a rise of a millionth of a pixel.
double restingSpeed(double pull, double tolerance);

/// The surfaces that the points of an island meet.
class ContactCandidates
{
public:
    /// `runs`: as those of the island's Flow.
    ContactCandidates(const Scene &scene, const std::vector<PointRange> &ranges);

    struct Candidate
    {
        int point = 0;
        int row = 0; ///< of the point among the numbers of the island's Flow
        int bit = 0; ///< of State::resting
        Surface surface;
    };
    const std::vector<Candidate> &all() const { return m_places; }
    bool any() const { return !m_places.empty(); }

private:
    std::vector<Candidate> m_places;
};

/// How far `x` is from a surface: px, negative past it.
inline double gap(const Surface &surface, Vec2 x)
{
    return dot(surface.normal, x) - surface.offset;
}

/// The part of `v` along a surface's normal: positive away from it.
inline double normalVelocity(const Surface &surface, Vec2 v)
{
    return dot(surface.normal, v);
}

/// The velocity of a point that touches a surface with velocity `v`.
Vec2 bounced(const Surface &surface, Vec2 v);
/// What is left of an acceleration (or a velocity) of a point that rests on a surface.
Vec2 restingAcceleration(const Surface &surface, Vec2 a);

/// Where `f` goes through 0 between `low`, where it is not negative, and `high`, where it is; to 1e-15.
template <class Function>
double firstRoot(Function &&f, double low, double high)
{
    // The Illinois form of false position: Dowell and Jarratt, 1971.
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

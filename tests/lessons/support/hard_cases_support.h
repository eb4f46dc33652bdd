#pragma once

#include "sim/run/track.h"
#include "sim/scene/state.h"
#include "tests/lessons/support/support.h"

#include <cmath>

/// Shared by the suites of the lesson on hard cases.
namespace hard_cases_support {

using namespace support;

inline constexpr double centre = 270.0; ///< px, x of the centre of the single spring

/// Returns the maximum of `quantity(state)` over the frames `from` to `frames` of a run. Infinite if the run
/// stops before.
template <class Quantity>
inline double maxOverFrames(const sim::Script &script, std::int64_t from, std::int64_t frames,
                            Quantity &&quantity)
{
    sim::Track track(script, 0);
    double largest = 0.0;
    for (std::int64_t frame = from; frame <= frames; frame += track.framesPerOutput()) {
        track.seek({frame, 0});
        if (track.stop())
            return std::numeric_limits<double>::infinity();
        largest = std::max(largest, quantity(track.state()));
    }
    return largest;
}

/// Returns the distance of the farthest point from (270, 200), in px.
inline double maxDistance(const sim::State &state)
{
    return (state.position.rowwise() - Eigen::Array2d(270.0, 200.0).transpose())
        .matrix()
        .rowwise()
        .norm()
        .maxCoeff();
}

/// Returns the speed of the fastest point, in px/frame.
inline double maxSpeed(const sim::State &state)
{
    return state.velocity.matrix().rowwise().norm().maxCoeff();
}

/// Returns the centroid of all points.
inline sim::Vec2 centroidOf(const sim::State &state)
{
    return {state.position.col(0).mean(), state.position.col(1).mean()};
}

inline double distanceBetween(const sim::State &state, int a, int b)
{
    return sim::length(state.positionOf(a) - state.positionOf(b));
}

/// Returns the largest error of a leg, in px. Legs are 50 px long at rest and join the last point to all
/// others.
inline double maxLegError(const sim::State &state)
{
    double largest = 0.0;
    for (int i = 0; i + 1 < state.pointCount(); ++i)
        largest = std::max(largest, std::abs(distanceBetween(state, i, state.pointCount() - 1) - 50.0));
    return largest;
}

/// The lesson on hard cases, with scripts of its steps.
struct HardCaseScripts
{
    const LoadedLesson m_lesson = loadLesson(QStringLiteral("hard_cases"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }
    bool narrationContains(const char *id, const QString &text) const
    {
        return step(id).narration.simplified().contains(text);
    }
    sim::Script scriptFor(const char *id, const char *method, double h = 1.0,
                          const Changes &changes = {}) const
    {
        return scriptOf(step(id), method, h, changes);
    }
};

}

#pragma once

#include "sim/run/track.h"
#include "sim/scene/state.h"
#include "tests/lessons/support.h"

#include <cmath>

/// What suites of the lesson of hard cases share.
namespace hard_cases_bench {

using namespace support;

inline constexpr double centre = 270.0; ///< px: where the lone spring ends, along x

/// The largest of something over the frames of a run from `from` on; infinite where the run ends before.
template <class Of>
inline double largest(const sim::Script &script, std::int64_t from, std::int64_t frames, Of &&of)
{
    sim::Track track(script, 0);
    double most = 0.0;
    for (std::int64_t frame = from; frame <= frames; frame += track.framesPerOutput()) {
        track.seek({frame, 0});
        if (track.stop())
            return std::numeric_limits<double>::infinity();
        most = std::max(most, of(track.state()));
    }
    return most;
}

inline double reach(const sim::State &state)
{
    return (state.position.rowwise() - Eigen::Array2d(270.0, 200.0).transpose())
        .matrix()
        .rowwise()
        .norm()
        .maxCoeff();
}

inline double fastest(const sim::State &state)
{
    return state.velocity.matrix().rowwise().norm().maxCoeff();
}

inline sim::Vec2 middleOf(const sim::State &state)
{
    return {state.position.col(0).mean(), state.position.col(1).mean()};
}

inline double apart(const sim::State &state, int a, int b)
{
    return sim::length(state.positionOf(a) - state.positionOf(b));
}

/// px: how far the worst leg is from 50 px; the body comes last.
inline double worstLeg(const sim::State &state)
{
    double worst = 0.0;
    for (int i = 0; i + 1 < state.pointCount(); ++i)
        worst = std::max(worst, std::abs(apart(state, i, state.pointCount() - 1) - 50.0));
    return worst;
}

/// The lesson, and runs of its steps.
struct HardCases
{
    const LoadedLesson m_lesson = loadLesson(QStringLiteral("hard_cases"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }
    bool saysOf(const char *id, const QString &words) const
    {
        return step(id).narration.simplified().contains(words);
    }
    sim::Script run(const char *id, const char *method, double h = 1.0, const Changes &changes = {}) const
    {
        return scriptOf(step(id), method, h, changes);
    }
};

}

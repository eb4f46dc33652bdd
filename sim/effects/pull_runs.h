#pragma once

#include "sim/effects/links.h"
#include "sim/wide.h"

#include <array>
#include <cstdint>
#include <cstdlib>
#include <limits>

namespace sim {

/// What the two ends of a link feel, where two points in one place need no rule.
struct BothPulls
{
    Vec2 mover;
    Vec2 anchor; ///< where the anchor has a link to the mover, too
    double length =
        std::numeric_limits<double>::infinity(); ///< px, if it matters whether they are in one place
};

/// The pulls of one run, link after link.
struct PullRow
{
    std::array<double, longestRun> x, y;
    void put(int i, Vec2 pull)
    {
        x[static_cast<std::size_t>(i)] = pull.x;
        y[static_cast<std::size_t>(i)] = pull.y;
    }
};

/// The pulls of a run and of the one that answers it.
struct PullRows
{
    PullRow movers;
    PullRow anchors;
};

/// Where points are: the two columns of State::position, by point.
struct Places
{
    const double *x;
    const double *y;
};

/// What a sum of pulls is made of besides them.
struct PullSum
{
    const double *inverseMass;
    double scale;
    double *x; ///< px/frame^2, by point
    double *y;
};

/// The pulls of a run by `both(mover, anchor)`; of the mover's end alone where the answer is not asked for. Returns
/// whether no two of its points are in one place.
template <int moverStep, int anchorStep, bool bothWays, class Both>
bool pullsOf(const LinkRun &run, const Places &at, const Both &both, PullRows &rows)
{
    const double *mx = at.x + run.mover, *my = at.y + run.mover;
    const double *ax = at.x + run.anchor, *ay = at.y + run.anchor;
    double *px = rows.movers.x.data(), *py = rows.movers.y.data();
    double *qx = rows.anchors.x.data(), *qy = rows.anchors.y.data();
    const Both compute = both; // numbers that no store can change
    std::int64_t close = 0;
    const int count = run.count;
    SIM_TURNS_ARE_APART
    for (int i = 0; i < count; ++i) {
        const Vec2 mover = {mx[moverStep * i], my[moverStep * i]};
        const Vec2 anchor = {ax[anchorStep * i], ay[anchorStep * i]};
        const BothPulls pulls = compute(mover, anchor);
        px[i] = pulls.mover.x;
        py[i] = pulls.mover.y;
        if constexpr (bothWays) {
            qx[i] = pulls.anchor.x;
            qy[i] = pulls.anchor.y;
        }
        close |= pulls.length < inOnePlace ? std::int64_t{1} : std::int64_t{0};
    }
    return close == 0;
}

template <bool bothWays, class Both>
bool pullsOf(const LinkRun &run, const Places &at, const Both &both, PullRows &rows)
{
    if (run.moverStep == 0)
        return pullsOf<0, 1, bothWays>(run, at, both, rows);
    if (run.anchorStep == 0)
        return pullsOf<1, 0, bothWays>(run, at, both, rows);
    return pullsOf<1, 1, bothWays>(run, at, both, rows);
}

/// The same with the rule for two points in one place: `pull(link)`.
template <class Pull>
#if defined(__GNUC__)
[[gnu::noinline]]
#endif
void carefulPullsOf(const Stroke &stroke, const Pull &pull, PullRows &rows)
{
    for (int i = 0; i < stroke.run.count; ++i) {
        const Link link = stroke.run.link(i);
        rows.movers.put(i, pull(link));
        if (stroke.bothWays)
            rows.anchors.put(i, pull({link.anchor, link.mover}));
    }
}

/// Adds the pulls on the points `first`, `first + step`, ... to their sums.
inline void addRow(const PullRow &row, int first, int step, int count, const PullSum &sum)
{
    const double *weight = sum.inverseMass + first, *px = row.x.data(), *py = row.y.data();
    double *x = sum.x + first, *y = sum.y + first;
    const double scale = sum.scale;
    if (step == 0) {
        const double share = *weight;
        if (share == 0.0)
            return;
        double sumX = *x, sumY = *y;
        for (int i = 0; i < count; ++i) {
            sumX += scale * (share * px[i]);
            sumY += scale * (share * py[i]);
        }
        *x = sumX;
        *y = sumY;
        return;
    }
    SIM_TURNS_ARE_APART
    for (int i = 0; i < count; ++i) {
        const double sumX = x[i] + scale * (weight[i] * px[i]);
        const double sumY = y[i] + scale * (weight[i] * py[i]);
        x[i] = weight[i] != 0.0 ? sumX : x[i];
        y[i] = weight[i] != 0.0 ? sumY : y[i];
    }
}

/// Whether no point of `run` is both a mover and an anchor of it, and none comes twice: then each point has one pull to
/// come, and it does not matter which point has its first.
inline bool hasEachPointOnce(const LinkRun &run)
{
    return run.moverStep == 1 && run.anchorStep == 1 && std::abs(run.mover - run.anchor) >= run.count;
}

/// Adds the pulls of such a run to their sums, except for points in one place. Returns whether there are any.
template <bool bothWays, class Both>
bool addAtOnce(const LinkRun &run, const Places &at, const PullSum &sum, const Both &both)
{
    const double *mx = at.x + run.mover, *my = at.y + run.mover;
    const double *ax = at.x + run.anchor, *ay = at.y + run.anchor;
    const double *mw = sum.inverseMass + run.mover, *aw = sum.inverseMass + run.anchor;
    double *px = sum.x + run.mover, *py = sum.y + run.mover;
    double *qx = sum.x + run.anchor, *qy = sum.y + run.anchor;
    const Both compute = both; // numbers that no store can change
    const double scale = sum.scale;
    std::int64_t close = 0;
    const int count = run.count;
    SIM_TURNS_ARE_APART
    for (int i = 0; i < count; ++i) {
        const BothPulls pulls = compute(Vec2{mx[i], my[i]}, Vec2{ax[i], ay[i]});
        const bool inOne = pulls.length < inOnePlace;
        close |= inOne ? std::int64_t{1} : std::int64_t{0};
        const bool pulled = !inOne & (mw[i] != 0.0);
        const double x = px[i] + scale * (mw[i] * pulls.mover.x);
        const double y = py[i] + scale * (mw[i] * pulls.mover.y);
        px[i] = pulled ? x : px[i];
        py[i] = pulled ? y : py[i];
        if constexpr (bothWays) {
            const bool answered = !inOne & (aw[i] != 0.0);
            const double backX = qx[i] + scale * (aw[i] * pulls.anchor.x);
            const double backY = qy[i] + scale * (aw[i] * pulls.anchor.y);
            qx[i] = answered ? backX : qx[i];
            qy[i] = answered ? backY : qy[i];
        }
    }
    return close != 0;
}

/// Adds the pulls that addAtOnce() has left out, by the rule for two points in one place.
template <class Pull>
#if defined(__GNUC__)
[[gnu::noinline]]
#endif
void addClose(const Stroke &stroke, const Places &at, const PullSum &sum, const Pull &pull)
{
    const auto add = [&](const Link &link) {
        const double weight = sum.inverseMass[link.mover];
        if (weight == 0.0)
            return;
        const Vec2 one = pull(link);
        sum.x[link.mover] += sum.scale * (weight * one.x);
        sum.y[link.mover] += sum.scale * (weight * one.y);
    };
    for (int i = 0; i < stroke.run.count; ++i) {
        const Link link = stroke.run.link(i);
        const Vec2 d = {at.x[link.mover] - at.x[link.anchor], at.y[link.mover] - at.y[link.anchor]};
        if (!(direction(d).length < inOnePlace))
            continue;
        add(link);
        if (stroke.bothWays)
            add({link.anchor, link.mover});
    }
}

template <class Both, class Pull>
void addStroke(const Stroke &stroke, const Places &at, const PullSum &sum, const Both &both, const Pull &pull)
{
    const LinkRun &run = stroke.run;
    if (hasEachPointOnce(run)) {
        const bool close =
            stroke.bothWays ? addAtOnce<true>(run, at, sum, both) : addAtOnce<false>(run, at, sum, both);
        if (close)
            addClose(stroke, at, sum, pull);
        return;
    }
    PullRows rows;
    const bool apart =
        stroke.bothWays ? pullsOf<true>(run, at, both, rows) : pullsOf<false>(run, at, both, rows);
    if (!apart)
        carefulPullsOf(stroke, pull, rows);
    addRow(rows.movers, run.mover, run.moverStep, run.count, sum);
    if (stroke.bothWays)
        addRow(rows.anchors, run.anchor, run.anchorStep, run.count, sum);
}

/// Adds `scale` times each pull of `points` to its row of `into`, run by run: the batch loop of every force between two
/// points. `both(mover, anchor)` computes them from places alone, several links at once; `pull(link)` those of runs in
/// which two points are in one place. The pulls of one point are added in the order of its links.
template <class Both, class Pull>
void addPullRuns(const Links &links, Take take, const State &state, Points points, double scale,
                 Eigen::ArrayX2d &into, const Both &both, const Pull &pull)
{
    const Places at = {state.position.data(), state.position.data() + state.position.rows()};
    const PullSum sum = {state.inverseMass.data(), scale, into.data(), into.data() + into.rows()};
    const auto add = [&](const Stroke &stroke) { runFast([&] { addStroke(stroke, at, sum, both, pull); }); };
    if (take == Take::part)
        links.runs().forEachPart(points, add);
    else
        links.runs().forEach(points, add);
}

/// The same for pulls that know no direction: points in one place are nothing special.
template <class Both>
void addPullRuns(const Links &links, const State &state, Points movers, double scale, Eigen::ArrayX2d &into,
                 const Both &both)
{
    addPullRuns(links, Take::movers, state, movers, scale, into, both,
                [&](const Link &link) { return both(state.at(link.mover), state.at(link.anchor)).mover; });
}

}

#pragma once

#include "sim/base/vec2.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace sim {

/// What a hand holds: that body stands at `hand` until it is let go.
struct Hold
{
    int point = -1; ///< -1: nothing is held
    Vec2 hand;      ///< px
};

/// The keys that steer, and whether each is down.
struct Keys
{
    bool left = false;
    bool right = false;
    bool up = false;
    bool down = false;
    friend bool operator==(const Keys &, const Keys &) = default;
};

/// How far a gust of wind has run from where it began; both 0 when there is none.
struct GustExtent
{
    double front = 0.0; ///< px
    double tail = 0.0;  ///< px, where it is over already
};

/// What a learner tells a scene besides dragging. Each holds until the next event of its kind.
struct InputState
{
    std::optional<Vec2> pointer; ///< px; empty before the first event
    bool pointerDown = false;
    Vec2 target; ///< px
    std::vector<Vec2>
        newTargets; ///< px, those that came with the row under way and that no driver has taken yet
    std::optional<double> gust; ///< degrees, in place of the random one; for the row under way only
    Keys keys;
};

/// The stretch of time that a method with steps of its own has computed for one island of a scene, seen from the frame
/// that is done. Whole frames inside it are read off; State::stages holds what for.
struct AdaptiveStep
{
    double start = 0.0;      ///< frames, where its last step began; 0 or less
    double end = 0.0;        ///< frames, where that ended; nothing is ahead if it is not above 0
    double length = 0.0;     ///< frames, of that step before a contact cut it short
    double nextLength = 0.0; ///< frames, the length that its next step should have; 0: not known yet
    int stuckPoint =
        -1; ///< the point pulled hardest where too many steps did not reach the next frame; -1: they did
    friend bool operator==(const AdaptiveStep &, const AdaptiveStep &) = default;
};

/// All that a step reads and writes, as plain values. Copying it is the snapshot; two equal States run on alike.
/// Arrays have one row per point: structure of arrays, x and y each in one run of memory.
struct State
{
    Eigen::ArrayX2d position;     ///< px
    Eigen::ArrayX2d velocity;     ///< px/frame
    Eigen::ArrayX2d acceleration; ///< px/frame^2, gathered so far; empty for methods that gather none
    Eigen::ArrayX2d previous;     ///< px, where points were before they moved; empty where no constraint asks
    Eigen::ArrayXd inverseMass;   ///< 1/mass; 0 for what feels nothing: a handle, or a body in the hand

    Eigen::ArrayXd angle; ///< degrees, clockwise from the x axis; empty for scenes whose points do not turn
    Eigen::ArrayXd spin;  ///< degrees/frame; empty for scenes whose points have no angular inertia
    Eigen::ArrayXd
        angularAcceleration; ///< degrees/frame^2, gathered so far; empty for methods that gather none

    Eigen::ArrayXXd stages; ///< scratch of methods with several stages, one column each; empty for others
    /// For each point the surfaces that it rests on, a bit each (the first is 1); empty for methods that do not locate
    /// contacts.
    Eigen::ArrayXi restingContacts;
    std::vector<AdaptiveStep>
        adaptiveSteps; ///< one an island; empty for other methods, and before the first step
    /// On how many points methods that choose this themselves have computed all forces, one time after the other:
    /// divided by points() it is how often all points had their turn.
    std::int64_t pointEvaluations = 0;

    Eigen::ArrayXd gait;      ///< rad, one a gait clock
    Eigen::ArrayXd gaitSpeed; ///< rad/frame, one a gait clock
    GustExtent gustExtent;
    std::int64_t frame = 0; ///< the frame that is under way or done
    InputState input;
    Hold hold;

    /// A state of `points` points of mass 1, all at rest at (0, 0).
    static State ofPoints(int points);

    int pointCount() const { return static_cast<int>(position.rows()); }
    Vec2 positionOf(int point) const { return {position(point, 0), position(point, 1)}; }
    Vec2 velocityOf(int point) const { return {velocity(point, 0), velocity(point, 1)}; }
    void place(int point, Vec2 x);
    void setVelocity(int point, Vec2 v);
    bool isDynamic(int point) const { return inverseMass[point] != 0.0; }
    /// How often all points had their turn, see `evaluations`.
    double forceEvaluations() const
    {
        return static_cast<double>(pointEvaluations) / std::max(1, pointCount());
    }
};

/// What the numbers of a column are, and so who looks at them. All columns are compared by sameBits().
enum class ColumnKind {
    motion, ///< what a learner sees: must be finite, decides whether a run rests, goes over to a changed scene
    accumulator, ///< gathered in each step: must be finite, and where it changes a block does not rest
    persistent,  ///< read by the next step: where it changes a block does not rest
    scratch,     ///< of a method while it steps: it leaves no block at rest while there is any
};

/// Calls `visit(kind, &State::values)` for each array of a State that has a row a point, or none at all. The one list of
/// them: whoever goes through the columns of a state uses it, so a new column is one line here.
template <class Visit>
constexpr void forEachColumn(Visit &&visit)
{
    visit(ColumnKind::motion, &State::position);
    visit(ColumnKind::motion, &State::velocity);
    visit(ColumnKind::accumulator, &State::acceleration);
    visit(ColumnKind::persistent, &State::previous);
    visit(ColumnKind::persistent, &State::inverseMass);
    visit(ColumnKind::motion, &State::angle);
    visit(ColumnKind::motion, &State::spin);
    visit(ColumnKind::accumulator, &State::angularAcceleration);
    visit(ColumnKind::scratch, &State::stages);
    visit(ColumnKind::persistent, &State::restingContacts);
}

/// Whether numbers of this kind have to be finite for a run to go on.
constexpr bool mustBeFinite(ColumnKind kind)
{
    return kind == ColumnKind::motion || kind == ColumnKind::accumulator;
}

/// Calls `visit(data, bytes)` for each run of memory that makes up `state`, sizes included: comparing and counting both
/// use it.
template <class Visit>
void visitBytes(const State &state, Visit &&visit)
{
    const auto one = [&](const auto &value) { visit(&value, sizeof value); };
    const auto place = [&](Vec2 at) {
        one(at.x);
        one(at.y);
    };
    const auto array = [&](const auto &values) {
        one(static_cast<std::int64_t>(values.rows()));
        visit(values.data(), static_cast<std::size_t>(values.size()) * sizeof *values.data());
    };
    forEachColumn([&](ColumnKind, auto values) { array(state.*values); });
    one(state.adaptiveSteps.size());
    for (const AdaptiveStep &lastStep :
         state.adaptiveSteps) { // each number by itself: there is room between them that means nothing
        one(lastStep.start);
        one(lastStep.end);
        one(lastStep.length);
        one(lastStep.nextLength);
        one(lastStep.stuckPoint);
    }
    one(state.pointEvaluations);
    array(state.gait);
    array(state.gaitSpeed);
    one(state.gustExtent.front);
    one(state.gustExtent.tail);
    one(state.frame);
    const InputState &outside = state.input;
    one(outside.pointer.has_value());
    place(outside.pointer.value_or(Vec2{}));
    one(outside.pointerDown);
    place(outside.target);
    one(outside.newTargets.size());
    visit(outside.newTargets.data(), outside.newTargets.size() * sizeof(Vec2));
    one(outside.gust.has_value());
    one(outside.gust.value_or(0.0));
    for (const bool key : {outside.keys.left, outside.keys.right, outside.keys.up, outside.keys.down})
        one(key);
    one(state.hold.point);
    place(state.hold.hand);
}

/// Whether two states are equal in every bit (so 0 differs from -0, and NaN equals itself).
bool sameBits(const State &a, const State &b);

/// How much memory a copy of `state` takes, in bytes.
std::size_t byteSize(const State &state);

/// AdaptiveStep::stuck of the first island that has one, or -1.
int firstStuckPoint(const State &state);

}

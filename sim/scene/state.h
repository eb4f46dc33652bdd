#pragma once

#include "sim/base/vec2.h"

#include <Eigen/Core>

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace sim {

/// The point that the learner drags. It stays at `hand` until the learner releases it.
struct Hold
{
    int point = -1; ///< -1: none
    Vec2 hand;      ///< px, position of the pointer
    /// px and px/frame, motion of the point before the input of the current output step moved it to `hand`.
    /// For methods that are programs and move a held point themselves.
    Vec2 positionBefore = {};
    Vec2 velocityBefore = {};
};

/// Whether each steering key is down.
struct Keys
{
    bool left = false;
    bool right = false;
    bool up = false;
    bool down = false;
    friend bool operator==(const Keys &, const Keys &) = default;
};

/// How far the two ends of a gust of wind have travelled from its origin. Both are 0 if there is no gust.
struct GustExtent
{
    double front = 0.0; ///< px
    double tail = 0.0;  ///< px; the gust has passed everything nearer than this
};

/// A learner's input besides dragging. Unless stated otherwise, each value holds until the next event of its
/// kind.
struct InputState
{
    std::optional<Vec2> pointer; ///< px; empty before the first event
    bool pointerDown = false;
    Vec2 target; ///< px
    /// px, targets of the current output step that no driver has processed yet
    std::vector<Vec2> newTargets;
    std::optional<double> gust; ///< degrees, replaces the random gust in the current output step
    Keys keys;
};

/// The last step of an adaptive method for one island. It may end after the current frame. Frames that lie
/// inside it are interpolated (dense output) from State::stages. Its times are relative to the current frame.
struct AdaptiveStep
{
    double start = 0.0;      ///< frames, when the step began; 0 or less
    double end = 0.0;        ///< frames, when it ended; if above 0, time ahead is already computed
    double length = 0.0;     ///< frames, length of the step before a contact cut it short
    double nextLength = 0.0; ///< frames, planned length of the next step; 0: not known yet
    /// The point with the largest acceleration if the step budget ran out before the next frame, else -1.
    int stuckPoint = -1;
    friend bool operator==(const AdaptiveStep &, const AdaptiveStep &) = default;
};

/// Everything that a step reads and writes, as plain values. A copy is a snapshot: two equal States have the
/// same future. Arrays have one row per point. x and y are separate columns, each contiguous in memory
/// (structure of arrays).
struct State
{
    Eigen::ArrayX2d position;     ///< px
    Eigen::ArrayX2d velocity;     ///< px/frame
    Eigen::ArrayX2d acceleration; ///< px/frame^2, sum so far; empty for methods that accumulate none
    Eigen::ArrayX2d previous;     ///< px, positions before the move of this step; empty without constraints
    Eigen::ArrayXd inverseMass;   ///< 1/mass; 0 if not dynamic: a handle or a dragged body

    Eigen::ArrayXd angle; ///< degrees, clockwise from the x axis; empty if the points cannot turn
    Eigen::ArrayXd spin;  ///< degrees/frame; empty if the points have no angular inertia
    /// degrees/frame^2, sum so far; empty for methods that accumulate none
    Eigen::ArrayXd angularAcceleration;

    Eigen::ArrayXXd stages; ///< scratch of methods with several stages, one column per stage; else empty
    /// Per point, a bit set of the surfaces that it rests on (the first surface is bit 1). Empty for methods
    /// that do not locate contact events.
    Eigen::ArrayXi restingContacts;
    /// One per island. Empty for methods that are not adaptive, and before the first step.
    std::vector<AdaptiveStep> adaptiveSteps;
    /// The number of points on which all forces were computed, summed over all evaluations since the start.
    /// Only methods without a fixed number of evaluations per step count it. See forceEvaluations().
    std::int64_t pointEvaluations = 0;

    Eigen::ArrayXd gait;      ///< rad, per gait clock
    Eigen::ArrayXd gaitSpeed; ///< rad/frame, per gait clock
    GustExtent gustExtent;
    /// Bytes that a method remembers from step to step besides the columns above, for example the variables of
    /// a program. Only that method knows their layout. Empty for most methods.
    std::vector<std::byte> memory;
    /// Whether the method could not compute the current step. The run ends before it.
    bool stepFailed = false;
    std::int64_t frame = 0; ///< the frame that is being computed, or the last one computed
    InputState input;
    Hold hold;

    /// Returns a state of `points` points of mass 1, all at rest at (0, 0).
    static State ofPoints(int points);

    int pointCount() const { return static_cast<int>(position.rows()); }
    Vec2 positionOf(int point) const { return {position(point, 0), position(point, 1)}; }
    Vec2 velocityOf(int point) const { return {velocity(point, 0), velocity(point, 1)}; }
    /// Sets the position of `point` to `x` (px).
    void place(int point, Vec2 x);
    void setVelocity(int point, Vec2 v);
    /// Returns whether `point` responds to forces.
    bool isDynamic(int point) const { return inverseMass[point] != 0.0; }
    /// Returns `pointEvaluations` per point: how many times the forces on the whole scene were computed.
    double forceEvaluations() const
    {
        return static_cast<double>(pointEvaluations) / std::max(1, pointCount());
    }
};

/// The purpose of a column of State, which decides what code uses it. sameBits() compares all columns.
enum class ColumnKind {
    motion,      ///< visible: must be finite, decides whether a run sleeps, is transferred to a changed scene
    accumulator, ///< a sum of one step: must be finite; a cache block sleeps only if it does not change
    persistent,  ///< read by the next step; a cache block sleeps only if it does not change
    scratch,     ///< scratch of a method; no cache block sleeps unless it is empty
};

/// Calls `visit(kind, &State::column)` for each array of State that has one row per point or is empty. This
/// is the only list of these columns: all code that iterates over them uses it.
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

/// Returns whether a run fails if a number of this kind is not finite.
constexpr bool mustBeFinite(ColumnKind kind)
{
    return kind == ColumnKind::motion || kind == ColumnKind::accumulator;
}

/// Calls `visit(data, bytes)` for each block of memory that makes up `state`, including array sizes.
template <class Visit>
void visitBytes(const State &state, Visit &&visit)
{
    const auto scalar = [&](const auto &value) { visit(&value, sizeof value); };
    const auto vector = [&](Vec2 value) {
        scalar(value.x);
        scalar(value.y);
    };
    const auto array = [&](const auto &values) {
        scalar(static_cast<std::int64_t>(values.rows()));
        visit(values.data(), static_cast<std::size_t>(values.size()) * sizeof *values.data());
    };
    forEachColumn([&](ColumnKind, auto column) { array(state.*column); });
    scalar(state.adaptiveSteps.size());
    // Field by field, because the padding of the struct has no defined value.
    for (const AdaptiveStep &lastStep : state.adaptiveSteps) {
        scalar(lastStep.start);
        scalar(lastStep.end);
        scalar(lastStep.length);
        scalar(lastStep.nextLength);
        scalar(lastStep.stuckPoint);
    }
    scalar(state.pointEvaluations);
    array(state.gait);
    array(state.gaitSpeed);
    scalar(state.gustExtent.front);
    scalar(state.gustExtent.tail);
    scalar(state.memory.size());
    visit(state.memory.data(), state.memory.size());
    scalar(state.stepFailed);
    scalar(state.frame);
    const InputState &input = state.input;
    scalar(input.pointer.has_value());
    vector(input.pointer.value_or(Vec2{}));
    scalar(input.pointerDown);
    vector(input.target);
    scalar(input.newTargets.size());
    visit(input.newTargets.data(), input.newTargets.size() * sizeof(Vec2));
    scalar(input.gust.has_value());
    scalar(input.gust.value_or(0.0));
    for (const bool key : {input.keys.left, input.keys.right, input.keys.up, input.keys.down})
        scalar(key);
    scalar(state.hold.point);
    vector(state.hold.hand);
    vector(state.hold.positionBefore);
    vector(state.hold.velocityBefore);
}

/// Returns whether two states are equal in every bit (so 0 differs from -0, and NaN equals itself).
bool sameBits(const State &a, const State &b);

/// Returns the memory that a copy of `state` takes, in bytes.
std::size_t byteSize(const State &state);

/// Returns AdaptiveStep::stuckPoint of the first island that has one, or -1.
int firstStuckPoint(const State &state);

}

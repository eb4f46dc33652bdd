#pragma once

#include "sim/vec2.h"

#include <Eigen/Core>

#include <cstddef>
#include <cstdint>

namespace sim {

/// What a hand holds: that body stands at `hand` until it is let go.
struct Hold
{
    int point = -1; ///< -1: nothing is held
    Vec2 hand;      ///< px
};

/// All that a step reads and writes, as plain values. Copying it is the snapshot; two equal States run on alike.
/// Arrays have one row per point: structure of arrays, x and y each in one run of memory.
struct State
{
    Eigen::ArrayX2d position;     ///< px
    Eigen::ArrayX2d velocity;     ///< px/frame
    Eigen::ArrayX2d acceleration; ///< px/frame^2, gathered so far; empty for methods that gather none
    Eigen::ArrayXd inverseMass;   ///< 1/mass; 0 for what feels nothing: a handle, or a body in the hand
    Hold hold;

    /// A state of `points` points of mass 1, all at rest at (0, 0).
    static State ofPoints(int points);

    int points() const { return static_cast<int>(position.rows()); }
    Vec2 at(int point) const { return {position(point, 0), position(point, 1)}; }
    Vec2 speed(int point) const { return {velocity(point, 0), velocity(point, 1)}; }
    void place(int point, Vec2 x);
    void push(int point, Vec2 v);
    bool feels(int point) const { return inverseMass[point] != 0.0; }
};

/// Calls `visit(data, bytes)` for each run of memory that makes up `state`, sizes included. The one list of what
/// belongs to a State: comparing and counting both use it.
template <class Visit>
void visitMemory(const State &state, Visit &&visit)
{
    const auto array = [&](const auto &values) {
        const std::int64_t rows = values.rows();
        visit(&rows, sizeof rows);
        visit(values.data(), static_cast<std::size_t>(values.size()) * sizeof(double));
    };
    array(state.position);
    array(state.velocity);
    array(state.acceleration);
    array(state.inverseMass);
    visit(&state.hold.point, sizeof state.hold.point);
    visit(&state.hold.hand, sizeof state.hold.hand);
}

/// Whether two states are equal in every bit (so 0 differs from -0, and NaN equals itself).
bool sameBits(const State &a, const State &b);

/// How much memory a copy of `state` takes, in bytes.
std::size_t memoryOf(const State &state);

/// The first point whose position, velocity or gathered acceleration is not a finite number, or -1.
int firstNotFinite(const State &state);

}

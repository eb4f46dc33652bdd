#include "sim/run/script/state_transfer.h"

#include "sim/scene/effect.h"

#include <numeric>
#include <unordered_map>
#include <vector>

namespace sim {

namespace {

/// Returns for each point of `to` the point of `from` with the same name, or -1.
std::vector<int> pointsWithSameName(const Scene &from, const Scene &to)
{
    if (from.names == to.names) { // nearly always; the search below takes a second for a crowd
        std::vector<int> same(to.names.size());
        std::iota(same.begin(), same.end(), 0);
        return same;
    }
    std::unordered_map<std::string, int> pointOf;
    for (std::size_t i = 0; i < from.names.size(); ++i)
        pointOf.emplace(from.names[i], static_cast<int>(i));
    std::vector<int> points;
    for (const std::string &name : to.names) {
        const auto found = pointOf.find(name);
        points.push_back(found == pointOf.end() ? -1 : found->second);
    }
    return points;
}

/// Copies a row between two arrays, if both have it.
template <class Array>
void copyRow(const Array &from, int oldRow, Array &to, int newRow)
{
    if (from.rows() > oldRow && to.rows() > newRow)
        to.row(newRow) = from.row(oldRow);
}

/// Keeps the speed of each gait clock in `state`, unless the initial speeds in `from` and `next` differ.
void copyGaitSpeeds(const State &state, const State &from, State &next)
{
    for (int i = 0; i < static_cast<int>(next.gaitSpeed.rows()); ++i) {
        if (from.gaitSpeed.rows() > i && from.gaitSpeed[i] == next.gaitSpeed[i])
            copyRow(state.gaitSpeed, i, next.gaitSpeed, i);
    }
}

/// Copies the motion of point `old` of `state` to point `point` of `next`.
void copyMotion(const State &state, int old, State &next, int point)
{
    forEachColumn([&](ColumnKind kind, auto values) {
        if (kind == ColumnKind::motion)
            copyRow(state.*values, old, next.*values, point);
    });
}

/// Adds the difference of the two initial angles to the angle of `point` in `next`, which was copied from the
/// old state. So a tree keeps its bends if its branches get another growth angle.
void addInitialTurn(const Scene &from, int old, const Scene &to, State &next, int point)
{
    if (from.start.angle.rows() <= old || to.start.angle.rows() <= point)
        return;
    const double turned = to.start.angle[point] - from.start.angle[old];
    if (turned != 0.0)
        next.angle[point] += turned;
}

/// Returns whether the points of the two scenes are others, or begin at other positions or angles.
bool beginDifferently(const Scene &from, const Scene &to)
{
    const State &a = from.start, &b = to.start;
    return from.names != to.names || a.angle.rows() != b.angle.rows() || (a.position != b.position).any() ||
           (a.angle != b.angle).any();
}

/// Sets the values of `state` that follow from the rest of it. In a tree that grows at another angle, each branch goes
/// to the end of its parent.
void runDependentDrivers(const Scene &scene, State &state)
{
    for (const EffectPtr &effect : scene.effects) {
        const Driver *driver = as<Driver>(effect);
        if (driver && driver->timing() == DriverTiming::dependent)
            driver->drive(state, 0.0);
    }
}

}

State transferState(const State &state, const Scene &from, const Scene &to)
{
    State next = to.start;
    const std::vector<int> oldPoints = pointsWithSameName(from, to);
    Vec2 shift;
    int commonPoints = 0;
    for (int i = 0; i < next.pointCount(); ++i) {
        const int old = oldPoints[static_cast<std::size_t>(i)];
        if (old < 0)
            continue;
        shift = shift + (state.positionOf(old) - to.start.positionOf(i));
        ++commonPoints;
    }
    for (int i = 0; i < next.pointCount(); ++i) {
        const int old = oldPoints[static_cast<std::size_t>(i)];
        if (old >= 0) {
            copyMotion(state, old, next, i);
            addInitialTurn(from, old, to, next, i);
            if (state.hold.point == old)
                next.hold = {i, state.hold.hand, state.hold.positionBefore, state.hold.velocityBefore};
        } else if (commonPoints > 0) {
            next.place(i, next.positionOf(i) + (1.0 / commonPoints) * shift);
        }
    }
    if (next.hold.point >= 0)
        next.inverseMass[next.hold.point] = 0.0;
    for (int i = 0; i < static_cast<int>(next.gait.rows()); ++i)
        copyRow(state.gait, i, next.gait, i);
    copyGaitSpeeds(state, from.start, next);
    next.gustExtent = state.gustExtent;
    next.memory = state.memory;
    next.frame = state.frame;
    next.pointEvaluations = state.pointEvaluations;
    const bool targetMoved = from.start.input.target != to.start.input.target;
    next.input = state.input;
    if (targetMoved)
        next.input.target = to.start.input.target;
    if (beginDifferently(from, to))
        runDependentDrivers(to, next);
    return next;
}

}

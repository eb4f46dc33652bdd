#include "sim/run/script/state_transfer.h"

#include <numeric>
#include <unordered_map>
#include <vector>

namespace sim {

namespace {

/// For each point of `to` the point of `from` that has its name, or -1.
std::vector<int> sameNames(const Scene &from, const Scene &to)
{
    if (from.names == to.names) { // as nearly always; in a crowd the other way takes a second
        std::vector<int> same(to.names.size());
        std::iota(same.begin(), same.end(), 0);
        return same;
    }
    std::unordered_map<std::string, int> numbers;
    for (std::size_t i = 0; i < from.names.size(); ++i)
        numbers.emplace(from.names[i], static_cast<int>(i));
    std::vector<int> olds;
    for (const std::string &name : to.names) {
        const auto found = numbers.find(name);
        olds.push_back(found == numbers.end() ? -1 : found->second);
    }
    return olds;
}

/// Rows of an array that may be empty on either side.
template <class Array>
void carryRow(const Array &from, int old, Array &to, int row)
{
    if (from.rows() > old && to.rows() > row)
        to.row(row) = from.row(old);
}

/// A clock goes on at the speed that it has, unless `next` wants another than the start before, `from`, did.
void carrySpeeds(const State &state, const State &from, State &next)
{
    for (int i = 0; i < static_cast<int>(next.gaitSpeed.rows()); ++i) {
        if (from.gaitSpeed.rows() > i && from.gaitSpeed[i] == next.gaitSpeed[i])
            carryRow(state.gaitSpeed, i, next.gaitSpeed, i);
    }
}

/// The motion of point `old` of `state`, for point `row` of `next`.
void carryMotion(const State &state, int old, State &next, int row)
{
    forEachColumn([&](ColumnKind kind, auto values) {
        if (kind == ColumnKind::motion)
            carryRow(state.*values, old, next.*values, row);
    });
}

/// A point that the two scenes start at different angles keeps how far it is turned from there: a tree whose
/// branches are to grow at another angle keeps its bends. `next` has the angle of `state` already.
void turnByStart(const Scene &from, int old, const Scene &to, State &next, int row)
{
    if (from.start.angle.rows() <= old || to.start.angle.rows() <= row)
        return;
    const double turned = to.start.angle[row] - from.start.angle[old];
    if (turned != 0.0)
        next.angle[row] += turned;
}

}

State transferState(const State &state, const Scene &from, const Scene &to)
{
    State next = to.start;
    const std::vector<int> olds = sameNames(from, to);
    Vec2 shift;
    int common = 0;
    for (int i = 0; i < next.pointCount(); ++i) {
        const int old = olds[static_cast<std::size_t>(i)];
        if (old < 0)
            continue;
        shift = shift + (state.positionOf(old) - to.start.positionOf(i));
        ++common;
    }
    for (int i = 0; i < next.pointCount(); ++i) {
        const int old = olds[static_cast<std::size_t>(i)];
        if (old >= 0) {
            carryMotion(state, old, next, i);
            turnByStart(from, old, to, next, i);
            if (state.hold.point == old)
                next.hold = {i, state.hold.hand};
        } else if (common > 0) {
            next.place(i, next.positionOf(i) + (1.0 / common) * shift);
        }
    }
    if (next.hold.point >= 0)
        next.inverseMass[next.hold.point] = 0.0;
    for (int i = 0; i < static_cast<int>(next.gait.rows()); ++i)
        carryRow(state.gait, i, next.gait, i);
    carrySpeeds(state, from.start, next);
    next.gustExtent = state.gustExtent;
    next.frame = state.frame;
    next.pointEvaluations = state.pointEvaluations;
    const bool targetMoved = from.start.input.target != to.start.input.target;
    next.input = state.input;
    if (targetMoved)
        next.input.target = to.start.input.target;
    return next;
}

}

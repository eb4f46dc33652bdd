#include "sim/state.h"

#include <vector>

namespace sim {

State State::ofPoints(int points)
{
    State state;
    state.position.setZero(points, 2);
    state.velocity.setZero(points, 2);
    state.inverseMass.setOnes(points);
    return state;
}

void State::place(int point, Vec2 x)
{
    position(point, 0) = x.x;
    position(point, 1) = x.y;
}

void State::push(int point, Vec2 v)
{
    velocity(point, 0) = v.x;
    velocity(point, 1) = v.y;
}

bool sameBits(const State &a, const State &b)
{
    std::vector<char> flatA, flatB;
    const auto flatten = [](std::vector<char> &into) {
        return [&into](const void *data, std::size_t bytes) {
            const char *first = static_cast<const char *>(data);
            into.insert(into.end(), first, first + bytes);
        };
    };
    visitMemory(a, flatten(flatA));
    visitMemory(b, flatten(flatB));
    return flatA == flatB;
}

std::size_t memoryOf(const State &state)
{
    std::size_t total = sizeof(State);
    visitMemory(state, [&](const void *, std::size_t bytes) { total += bytes; });
    return total;
}

int firstNotFinite(const State &state)
{
    // x - x is 0 for every finite x and NaN for the others: one pass that vectorises, then a search if needed.
    const bool finite =
        ((state.position - state.position) == 0.0).all() && ((state.velocity - state.velocity) == 0.0).all();
    if (finite)
        return -1;
    for (int i = 0; i < state.points(); ++i) {
        if (!state.position.row(i).isFinite().all() || !state.velocity.row(i).isFinite().all())
            return i;
    }
    return -1;
}

}

#include "sim/scene/state.h"

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

void State::setVelocity(int point, Vec2 v)
{
    velocity(point, 0) = v.x;
    velocity(point, 1) = v.y;
}

bool sameBits(const State &a, const State &b)
{
    std::vector<char> bytesA, bytesB;
    const auto appendTo = [](std::vector<char> &buffer) {
        return [&buffer](const void *data, std::size_t bytes) {
            const char *first = static_cast<const char *>(data);
            buffer.insert(buffer.end(), first, first + bytes);
        };
    };
    visitBytes(a, appendTo(bytesA));
    visitBytes(b, appendTo(bytesB));
    return bytesA == bytesB;
}

std::size_t byteSize(const State &state)
{
    std::size_t total = sizeof(State);
    visitBytes(state, [&](const void *, std::size_t bytes) { total += bytes; });
    return total;
}

int firstStuckPoint(const State &state)
{
    for (const AdaptiveStep &lastStep : state.adaptiveSteps) {
        if (lastStep.stuckPoint >= 0)
            return lastStep.stuckPoint;
    }
    return -1;
}

}

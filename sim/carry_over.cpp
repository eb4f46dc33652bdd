#include "sim/carry_over.h"

namespace sim {

State carryOver(const State &state, const Scene &from, const Scene &to)
{
    State next = to.start;
    Vec2 shift;
    int common = 0;
    for (int i = 0; i < next.points(); ++i) {
        const int old = from.find(to.names[static_cast<std::size_t>(i)]);
        if (old < 0)
            continue;
        shift = shift + (state.at(old) - to.start.at(i));
        ++common;
    }
    for (int i = 0; i < next.points(); ++i) {
        const int old = from.find(to.names[static_cast<std::size_t>(i)]);
        if (old >= 0) {
            next.place(i, state.at(old));
            next.push(i, state.speed(old));
            if (state.hold.point == old)
                next.hold = {i, state.hold.hand};
        } else if (common > 0) {
            next.place(i, next.at(i) + (1.0 / common) * shift);
        }
    }
    if (next.hold.point >= 0)
        next.inverseMass[next.hold.point] = 0.0;
    return next;
}

}

#pragma once

#include <array>

namespace bench {

/// A body and five feet over plain doubles, as one would write it by hand: radial springs both ways, gravity,
/// damping, walls. The same sums in the same order as sim computes for it.
struct PlainCreature
{
    static constexpr int feet = 5;
    static constexpr int points = feet + 1;
    using Row = std::array<double, points>;
    Row x{}, y{}, vx{}, vy{};
    double k = 0.2, radius = 50.0, gravity = 0.5, damp = 0.85;
    double left = 20.0, right = 520.0, floor = 380.0, bounce = 1.0;

    /// One frame in turn, by the published rule: atan2, cos, sin.
    void published();
    /// One frame at once, by semi-implicit Euler: sqrt.
    void semiImplicit();

private:
    void pullPublished(int mover, int anchor);
    void finish(int point);
};

}

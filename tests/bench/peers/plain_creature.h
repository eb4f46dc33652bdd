#pragma once

#include <array>
#include <cstddef>

namespace bench {

/// A body and five feet in hand-written code with plain doubles: radial springs on both ends, gravity,
/// damping, walls. It adds the same numbers in the same order as sim.
struct PlainCreature
{
    static constexpr std::size_t feet = 5;
    static constexpr std::size_t points = feet + 1;
    using Row = std::array<double, points>;
    Row x{}, y{}, vx{}, vy{};
    double k = 0.2, radius = 50.0, gravity = 0.5, damp = 0.85;
    double left = 20.0, right = 520.0, floor = 380.0, bounce = 1.0;

    /// Computes a frame point by point with the published method: atan2, cos, sin.
    void published();
    /// Computes a frame of all points at once by semi-implicit Euler: sqrt.
    void semiImplicit();

private:
    void pullPublished(std::size_t mover, std::size_t anchor);
    void finish(std::size_t point);
};

}

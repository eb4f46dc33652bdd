#pragma once

#include <cmath>

namespace sim {

/// A point, a distance or a velocity in the plane: x to the right, y down, in pixels (per frame).
struct Vec2
{
    double x = 0.0;
    double y = 0.0;

    friend constexpr bool operator==(const Vec2 &, const Vec2 &) = default;
    friend constexpr Vec2 operator+(Vec2 a, Vec2 b) { return {a.x + b.x, a.y + b.y}; }
    friend constexpr Vec2 operator-(Vec2 a, Vec2 b) { return {a.x - b.x, a.y - b.y}; }
    friend constexpr Vec2 operator*(double s, Vec2 a) { return {s * a.x, s * a.y}; }
    friend constexpr Vec2 operator/(Vec2 a, double s) { return {a.x / s, a.y / s}; }
};

/// Returns the scalar product: |a| |b| times the cosine of the angle between them.
constexpr double dot(Vec2 a, Vec2 b)
{
    return a.x * b.x + a.y * b.y;
}

/// Infinite where a coordinate is beyond 1e154, as its square is: such a place has left every bound. std::hypot would go
/// farther, and takes twice as long in what every spring computes.
inline double length(Vec2 a)
{
    return std::sqrt(a.x * a.x + a.y * a.y);
}

}

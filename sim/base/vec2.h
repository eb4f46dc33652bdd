#pragma once

#include <cmath>

namespace sim {

/// A position (px), a displacement (px) or a velocity (px/frame) in the plane: x to the right, y down.
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

/// Returns the scalar (dot) product: |a| |b| times the cosine of the angle between them.
constexpr double dot(Vec2 a, Vec2 b)
{
    return a.x * b.x + a.y * b.y;
}

/// Returns the length of `a`. It is infinite if a coordinate exceeds 1e154, because the square overflows;
/// such a run has already failed. std::hypot has no such limit, but takes twice as long, and every spring
/// calls this function.
inline double length(Vec2 a)
{
    return std::sqrt(a.x * a.x + a.y * a.y);
}

}

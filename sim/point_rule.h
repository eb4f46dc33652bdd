#pragma once

#include <variant>

namespace sim {

class Ground;
class Walls;

/// What a phase does to one point, as a value, where it does the same to each of its points that feels forces and looks
/// at no other one. joined() computes neighbouring ones in one go.
namespace rules {

/// a.y = a.y + by.
struct Falls
{
    double by = 0.0; ///< px/frame^2
};
/// v.y = v.y + by.
struct FallsAtOnce
{
    double by = 0.0; ///< px/frame
};
/// kick().
struct Kicks
{
    double h = 0.0; ///< frames
};
/// damp().
struct Damps
{
    double keep = 1.0; ///< share of a velocity
};
/// move().
struct Moves
{
    double h = 0.0; ///< frames
};
/// walls(). Those of the effect whose rule it is.
struct MeetsWalls
{
    const Walls *walls = nullptr;
};
/// ground().
struct MeetsGround
{
    const Ground *ground = nullptr;
};

}

/// std::monostate: there is no such rule.
using PointRule = std::variant<std::monostate, rules::Falls, rules::FallsAtOnce, rules::Kicks, rules::Damps,
                               rules::Moves, rules::MeetsWalls, rules::MeetsGround>;

/// What forces are added to.
enum class Onto { acceleration, velocity };

}

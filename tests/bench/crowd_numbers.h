#pragma once

/// What the creatures of crowd.h are like. Apart from it, as what is compiled for one kind of processor alone must see
/// no code that others compile, too.
namespace bench::crowd {

constexpr int feet = 5;
constexpr int points = feet + 1; ///< of one creature
constexpr double k = 0.2;        ///< 1/frame^2
constexpr double radius = 50.0;  ///< px, the springs' rest length
constexpr double damp = 0.85;    ///< share of a velocity that is left after a frame
constexpr double gravity = 0.5;  ///< px/frame^2
constexpr double left = 20.0, right = 520.0, floor = 380.0; ///< px, the room
constexpr double bounce = 1.0;                              ///< share of its speed that a wall leaves a point
constexpr double halfBody = 15.0, halfFoot = 5.0;           ///< px, half of their widths

/// A run starts again after so many frames: later all creatures would lie still, and nobody meets a wall.
constexpr int frames = 200;

}

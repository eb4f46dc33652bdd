#pragma once

/// The numbers of the creatures of crowd.h. They are in a header of their own, because files that are
/// compiled for one kind of processor must not contain code that other files compile, too.
namespace bench::crowd {

constexpr int feet = 5;
constexpr int points = feet + 1; ///< per creature
constexpr double k = 0.2;        ///< 1/frame^2
constexpr double radius = 50.0;  ///< px, the springs' rest length
constexpr double damp = 0.85;    ///< fraction of a velocity that remains after a frame
constexpr double gravity = 0.5;  ///< px/frame^2
constexpr double left = 20.0, right = 520.0, floor = 380.0; ///< px, the room
constexpr double bounce = 1.0;                    ///< fraction of a point's speed that remains after a bounce
constexpr double halfBody = 15.0, halfFoot = 5.0; ///< px, half of their widths

/// A run restarts after this many frames. Later all creatures would rest without touching a wall.
constexpr int frames = 200;

}

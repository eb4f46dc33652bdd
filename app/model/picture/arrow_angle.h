#pragma once

#include "app/model/session/picture.h"

#include <optional>

namespace app {

/// An arrow of the scene, and its angle with cosine and sine. y points down, so angles grow clockwise.
struct ArrowAngle
{
    sim::Vec2 from, to; ///< px

    sim::Vec2 vector() const { return to - from; } ///< px: the sides of the right triangle
    double length() const;                         ///< px
    /// Returns the angle from the x axis, rad, from -π to π; 0 for an arrow without length.
    double angle() const;
    double cosine() const; ///< of the angle: 1 for an arrow without length
    double sine() const;   ///< of the angle: 0 for an arrow without length
    friend bool operator==(const ArrowAngle &, const ArrowAngle &) = default;
};

/// Returns the arrow of the scene that the unit circle shows: see View::angle. Empty if there is none, or if it is not
/// finite.
std::optional<ArrowAngle> arrowAngleOf(const Picture &picture);
/// Returns the end of the branch that begins at `point`, px; the position of `point` if it is no branch of a tree.
sim::Vec2 branchEnd(const Picture &picture, int point);

}

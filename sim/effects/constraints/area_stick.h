#pragma once

#include "sim/base/direction.h"
#include "sim/effects/effect_description.h"

#include <algorithm>

namespace sim {

namespace descriptions {
extern const EffectDescription area_stick;
}

/// A four-sided figure: front, right, back, left are its corners in order, clockwise on the screen.
struct Quad
{
    int front = 0;
    int back = 0;
    int left = 0;
    int right = 0;
};

/// The two sides of a figure after they were put as far apart as its area needs, and what that was found from.
struct Sides
{
    Vec2 left;
    Vec2 right;
    double width = 0.0;  ///< px, before
    double wanted = 0.0; ///< px
    double error = 0.0;  ///< px
};

/// A rigid stick across the spine, whose length follows from the area: half of spine times width. `spine` leads from
/// the back to the front; a spine shorter than `shortest` px counts as that long, so that the width has an end.
/// `share`: the part of the error that the left side takes.
/// Source: the shoelace formula for a quadrilateral: half of the cross product of its diagonals.
// Shown lines are short.
// clang-format off
inline
//! [area_stick]
Sides keepArea(
    Vec2 left, Vec2 right, Direction spine,
    double area, double shortest,
    double share)
{
    Vec2 out = spine.out;
    Vec2 across = {-out.y, out.x};
    Vec2 d = right - left;
    double width = d.x*across.x + d.y*across.y;
    double length =
        std::max(spine.length, shortest);
    double wanted = 2 * area / length;
    double error = width - wanted;
    left = left + error * share * across;
    right = right
        - error * (1 - share) * across;
    return {left, right, width, wanted, error};
}
//! [area_stick]
// clang-format on

/// Keeps the area of a figure with four corners by moving its two sides.
class AreaStick : public DescribedEffect<Constraint, descriptions::area_stick>
{
public:
    /// `area` in px^2, `shortest` in px.
    AreaStick(Quad quad, double area, double shortest) : m_quad(quad), m_area(area), m_shortest(shortest) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &into) const override;
    void enforce(State &state, PointRange points, DirectionRule directionRule, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    Sides sidesOf(const State &state) const;

    Quad m_quad;
    double m_area;
    double m_shortest;
};

/// The area of `quad`, in px^2: below 0 when its sides have changed places.
double areaOf(const State &state, const Quad &quad);

}

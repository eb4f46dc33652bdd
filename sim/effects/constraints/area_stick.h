#pragma once

#include "sim/base/direction.h"
#include "sim/effects/effect_description.h"

#include <algorithm>

namespace sim {

namespace descriptions {
extern const EffectDescription area_stick;
}

/// The corners of a quadrilateral. Front, right, back, left are in clockwise order on the screen.
struct Quad
{
    int front = 0;
    int back = 0;
    int left = 0;
    int right = 0;
};

/// The left and right corners of a quadrilateral after its width was corrected, with the intermediate values.
struct Sides
{
    Vec2 left;
    Vec2 right;
    double width = 0.0;  ///< px, before the correction
    double wanted = 0.0; ///< px, width that gives the area
    double error = 0.0;  ///< px, width minus wanted width
};

/// Moves the left and right corners so that the quadrilateral has the given area (px^2), like a rigid stick
/// across the spine. The area is half of spine length times width. `spine` leads from the back to the front.
/// A spine shorter than `shortest` (px) is treated as that long, which limits the width. `share`: fraction of
/// the error that moves the left corner.
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

/// Keeps the area of a quadrilateral constant by moving its left and right corners.
class AreaStick : public DescribedEffect<Constraint, descriptions::area_stick>
{
public:
    /// `area` in px^2; `shortest`: px, minimum length of the spine in the calculation.
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

/// Returns the area of `quad` in px^2. It is negative if left and right have swapped sides.
double areaOf(const State &state, const Quad &quad);

}

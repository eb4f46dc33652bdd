#pragma once

#include "sim/effects/contacts/walls.h"
#include "sim/effects/effect_description.h"

#include <algorithm>

namespace sim {

namespace descriptions {
extern const EffectDescription room;
}

/// Returns how far (px) a point slides along a wall after friction. Without friction it would slide `slide`
/// px. It was `deep` px inside the wall: a deeper point was pressed harder, so friction can stop more.
/// Source: Macklin et al., "Unified particle physics for real-time applications", 2014, equation 24
/// (Coulomb's law for positions).
// Shown lines are short.
// clang-format off
inline
//! [friction]
double slideAfterFriction(double slide, double deep,
           double friction)
{
    double most = friction * deep;
    double held =
        std::clamp(slide, -most, most);
    return slide - held;
}
//! [friction]
// clang-format on

/// Returns the position of a point after the room's walls and friction acted on it. A point past a wall moves
/// back to the wall, and friction shortens its slide along the wall since `before`. `half`: px, half the
/// point's width. The room's bounce has no effect, because the velocity follows from the change of position.
// Shown lines are short.
// clang-format off
inline
//! [room_limits]
Vec2 keepInside(
    Vec2 x, Vec2 before, double half,
    const Room &room, double friction)
{
    double deep = x.y - (room.floor - half);
    if (deep > 0) {
        double slide = x.x - before.x;
        slide = slideAfterFriction(slide, deep, friction);
        x = {before.x + slide, x.y - deep};
    }
    deep = x.x - (room.right - half);
    double deep2 = room.left + half - x.x;
    if (deep > 0 || deep2 > 0) {
        double slide = x.y - before.y;
        slide = slideAfterFriction(slide,
            std::max(deep, deep2), friction);
        double wall = deep > 0
            ? x.x - deep : x.x + deep2;
        x = {wall, before.y + slide};
    }
    return x;
}
//! [room_limits]
// clang-format on

/// Two walls and a floor as constraints on positions, with friction. Points do not bounce off them.
class RoomLimits : public DescribedEffect<Constraint, descriptions::room>
{
public:
    /// `halfWidth`: px, half the width of each point. `friction`: Coulomb's coefficient, at least 0.
    RoomLimits(Room room, Eigen::ArrayXd halfWidth, double friction)
        : m_room(room), m_halfWidth(std::move(halfWidth)), m_friction(friction)
    {
    }

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void enforce(State &state, PointRange points, DirectionRule directionRule, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const Room &room() const { return m_room; }
    double friction() const { return m_friction; }
    /// Returns half the width of each point, in px.
    const Eigen::ArrayXd &halfWidths() const { return m_halfWidth; }

private:
    Room m_room;
    Eigen::ArrayXd m_halfWidth;
    double m_friction;
};

}

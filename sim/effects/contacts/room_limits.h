#pragma once

#include "sim/effects/contacts/walls.h"
#include "sim/effects/effect_description.h"

#include <algorithm>

namespace sim {

namespace descriptions {
extern const EffectDescription room;
}

/// A slide of `slide` px against a wall that a point was `deep` px inside: what friction leaves of it. The deeper,
/// the harder it was pressed, and the more friction can hold back.
/// Source: Macklin et al., "Unified particle physics for real-time applications", 2014, equation 24 (Coulomb's law
/// for positions).
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

/// Puts a point that is past a wall back to it, and holds back the way it slid there since `before`. `half` is half
/// of the point's width. The room's bounce plays no part: the velocity is the way that it came.
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

/// Two walls and a floor as conditions on places: x may not be past a wall. What meets one does not bounce, and rubs
/// along it.
class RoomLimits : public DescribedEffect<Constraint, descriptions::room>
{
public:
    /// `half`: half of each point's width in px, one row per point. `friction`: how much of the push of a wall can
    /// hold back a slide (Coulomb's coefficient), from 0.
    RoomLimits(Room room, Eigen::ArrayXd half, double friction)
        : m_room(room), m_half(std::move(half)), m_friction(friction)
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

private:
    Room m_room;
    Eigen::ArrayXd m_half;
    double m_friction;
};

}

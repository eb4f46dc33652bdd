#pragma once

#include "sim/effects/contacts/room.h"
#include "sim/effects/effect_description.h"

#include <cmath>

namespace sim {

namespace descriptions {
extern const EffectDescription walls;
}

/// Parameters of rooms. Several effects share them.
namespace settings {

inline constexpr ParameterSpec left = {
    .id = "left",
    .name = SIM_TEXT("Left wall"),
    .unit = SIM_TEXT("px"),
    .help = SIM_TEXT("Where the left wall stands."),
    .defaultValue = 20.0,
    .min = -1e6,
    .max = 1e6,
    .sliderMin = 0.0,
    .sliderMax = 540.0,
    .decimals = 0,
};
inline constexpr ParameterSpec right = {
    .id = "right",
    .name = SIM_TEXT("Right wall"),
    .unit = SIM_TEXT("px"),
    .help = SIM_TEXT("Where the right wall stands."),
    .defaultValue = 520.0,
    .min = -1e6,
    .max = 1e6,
    .sliderMin = 0.0,
    .sliderMax = 540.0,
    .decimals = 0,
};
inline constexpr ParameterSpec floor = {
    .id = "floor",
    .name = SIM_TEXT("Floor"),
    .unit = SIM_TEXT("px"),
    .help = SIM_TEXT("How far down the floor lies."),
    .defaultValue = 380.0,
    .min = -1e6,
    .max = 1e6,
    .sliderMin = 0.0,
    .sliderMax = 400.0,
    .decimals = 0,
};
inline constexpr ParameterSpec bounce = {
    .id = "bounce",
    .name = SIM_TEXT("Bounce"),
    .unit = SIM_TEXT("kept"),
    .help = SIM_TEXT("The share of its speed that a body keeps at a wall."),
    .defaultValue = 0.5,
};

}

/// Returns the room with the parameters `left`, `right`, `floor` and `bounce` of `values`.
Room roomOf(const Values &values);

/// The position and velocity of a point.
struct PointMotion
{
    Vec2 x; ///< px
    Vec2 v; ///< px/frame
};

/// Returns the motion of a body after it met the walls. A body past a wall moves back until its edge touches
/// the wall, and its normal velocity is reversed. `half`: px, half the body's width.
/// Published: Creatures I, steps 17 and 18, in the order right, left, floor.
// Shown lines are short.
// clang-format off
inline
//! [walls]
PointMotion walls(
    Vec2 x, Vec2 v, double half,
    const Room &room)
{
    if (x.x > room.right - half) {
        x.x = room.right - half;
        v.x *= -room.bounce;
    }
    if (x.x < room.left + half) {
        x.x = room.left + half;
        v.x *= -room.bounce;
    }
    if (x.y > room.floor - half) {
        x.y = room.floor - half;
        v.y *= -room.bounce;
    }
    return {x, v};
}
//! [walls]
// clang-format on

/// Two walls and a floor that bodies bounce off. There is no ceiling.
class Walls : public DescribedEffect<Contact, descriptions::walls>
{
public:
    /// `halfWidth`: px, half the width of each point.
    Walls(Room room, Eigen::ArrayXd halfWidth) : m_room(room), m_halfWidth(std::move(halfWidth)) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    bool isIdle() const override
    {
        return m_room.sidesAreFar() && std::isinf(m_room.floor) && m_room.floor > 0.0;
    }
    void resolve(State &state, PointRange points) const override;
    std::vector<Surface> surfaces(int point) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const Room &room() const { return m_room; }

private:
    Room m_room;
    Eigen::ArrayXd m_halfWidth;
};

}

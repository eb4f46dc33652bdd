#pragma once

#include "sim/effects/contacts/walls.h"

#include <cmath>
#include <vector>

namespace sim {

namespace descriptions {
extern const EffectDescription turn_round;
}

using std::abs;

/// A gait clock's speed (rad/frame) after a point with `half` its width at `x` (px) bumped into a wall, if it did:
/// away from that wall.
// Shown lines are short.
// clang-format off
inline
//! [turn_round]
double turnRound(
    double speed, double x, double half,
    const Room &room)
{
    if (x >= room.right - half)
        speed = -abs(speed);
    if (x <= room.left + half)
        speed = abs(speed);
    return speed;
}
//! [turn_round]
// clang-format on

/// Turns round each creature that touches a side wall with any point: its gait clocks run the other way.
class TurnRound : public DescribedEffect<Driver, descriptions::turn_round>
{
public:
    /// `half`: half of each point's width in px; `clockOf`: which clock each point goes by; one row a point.
    /// `mates`: for each clock the others of the same creature, which turn with it; empty: each creature has one.
    TurnRound(Room room, Eigen::ArrayXd half, std::vector<int> clockOf,
              std::vector<std::vector<int>> mates = {})
        : m_room(room), m_half(std::move(half)), m_clockOf(std::move(clockOf)), m_mates(std::move(mates))
    {
    }

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool isIdle() const override { return m_room.sidesAreFar(); }
    void drive(State &state, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const Room &room() const { return m_room; }

private:
    int clockOf(int point) const { return m_clockOf.at(static_cast<std::size_t>(point)); }

    Room m_room;
    Eigen::ArrayXd m_half;
    std::vector<int> m_clockOf;
    std::vector<std::vector<int>> m_mates;
};

}

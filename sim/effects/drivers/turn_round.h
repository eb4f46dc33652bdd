#pragma once

#include "sim/effects/contacts/walls.h"

#include <cmath>
#include <vector>

namespace sim {

namespace descriptions {
extern const EffectDescription turn_round;
}

using std::abs;

/// Returns the speed (rad/frame) of a gait clock. If the point at `x` touches a wall, the speed leads away
/// from that wall. Otherwise it is unchanged. `half`: px, half the point's width.
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

/// Makes each creature turn round when any of its points touches a side wall: its gait clocks run backwards.
class TurnRound : public DescribedEffect<Driver, descriptions::turn_round>
{
public:
    /// `halfWidth`: px, half the width of each point. `clockOf`: the index of each point's gait clock.
    /// `partnerClocks`: for each clock, the other clocks of the same creature; they turn with it. Empty: each
    /// creature has one clock.
    TurnRound(Room room, Eigen::ArrayXd halfWidth, std::vector<int> clockOf,
              std::vector<std::vector<int>> partnerClocks = {})
        : m_room(room), m_halfWidth(std::move(halfWidth)), m_clockOf(std::move(clockOf)),
          m_partnerClocks(std::move(partnerClocks))
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
    Eigen::ArrayXd m_halfWidth;
    std::vector<int> m_clockOf;
    std::vector<std::vector<int>> m_partnerClocks;
};

}

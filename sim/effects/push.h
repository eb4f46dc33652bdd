#pragma once

#include "sim/effects/reaction.h"

#include <vector>

namespace sim {

/// A push between two points, with what it was found from.
struct PushPull
{
    Vec2 from;            ///< px, the one as seen from the other
    double missing = 0.0; ///< px, how much closer than `distance` they are; 0 or less: they don't touch
    Vec2 pull;            ///< px/frame^2, what the one feels
};

/// A spring that only pushes: on `one`, away from `other`, while they are closer than `distance` px.
/// `direction(d)` gives the direction of a distance. k in 1/frame^2.
/// Source: the penalty method; Moore and Wilhelms, "Collision detection and response for computer animation", 1988.
// Shown lines are short.
// clang-format off
template <class HeadingOf>
//! [push]
PushPull push(
    Vec2 one, Vec2 other, double k,
    double distance, HeadingOf direction)
{
    Vec2 from = one - other;
    double missing =
        distance - length(from);
    Vec2 pull = {0, 0};
    if (missing > 0)
        pull = k * missing * direction(from);
    return {from, missing, pull};
}
//! [push]
// clang-format on

/// Pushes apart every two of some points that come too close to each other.
class Push : public Force
{
public:
    /// k in 1/frame^2, distance in px. With Reaction::none only the one with the lower number is pushed.
    Push(std::vector<int> points, double k, double distance, Reaction reaction);

    std::string id() const override { return "push"; }
    std::string title() const override { return SIM_TEXT("push"); }
    Kind kind() const override { return Kind::spring; }
    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    Sees sees() const override { return Sees::tied; }
    void ties(std::vector<Tie> &into) const override;
    bool idle() const override { return m_k == 0.0 || m_distance <= 0.0; }
    /// A pair belongs to the point with the lower number: with Reaction::equal the other is pushed, too, when that
    /// one is among `movers`.
    void add(const State &state, Points movers, double scale, Directions directions,
             Eigen::ArrayX2d &into) const override;
    void addPart(const State &state, Points part, double scale, Directions directions,
                 Eigen::ArrayX2d &into) const override;
    bool addSlopes(const State &state, Points movers, double scale, Directions directions,
                   Slopes &into) const override;
    std::optional<double> energy(const State &state) const override;
    bool balances(const State &state) const override;
    std::vector<Live> explain(const State &state, int mover, Directions directions) const override;

    const std::vector<int> &points() const { return m_points; }
    double k() const { return m_k; }
    double distance() const { return m_distance; }

private:
    template <class Visit>
    void forEach(const State &state, Points movers, Visit &&visit) const;
    void addPair(const State &state, int one, int other, double scale, Directions directions,
                 Eigen::ArrayX2d &into) const;
    PushPull pushOn(const State &state, int one, int other, Directions directions) const;

    std::vector<int> m_points; ///< in order
    double m_k;
    double m_distance;
    Reaction m_reaction;
};

}

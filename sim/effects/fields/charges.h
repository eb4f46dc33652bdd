#pragma once

#include "sim/effects/pairs/pair_force.h"

namespace sim {

namespace descriptions {
extern const EffectDescription charges;
}

/// The force between two charges: it repels like charges and attracts unlike ones. strength in px^3/frame^2, softening in
/// px: its square, added to that of the distance, keeps the force finite where charges meet.
/// Source: Coulomb's law; softened as in Aarseth, "Dynamical evolution of clusters of galaxies, I", 1963.
// Shown lines are short.
// clang-format off
inline
//! [charges]
PairPull chargePull(
    Vec2 one, Vec2 other,
    double strength,
    double q1, double q2,
    double softening)
{
    Vec2 from = one - other;
    double square = dot(from, from);
    double length = std::sqrt(square);
    double soft = softening * softening;
    // above 0: they repel
    double force = strength * q1 * q2
        / (square + soft);
    Vec2 pull = force / length * from;
    return {pull, length};
}
//! [charges]
// clang-format on

/// Charges that repel or attract each other.
struct ChargeLaw
{
    double strength = 0.0;  ///< px^3/frame^2
    double softening = 1.0; ///< px

    struct Numbers
    {
        double q1 = 0.0; ///< the mover's charge
        double q2 = 0.0; ///< the anchor's charge
        friend bool operator==(const Numbers &, const Numbers &) = default;
    };
    static constexpr bool isSymmetric = true;

    PairPull pull(Vec2 one, Vec2 other, const Numbers &own) const
    {
        return chargePull(one, other, strength, own.q1, own.q2, softening);
    }
    Vec2 pullWhenCoincident(Vec2 out, const Numbers &own) const { return forceAt(0.0, own) * out; }
    Vec2 published(Vec2 one, Vec2 other, const Numbers &own) const;
    PairJacobian jacobian(Vec2 one, Vec2 other, const Numbers &own) const;
    /// Returns the work that brought the two here from infinitely far away.
    double energy(Vec2 one, Vec2 other, const Numbers &own) const;
    std::vector<LiveValue> liveValues(Vec2 one, Vec2 other, Vec2 parting, const Numbers &own,
                                      DirectionRule directionRule) const;
    static std::vector<Region> regions(DirectionRule)
    {
        return {{"sim/effects/fields/charges.h", "charges"}};
    }
    bool isIdle(const Numbers &own) const { return forceAt(0.0, own) == 0.0; }

private:
    double forceAt(double distance, const Numbers &own) const
    {
        return strength * own.q1 * own.q2 / (distance * distance + softening * softening);
    }
};

extern template class PairForce<ChargeLaw>;

/// Points that carry a charge repel or attract every other one that does.
class Charges : public DescribedEffect<PairForce<ChargeLaw>, descriptions::charges>
{
public:
    /// `charge`: one a point; a point with charge 0 takes no part. strength in px^3/frame^2, softening in px, above 0.
    Charges(Eigen::ArrayXd charge, double strength, double softening);

    bool addToDraft(BlueprintDraft &draft) const override;

private:
    Eigen::ArrayXd m_charge;
};

}

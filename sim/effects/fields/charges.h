#pragma once

#include "sim/effects/pairs/pair_force.h"

namespace sim {

namespace descriptions {
extern const EffectDescription charges;
}

/// Returns the force of the charge q2 at `other` on the charge q1 at `one`. Like charges repel and unlike
/// charges attract each other. strength in px^3/frame^2, softening in px. The square of the softening is
/// added to the square of the distance, which keeps the force finite where charges meet.
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

    PairPull pull(Vec2 one, Vec2 other, const Numbers &numbers) const
    {
        return chargePull(one, other, strength, numbers.q1, numbers.q2, softening);
    }
    Vec2 pullWhenCoincident(Vec2 out, const Numbers &numbers) const { return forceAt(0.0, numbers) * out; }
    Vec2 published(Vec2 one, Vec2 other, const Numbers &numbers) const;
    PairJacobian jacobian(Vec2 one, Vec2 other, const Numbers &numbers) const;
    /// Returns the work that is needed to bring the two charges here from an infinite distance.
    double energy(Vec2 one, Vec2 other, const Numbers &numbers) const;
    std::vector<LiveValue> liveValues(Vec2 one, Vec2 other, Vec2 fallback, const Numbers &numbers,
                                      DirectionRule directionRule) const;
    static std::vector<Region> regions(DirectionRule)
    {
        return {{"sim/effects/fields/charges.h", "charges"}};
    }
    bool isIdle(const Numbers &numbers) const { return forceAt(0.0, numbers) == 0.0; }

private:
    /// Returns the force at `distance` px, in mass px/frame^2; positive: it repels.
    double forceAt(double distance, const Numbers &numbers) const
    {
        return strength * numbers.q1 * numbers.q2 / (distance * distance + softening * softening);
    }
};

extern template class PairForce<ChargeLaw>;

/// Repels or attracts each pair of charged points.
class Charges : public DescribedEffect<PairForce<ChargeLaw>, descriptions::charges>
{
public:
    /// `charge`: one entry per point; 0: the point has no charge. strength in px^3/frame^2; softening in px,
    /// above 0.
    Charges(Eigen::ArrayXd charge, double strength, double softening);

    bool addToDraft(BlueprintDraft &draft) const override;

private:
    Eigen::ArrayXd m_charge;
};

}

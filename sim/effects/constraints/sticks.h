#pragma once

#include "sim/effects/constraints/stick.h"
#include "sim/effects/effect_description.h"
#include "sim/scene/rest_target.h"

namespace sim {

namespace descriptions {
extern const EffectDescription sticks;
}

/// Rigid sticks, enforced one after the other. Each stick starts from the positions to which earlier sticks
/// moved its ends. Later sticks may change its length again. More iterations over the list leave a smaller
/// error.
class Sticks : public DescribedEffect<Constraint, descriptions::sticks>
{
public:
    /// `points`: number of points of the scene. `iterations`: number of iterations over the list per step.
    /// @throws Error "stick-without-end" (stick, end, points) if a stick ends at a point that does not exist
    Sticks(std::vector<Stick> sticks, int points, int iterations = 1);

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &into) const override;
    /// Enforces each stick whose end with the higher index is in `points`. If one end is not dynamic, the
    /// other end moves by the whole error.
    void enforce(State &state, PointRange points, DirectionRule directionRule, double h) const override;
    /// Returns the values of the last stick that moved `point`.
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;
    void addRestTargets(const State &state, std::vector<RestTarget> &into) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const std::vector<Stick> &list() const { return m_sticks; }
    int iterations() const { return m_iterations; }

private:
    /// Calls `visit(stick)` in every iteration for each stick that enforce() handles with `points`.
    template <class Visit>
    void forEach(PointRange points, Visit &&visit) const;

    std::vector<Stick> m_sticks;
    int m_iterations;
};

/// Returns the Sticks among `effects`, in their order.
std::vector<const Sticks *> sticksAmong(const std::vector<EffectPtr> &effects);

/// Returns by how many px `stick` is too long in `state`.
inline double stickError(const Stick &stick, const State &state)
{
    return stickError(state.positionOf(stick.a), state.positionOf(stick.b), stick.length);
}

}

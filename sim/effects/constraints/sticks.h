#pragma once

#include "sim/effects/constraints/stick.h"
#include "sim/effects/effect_description.h"
#include "sim/scene/rest_target.h"

namespace sim {

namespace descriptions {
extern const EffectDescription sticks;
}

/// Rigid sticks, enforced one after the other, each seeing what those before it have moved. One pass over the list
/// makes each stick right for a moment; the next ones may make it wrong again, and more passes leave less error.
class Sticks : public DescribedEffect<Constraint, descriptions::sticks>
{
public:
    /// `points`: how many points the scene has. `iterations`: passes over the list in a step.
    /// @throws Error "stick-without-end" (stick, end, points) when a stick ends at a point that is not there
    Sticks(std::vector<Stick> sticks, int points, int iterations = 1);

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::coupledPoints; }
    void addCouplings(std::vector<Coupling> &into) const override;
    /// A stick has its turn with that of its ends that has the higher number. An end that feels nothing leaves the
    /// whole error to the other one.
    void enforce(State &state, PointRange points, DirectionRule directionRule, double h) const override;
    /// The last stick that moved `point`.
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;
    void addRestTargets(const State &state, std::vector<RestTarget> &into) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const std::vector<Stick> &list() const { return m_sticks; }
    int iterations() const { return m_iterations; }

private:
    template <class Visit>
    void forEach(PointRange points, Visit &&visit) const;

    std::vector<Stick> m_sticks;
    int m_iterations;
};

/// Returns those of `effects` that are sticks, in their order.
std::vector<const Sticks *> sticksAmong(const std::vector<EffectPtr> &effects);

/// Returns by how many px `stick` is too long in `state`.
inline double stickError(const Stick &stick, const State &state)
{
    return stickError(state.positionOf(stick.a), state.positionOf(stick.b), stick.length);
}

}

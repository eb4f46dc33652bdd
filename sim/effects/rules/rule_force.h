#pragma once

#include "sim/effects/drivers/input_reader.h"
#include "sim/effects/effect_description.h"
#include "sim/scene/rule.h"

#include <memory>
#include <utility>
#include <vector>

namespace sim {

namespace descriptions {
extern const EffectDescription rule;
}

/// The force of a rule: `force` acts on every dynamic point, and `pull` on both ends of each link. Each end feels the
/// force for its own `me`, so nothing enforces that the two are opposite. It has no potential.
class RuleForce : public DescribedEffect<Force, descriptions::rule>, public InputReader
{
public:
    /// A pair of points that a link joins.
    using Link = std::pair<int, int>;

    RuleForce(std::shared_ptr<const Rule> rule, RuleScene scene, std::vector<Link> links);

    std::vector<Region> regions(DirectionRule) const override { return {}; }
    bool reads(InputKind kind) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override;
    void addCouplings(std::vector<Coupling> &into) const override;
    bool isIdle() const override { return !m_rule->hasForce() && m_pulls.empty(); }
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &into) const override;
    bool dependsOnVelocity() const override { return m_rule->use().velocity; }
    /// Computes the derivatives by central differences. A point moves by 1e-5 of its distance from the origin, or by 1e-5
    /// px if that is more: about the cube root of the rounding unit, which is optimal.
    bool addJacobian(const State &state, PointRange movers, double scale, DirectionRule directionRule,
                     Jacobian &jacobian) const override;
    /// Returns the force on `mover` (mass px/frame^2) and "pull", its acceleration (px/frame^2).
    std::vector<LiveValue> explain(const State &state, int mover, DirectionRule directionRule) const override;
    bool addToDraft(BlueprintDraft &draft) const override;

    const std::shared_ptr<const Rule> &rule() const { return m_rule; }
    /// Returns the same force by another rule that reads the same parameters.
    std::shared_ptr<const RuleForce> withRule(std::shared_ptr<const Rule> rule) const;

private:
    /// Replaces `calls` by the calls for the dynamic points of `movers`, in ascending order of `me`.
    void listCalls(const State &state, PointRange movers, std::vector<RuleCall> &calls) const;

    std::shared_ptr<const Rule> m_rule;
    RuleScene m_scene;
    std::vector<Link> m_links;
    std::vector<Link> m_pulls; ///< me and other of each end of the links, in ascending order of `me`
};

/// Returns the force of the rule of `blueprint`, which must have one.
std::shared_ptr<const RuleForce> ruleForceOf(const Blueprint &blueprint, const Values &values);

}

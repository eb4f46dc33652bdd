#include "sim/effects/rules/rule_force.h"

#include "sim/scene/blueprint_draft.h"
#include "sim/scene/values.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace sim {

namespace {

/// Scratch memory of one thread, so that an evaluation allocates nothing.
struct RuleScratch
{
    std::vector<RuleCall> calls;
    std::vector<Vec2> forces;
};

RuleScratch &ruleScratch()
{
    thread_local RuleScratch kept;
    return kept;
}

/// Returns how far a coordinate moves for a difference, in px.
double differenceStep(double coordinate)
{
    return 1e-5 * std::max(1.0, std::abs(coordinate));
}

/// Calls `visit(point)` for each point on which a call depends.
template <class Visit>
void forEachSource(const RuleCall &call, bool readsAll, int points, const Visit &visit)
{
    if (readsAll) {
        for (int point = 0; point < points; ++point)
            visit(point);
        return;
    }
    visit(call.me);
    if (call.other >= 0)
        visit(call.other);
}

}

RuleForce::RuleForce(std::shared_ptr<const Rule> rule, RuleScene scene, std::vector<Link> links)
    : m_rule(std::move(rule)), m_scene(std::move(scene)), m_links(std::move(links))
{
    if (!m_rule->hasPull())
        return;
    for (const auto &[a, b] : m_links) {
        m_pulls.emplace_back(a, b);
        m_pulls.emplace_back(b, a);
    }
    std::stable_sort(m_pulls.begin(), m_pulls.end(),
                     [](const Link &one, const Link &other) { return one.first < other.first; });
}

int RuleForce::count(const State &state, PointRange points) const
{
    std::vector<RuleCall> calls;
    listCalls(state, points, calls);
    return static_cast<int>(calls.size());
}

bool RuleForce::reads(InputKind kind) const
{
    const RuleUse use = m_rule->use();
    switch (kind) {
    case InputKind::pointer:
        return use.pointer;
    case InputKind::target:
        return use.target;
    case InputKind::keys:
        return use.keys;
    }
    return false;
}

Dependence RuleForce::dependence() const
{
    const RuleUse use = m_rule->use();
    if (use.frame)
        return Dependence::time;
    return use.bodies || use.input() || use.time ? Dependence::scene : Dependence::coupledPoints;
}

void RuleForce::addCouplings(std::vector<Coupling> &into) const
{
    for (const auto &[me, other] : m_pulls) {
        if (me < other)
            into.emplace_back(me, other);
    }
}

void RuleForce::listCalls(const State &state, PointRange movers, std::vector<RuleCall> &calls) const
{
    calls.clear();
    auto pull = std::lower_bound(m_pulls.begin(), m_pulls.end(), movers.first,
                                 [](const Link &link, int point) { return link.first < point; });
    for (int point = movers.first; point < movers.end(); ++point) {
        const bool isDynamic = state.isDynamic(point);
        if (isDynamic && m_rule->hasForce())
            calls.push_back({point});
        for (; pull != m_pulls.end() && pull->first == point; ++pull) {
            if (isDynamic)
                calls.push_back({point, pull->second});
        }
    }
}

void RuleForce::add(const State &state, PointRange movers, double scale, DirectionRule,
                    Eigen::ArrayX2d &into) const
{
    auto &[calls, forces] = ruleScratch();
    listCalls(state, movers, calls);
    forces.resize(calls.size());
    m_rule->evaluate(m_scene, state, calls, forces);
    for (std::size_t i = 0; i < calls.size(); ++i) {
        const int me = calls[i].me;
        into(me, 0) += scale * (state.inverseMass[me] * forces[i].x);
        into(me, 1) += scale * (state.inverseMass[me] * forces[i].y);
    }
}

bool RuleForce::addJacobian(const State &state, PointRange movers, double scale, DirectionRule,
                            Jacobian &jacobian) const
{
    std::vector<RuleCall> calls, moved;
    listCalls(state, movers, calls);
    const bool readsAll = m_rule->use().bodies;
    for (const RuleCall &call : calls) {
        forEachSource(call, readsAll, state.pointCount(), [&](int point) {
            const double dx = differenceStep(state.position(point, 0));
            const double dy = differenceStep(state.position(point, 1));
            for (const Vec2 by : {Vec2{dx, 0.0}, Vec2{-dx, 0.0}, Vec2{0.0, dy}, Vec2{0.0, -dy}})
                moved.push_back({call.me, call.other, point, by});
        });
    }
    std::vector<Vec2> forces(moved.size());
    m_rule->evaluate(m_scene, state, moved, forces);
    for (std::size_t i = 0; i + 3 < moved.size(); i += 4) {
        const int me = moved[i].me;
        const double factor = scale * state.inverseMass[me];
        const Vec2 byX = factor / (2.0 * moved[i].by.x) * (forces[i] - forces[i + 1]);
        const Vec2 byY = factor / (2.0 * moved[i + 2].by.y) * (forces[i + 2] - forces[i + 3]);
        jacobian.add(me, moved[i].moved, byX.x, byY.x, byX.y, byY.y);
    }
    return true;
}

std::vector<LiveValue> RuleForce::explain(const State &state, int mover, DirectionRule) const
{
    if (!state.isDynamic(mover))
        return {};
    std::vector<RuleCall> calls;
    listCalls(state, {mover, 1}, calls);
    std::vector<Vec2> forces(calls.size());
    m_rule->evaluate(m_scene, state, calls, forces);
    Vec2 sum;
    for (const Vec2 force : forces)
        sum = sum + force;
    return {{"force", sum}, {"pull", state.inverseMass[mover] * sum}};
}

bool RuleForce::addToDraft(BlueprintDraft &draft) const
{
    draft.blueprint.rule = {m_rule};
    for (const auto &[a, b] : m_links)
        draft.blueprint.ruleLinks.push_back({a, b});
    return true;
}

std::shared_ptr<const RuleForce> RuleForce::withRule(std::shared_ptr<const Rule> rule) const
{
    return std::make_shared<RuleForce>(std::move(rule), m_scene, m_links);
}

std::shared_ptr<const RuleForce> ruleForceOf(const Blueprint &blueprint, const Values &values)
{
    const std::shared_ptr<const Rule> &rule = blueprint.rule.program;
    RuleScene scene;
    scene.mass.resize(static_cast<Eigen::Index>(blueprint.points.size()));
    for (Eigen::Index i = 0; i < scene.mass.size(); ++i) {
        const BlueprintPoint &point = blueprint.points[static_cast<std::size_t>(i)];
        scene.mass[i] = point.fixed ? 0.0 : point.mass;
    }
    scene.radius = halfWidths(blueprint);
    for (const std::string &id : rule->parameters())
        scene.parameters.push_back(values.has(id) ? values[id] : 0.0);
    scene.clock = rule->use().time ? ruleClockOf(blueprint) : -1;
    scene.seed = values.seed;
    std::vector<RuleForce::Link> links;
    for (const BlueprintRuleLink &link : blueprint.ruleLinks)
        links.emplace_back(link.a, link.b);
    return std::make_shared<RuleForce>(rule, std::move(scene), std::move(links));
}

namespace descriptions {
constinit const EffectDescription rule = {.id = "rule",
                                          .title = SIM_TEXT("my rule"),
                                          .kind = EffectKind::rule,
                                          .purpose = SIM_TEXT("Acts on bodies by the rule that you wrote.")};
}

}

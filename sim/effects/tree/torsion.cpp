#include "sim/effects/tree/torsion.h"

namespace sim {

namespace {

const char *const header = "sim/effects/tree/torsion.h";

}

BranchMechanics branchMechanicsOf(const Tree &tree, double k)
{
    const int branches = tree.branchCount();
    std::vector<double> carried(static_cast<std::size_t>(branches), 0.0);
    BranchMechanics mechanics{Eigen::ArrayXd(branches), Eigen::ArrayXd(branches)};
    for (int i = branches - 1; i >= 0; --i) { // children have larger indices than their parents
        const auto index = static_cast<std::size_t>(i);
        const double scale = tree.scale[index];
        if (tree.parent[index] >= 0)
            carried[static_cast<std::size_t>(tree.parent[index])] += carried[index] + scale * scale * scale;
        mechanics.inertia[i] = branchInertia(scale, carried[index]);
        mechanics.stiffness[i] = branchStiffness(k, mechanics.inertia[i], scale);
    }
    return mechanics;
}

std::vector<Region> Torsion::regions(DirectionRule) const
{
    return {
        {header, "torsion"}, {header, "turned_by"}, {header, "branch_inertia"}, {header, "branch_stiffness"}};
}

int Torsion::count(const State &, PointRange points) const
{
    return points.count;
}

double Torsion::bend(const State &state, int branch) const
{
    return state.angle[branch] - m_tree->restOf(branch);
}

double Torsion::torqueOn(const State &state, int branch) const
{
    const int parent = m_tree->parent[static_cast<std::size_t>(branch)];
    const double parentBend = parent < 0 ? 0.0 : bend(state, parent); // the ground does not bend
    return torsion(bend(state, branch), parentBend, m_mechanics.stiffness[branch]);
}

double Torsion::reactionOn(const State &state, int branch) const
{
    double sum = 0.0;
    const int first = m_tree->firstChild[static_cast<std::size_t>(branch)];
    for (int child = first; child < first + m_tree->children[static_cast<std::size_t>(branch)]; ++child)
        sum += torqueOn(state, child);
    return sum;
}

void Torsion::add(const State &state, PointRange movers, double scale, Eigen::ArrayXd &into) const
{
    for (int i = movers.first; i < movers.end(); ++i) {
        if (state.isDynamic(i))
            into[i] += scale * turnedBy(torqueOn(state, i), reactionOn(state, i), m_mechanics.inertia[i]);
    }
}

bool Torsion::addJacobian(const State &state, PointRange movers, double scale, Jacobian &jacobian) const
{
    for (int i = movers.first; i < movers.end(); ++i) {
        if (!state.isDynamic(i))
            continue;
        const auto index = static_cast<std::size_t>(i);
        const double factor = scale / m_mechanics.inertia[i];
        double stiffness = m_mechanics.stiffness[i];
        if (m_tree->parent[index] >= 0)
            jacobian.addAngular(i, m_tree->parent[index], factor * stiffness);
        const int first = m_tree->firstChild[index];
        for (int child = first; child < first + m_tree->children[index]; ++child) {
            jacobian.addAngular(i, child, factor * m_mechanics.stiffness[child]);
            stiffness += m_mechanics.stiffness[child];
        }
        jacobian.addAngular(i, i, -factor * stiffness);
    }
    return true;
}

std::vector<LiveValue> Torsion::explain(const State &state, int mover) const
{
    if (!state.isDynamic(mover))
        return {};
    const double torque = torqueOn(state, mover), reaction = reactionOn(state, mover);
    return {{"bend", bend(state, mover), {}},
            {"stiffness", m_mechanics.stiffness[mover], {}},
            {"inertia", m_mechanics.inertia[mover], {}},
            {"torque", torque, {}},
            {"reaction", reaction, {}},
            {"pull", turnedBy(torque, reaction, m_mechanics.inertia[mover]), {}}};
}

double Torsion::kineticEnergy(const State &state) const
{
    return 0.5 * (m_mechanics.inertia * state.spin.square()).sum();
}

double Torsion::springEnergy(const State &state) const
{
    double sum = 0.0;
    for (int i = 0; i < m_tree->branchCount(); ++i) {
        const double torque = torqueOn(state, i);
        if (torque != 0.0) // the stiffness may be 0
            sum += 0.5 * torque * torque / m_mechanics.stiffness[i];
    }
    return sum;
}

double Torsion::stiffnessBound() const
{
    double bound = 0.0;
    for (int i = 0; i < m_tree->branchCount(); ++i) {
        const auto index = static_cast<std::size_t>(i);
        const bool onGround = m_tree->parent[index] < 0;
        double rowSum = (onGround ? 1.0 : 2.0) * m_mechanics.stiffness[i];
        for (int child = m_tree->firstChild[index];
             child < m_tree->firstChild[index] + m_tree->children[index]; ++child)
            rowSum += 2.0 * m_mechanics.stiffness[child];
        bound = std::max(bound, rowSum / m_mechanics.inertia[i]);
    }
    return bound;
}

namespace descriptions {
constinit const EffectDescription torsion = {
    "torsion", SIM_TEXT("springs"), EffectKind::spring,
    SIM_TEXT(
        "Bend each joint back: the farther a branch has turned from its direction at rest, the harder.")};
}

}

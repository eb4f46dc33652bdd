#include "sim/effects/tree/torsion.h"

namespace sim {

namespace {

const char *const here = "sim/effects/tree/torsion.h";

}

BranchMechanics branchMechanicsOf(const Tree &tree, double k)
{
    const int branches = tree.branchCount();
    std::vector<double> carried(static_cast<std::size_t>(branches), 0.0);
    BranchMechanics limbs{Eigen::ArrayXd(branches), Eigen::ArrayXd(branches)};
    for (int i = branches - 1; i >= 0; --i) { // children come after their parents
        const auto row = static_cast<std::size_t>(i);
        const double scale = tree.scale[row];
        if (tree.parent[row] >= 0)
            carried[static_cast<std::size_t>(tree.parent[row])] += carried[row] + scale * scale * scale;
        limbs.inertia[i] = branchInertia(scale, carried[row]);
        limbs.stiffness[i] = branchStiffness(k, limbs.inertia[i], scale);
    }
    return limbs;
}

std::vector<Region> Torsion::regions(DirectionRule) const
{
    return {{here, "torsion"}, {here, "turned_by"}, {here, "branch_inertia"}, {here, "branch_stiffness"}};
}

int Torsion::count(const State &, PointRange points) const
{
    return points.count;
}

double Torsion::bend(const State &state, int branch) const
{
    return state.angle[branch] - m_tree->rest[static_cast<std::size_t>(branch)];
}

double Torsion::torqueOn(const State &state, int branch) const
{
    const int parent = m_tree->parent[static_cast<std::size_t>(branch)];
    const double parentBend = parent < 0 ? 0.0 : bend(state, parent); // the ground does not bend
    return torsion(bend(state, branch), parentBend, m_limbs.stiffness[branch]);
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
            into[i] += scale * turnedBy(torqueOn(state, i), reactionOn(state, i), m_limbs.inertia[i]);
    }
}

bool Torsion::addJacobian(const State &state, PointRange movers, double scale, Jacobian &jacobian) const
{
    for (int i = movers.first; i < movers.end(); ++i) {
        if (!state.isDynamic(i))
            continue;
        const auto row = static_cast<std::size_t>(i);
        const double share = scale / m_limbs.inertia[i];
        double stiffness = m_limbs.stiffness[i];
        if (m_tree->parent[row] >= 0)
            jacobian.addAngular(i, m_tree->parent[row], share * stiffness);
        const int first = m_tree->firstChild[row];
        for (int child = first; child < first + m_tree->children[row]; ++child) {
            jacobian.addAngular(i, child, share * m_limbs.stiffness[child]);
            stiffness += m_limbs.stiffness[child];
        }
        jacobian.addAngular(i, i, -share * stiffness);
    }
    return true;
}

std::vector<LiveValue> Torsion::explain(const State &state, int mover) const
{
    if (!state.isDynamic(mover))
        return {};
    const double torque = torqueOn(state, mover), reaction = reactionOn(state, mover);
    return {{"bend", bend(state, mover), {}},
            {"stiffness", m_limbs.stiffness[mover], {}},
            {"inertia", m_limbs.inertia[mover], {}},
            {"torque", torque, {}},
            {"reaction", reaction, {}},
            {"pull", turnedBy(torque, reaction, m_limbs.inertia[mover]), {}}};
}

double Torsion::kineticEnergy(const State &state) const
{
    return 0.5 * (m_limbs.inertia * state.spin.square()).sum();
}

double Torsion::springEnergy(const State &state) const
{
    double sum = 0.0;
    for (int i = 0; i < m_tree->branchCount(); ++i) {
        const double torque = torqueOn(state, i);
        if (torque != 0.0) // a joint without stiffness has no energy
            sum += 0.5 * torque * torque / m_limbs.stiffness[i];
    }
    return sum;
}

double Torsion::stiffnessBound() const
{
    double most = 0.0;
    for (int i = 0; i < m_tree->branchCount(); ++i) {
        const auto row = static_cast<std::size_t>(i);
        const bool onGround = m_tree->parent[row] < 0;
        double circle = (onGround ? 1.0 : 2.0) * m_limbs.stiffness[i];
        for (int child = m_tree->firstChild[row]; child < m_tree->firstChild[row] + m_tree->children[row];
             ++child)
            circle += 2.0 * m_limbs.stiffness[child];
        most = std::max(most, circle / m_limbs.inertia[i]);
    }
    return most;
}

namespace descriptions {
constinit const EffectDescription torsion = {
    "torsion", SIM_TEXT("springs"), EffectKind::spring,
    SIM_TEXT("Bend each joint back: the harder, the farther a branch has turned from where it grew.")};
}

}

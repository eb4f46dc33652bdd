#pragma once

#include "sim/effects/effect_description.h"
#include "sim/effects/tree/tree.h"

namespace sim {

namespace described {
extern const Description joints;
}

/// Moves each branch of a tree to the end of its parent. Published: swaying tree, positionChildren().
class Joints : public Described<Driver, described::joints>
{
public:
    /// `degrees`: how many of them are a radian.
    Joints(TreePtr tree, double degrees) : m_tree(std::move(tree)), m_degrees(degrees) {}

    std::vector<Region> regions(Directions directions) const override;
    int count(const State &state, Points points) const override;
    Sees sees() const override { return Sees::tied; }
    void ties(std::vector<Tie> &into) const override { m_tree->ties(into); }
    /// A branch that feels nothing does not turn on either: it loses its spin.
    void drive(State &state, double h) const override;
    Pace pace() const override { return Pace::follows; }
    std::vector<Live> explain(const State &before, const State &after, int point) const override;

    const Tree &tree() const { return *m_tree; }

private:
    TreePtr m_tree;
    double m_degrees;
};

}

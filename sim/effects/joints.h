#pragma once

#include "sim/effect.h"
#include "sim/effects/tree.h"

namespace sim {

/// Moves each branch of a tree to the end of its parent. Published: swaying tree, positionChildren().
class Joints : public Driver
{
public:
    /// `degrees`: how many of them are a radian.
    Joints(TreePtr tree, double degrees) : m_tree(std::move(tree)), m_degrees(degrees) {}

    std::string id() const override { return "joints"; }
    std::string title() const override { return SIM_TEXT("joints"); }
    Kind kind() const override { return Kind::stick; }
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

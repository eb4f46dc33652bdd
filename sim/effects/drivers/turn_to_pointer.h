#pragma once

#include "sim/effects/drivers/input_reader.h"
#include "sim/effects/effect_description.h"
#include "sim/effects/tree/tree.h"

namespace sim {

namespace descriptions {
extern const EffectDescription turn_to_pointer;
}

namespace tree_formulas {

/// Returns the angle (degrees) at which a branch points at the pointer. The direction is measured from the
/// origin of the branch. The text of the tutorial measures it from the end: then the branch would overshoot
/// and turn back in every frame when the pointer is nearer than two of its lengths.
// Shown lines are short.
// clang-format off
inline
//! [turn_to_pointer]
double turnToPointer(Vec2 out)
{
    // out: from origin to pointer
    double rad = atan2(out.y, out.x);
    double angle = rad * degreesPerRadian;
    return angle;
}
//! [turn_to_pointer]
// clang-format on

/// Returns the same angle by the published formula. Published: swaying tree, the first bend().
// Shown lines are short.
// clang-format off
inline
//! [turn_to_pointer_published]
double turnToPointerPublished(Vec2 d)
{
    double rad = atan2(d.y, d.x);
    double angle = rad * 57.3;
    return angle;
}
//! [turn_to_pointer_published]
// clang-format on

}

using tree_formulas::turnToPointer;
using tree_formulas::turnToPointerPublished;

/// Turns every branch to the pointer, without delay, while the button is down. Branches turn in order from
/// the trunk to the twigs.
class TurnToPointer : public DescribedEffect<Driver, descriptions::turn_to_pointer>, public InputReader
{
public:
    TurnToPointer(TreePtr tree, TreeFormula formula) : m_tree(std::move(tree)), m_formula(formula) {}

    std::vector<Region> regions(DirectionRule directionRule) const override;
    int count(const State &state, PointRange points) const override;
    Dependence dependence() const override { return Dependence::scene; }
    bool reads(InputKind kind) const override { return kind == InputKind::pointer; }
    void drive(State &state, double h) const override;
    std::vector<LiveValue> explain(const State &before, const State &after, int point) const override;

private:
    TreePtr m_tree;
    TreeFormula m_formula;
};

}

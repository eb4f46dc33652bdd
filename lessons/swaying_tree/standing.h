#pragma once

#include "sim/effects/tree/tree.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <memory>

/// What the scenes of this lesson share.
namespace swaying_tree {

/// The formulas that the learner has chosen.
sim::TreeFormula formulaOf(const sim::Values &values);

inline sim::TreePtr shared(sim::Tree tree)
{
    return std::make_shared<const sim::Tree>(std::move(tree));
}

/// A tree as it grew: branch0, branch1... are points at their origins; the trunk's is (275, 400). The branches have
/// no velocity: they go where effects put them.
sim::Scene standing(const sim::Tree &tree, sim::TreeFormula formula);

/// The same with branches that turn by themselves: each has a spin, 0 at the start.
sim::Scene swinging(const sim::Tree &tree);

}

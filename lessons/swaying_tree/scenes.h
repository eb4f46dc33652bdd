#pragma once

#include "sim/effects/tree/tree.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <memory>
#include <utility>

/// One scene per step (see lessons/README.md). Point n is branch n, breadth first, left child first.
/// @throws Error of checkGrowth() for a tree that would not end or is too large
namespace swaying_tree {

/// Returns the formula that the learner has chosen.
sim::TreeFormula formulaOf(const sim::Values &values);

inline sim::TreePtr shared(sim::Tree tree)
{
    return std::make_shared<const sim::Tree>(std::move(tree));
}

/// Returns a scene of a tree at rest. Points branch0, branch1... are at the origins of the branches; the
/// trunk begins at (275, 400). The motion of the branches is prescribed.
sim::Scene standing(const sim::Tree &tree, sim::TreeFormula formula);

/// Returns a scene of a tree at rest whose branches have spins, 0 at the start.
sim::Scene swinging(const sim::Tree &tree);

namespace trunk {
sim::Tree grow(const sim::Values &values);
sim::Scene setUp(const sim::Values &values);
}
namespace branches {
sim::Tree grow(const sim::Values &values);
sim::Scene setUp(const sim::Values &values);
}
namespace randomness {
sim::Tree grow(const sim::Values &values);
sim::Scene setUp(const sim::Values &values);
}
namespace towards_pointer {
sim::Scene setUp(const sim::Values &values);
}
namespace wind {
sim::Scene setUp(const sim::Values &values);
}
namespace rest {
sim::Scene setUp(const sim::Values &values);
}
namespace distance {
sim::Scene setUp(const sim::Values &values);
}
namespace thickness {
sim::Scene setUp(const sim::Values &values);
}
namespace turbulence {
sim::Scene setUp(const sim::Values &values);
}
namespace real_sway {
sim::Scene setUp(const sim::Values &values);
}

}

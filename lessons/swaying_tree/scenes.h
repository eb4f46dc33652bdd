#pragma once

#include "sim/effects/tree/tree.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <memory>
#include <utility>

/// One scene a step, each set up by the same function name, so that the code of two steps differs only in what is
/// new. Point n is branch n, breadth first, the left child first. Trees are refused as checkGrowth() says.
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

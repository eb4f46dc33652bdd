#include "sim/effects/tree/return_to_rest.h"

#include "sim/simd/point_kernels.h"

namespace sim {

std::vector<Region> ReturnToRest::regions(DirectionRule) const
{
    return {{"sim/effects/tree/return_to_rest.h", "return_to_rest"}};
}

int ReturnToRest::count(const State &, PointRange points) const
{
    return points.count;
}

void ReturnToRest::drive(State &state, double h) const
{
    const double *rest = m_tree->rest.data();
    double *angle = state.angle.data();
    updateDynamic(state.inverseMass, {0, m_tree->branchCount()}, angle,
                  [=, ease = m_ease](int i) { return returnToRest(angle[i], rest[i], ease, h); });
}

std::vector<LiveValue> ReturnToRest::explain(const State &before, const State &after, int point) const
{
    if (!before.isDynamic(point))
        return {};
    const double rest = m_tree->restOf(point);
    return {{"rest", rest, {}},
            {"way", rest - before.angle[point], {}},
            {"angle", after.angle[point], before.angle[point]}};
}

namespace descriptions {
constinit const EffectDescription return_to_rest = {
    "return_to_rest", SIM_TEXT("return to rest"), EffectKind::spring,
    SIM_TEXT("Turns each branch part of the way back to its direction at rest.")};
}

}

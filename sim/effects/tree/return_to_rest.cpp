#include "sim/effects/tree/return_to_rest.h"

#include "sim/simd/point_kernels.h"

namespace sim {

std::vector<Region> ReturnToRest::regions(Directions) const
{
    return {{"sim/effects/tree/return_to_rest.h", "return_to_rest"}};
}

int ReturnToRest::count(const State &, Points points) const
{
    return points.count;
}

void ReturnToRest::drive(State &state, double h) const
{
    const double *rest = m_tree->rest.data();
    double *angle = state.angle.data();
    replaceFree(state.inverseMass, {0, m_tree->branches()}, angle,
                [=, ease = m_ease](int i) { return returnToRest(angle[i], rest[i], ease, h); });
}

std::vector<Live> ReturnToRest::explain(const State &before, const State &after, int point) const
{
    if (!before.feels(point))
        return {};
    const double rest = m_tree->rest[static_cast<std::size_t>(point)];
    return {{"rest", rest, {}},
            {"way", rest - before.angle[point], {}},
            {"angle", after.angle[point], before.angle[point]}};
}

namespace described {
constinit const Description return_to_rest = {
    "return_to_rest", SIM_TEXT("return to rest"), Kind::spring,
    SIM_TEXT("Turns each branch a part of the way back to where it grew.")};
}

}

#include "sim/effects/return_to_rest.h"

namespace sim {

std::vector<Region> ReturnToRest::regions(Directions) const
{
    return {{"sim/effects/return_to_rest.h", "return_to_rest"}};
}

int ReturnToRest::count(const State &, Points points) const
{
    return points.count;
}

void ReturnToRest::drive(State &state, double h) const
{
    for (int i = 0; i < m_tree->branches(); ++i) {
        if (state.feels(i))
            state.angle[i] =
                returnToRest(state.angle[i], m_tree->rest[static_cast<std::size_t>(i)], m_ease, h);
    }
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

}

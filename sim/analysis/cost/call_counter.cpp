#include "sim/analysis/cost/call_counter.h"

#include <algorithm>

namespace sim {

CallCounter::CallCounter(std::vector<char> movers)
    : m_movers(std::move(movers)), m_all(std::count(m_movers.begin(), m_movers.end(), 1))
{
}

double CallCounter::shareOf(PointRange points)
{
    const auto [known, isNew] = m_shares.try_emplace({points.first, points.count}, 1.0);
    if (isNew && m_all > 0) { // what works on no point of its own is computed as a whole
        const auto first = m_movers.begin() + points.first;
        known->second =
            static_cast<double>(std::count(first, first + points.count, 1)) / static_cast<double>(m_all);
    }
    return known->second;
}

}

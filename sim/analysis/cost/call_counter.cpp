#include "sim/analysis/cost/call_counter.h"

#include <algorithm>

namespace sim {

CallCounter::CallCounter(std::vector<char> movers)
    : m_affected(std::move(movers)), m_affectedCount(std::count(m_affected.begin(), m_affected.end(), 1))
{
}

double CallCounter::shareOf(PointRange points)
{
    const auto [entry, isNew] = m_shares.try_emplace({points.first, points.count}, 1.0);
    if (isNew && m_affectedCount > 0) { // an effect that affects no point is computed as a whole
        const auto first = m_affected.begin() + points.first;
        entry->second = static_cast<double>(std::count(first, first + points.count, 1)) /
                        static_cast<double>(m_affectedCount);
    }
    return entry->second;
}

}

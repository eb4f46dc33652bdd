#include "sim/cost/tally.h"

#include <algorithm>

namespace sim {

double Tally::shareOf(Points points)
{
    for (const Share &known : m_shares) {
        if (known.points.first == points.first && known.points.count == points.count)
            return known.share;
    }
    const auto first = m_movers.begin() + points.first;
    const auto all = std::count(m_movers.begin(), m_movers.end(), 1);
    const auto among = std::count(first, first + points.count, 1);
    // what works on no point of its own is computed as a whole
    const double share = all == 0 ? 1.0 : static_cast<double>(among) / static_cast<double>(all);
    m_shares.push_back({points, share});
    return share;
}

}

#include "sim/analysis/accuracy/samples.h"

#include <algorithm>

namespace sim {

double quantile(const std::vector<double> &sorted, double share)
{
    const double position = share * static_cast<double>(sorted.size() - 1);
    const auto below = static_cast<std::size_t>(position);
    const std::size_t above = std::min(below + 1, sorted.size() - 1);
    return sorted[below] + (position - static_cast<double>(below)) * (sorted[above] - sorted[below]);
}

void Samples::add(double value)
{
    m_sorted.insert(std::upper_bound(m_sorted.begin(), m_sorted.end(), value), value);
}

double Samples::median() const
{
    return m_sorted.empty() ? 0.0 : quantile(m_sorted, 0.5);
}

double Samples::spread() const
{
    return m_sorted.empty() ? 0.0 : 0.5 * (quantile(m_sorted, 0.75) - quantile(m_sorted, 0.25));
}

}

#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

namespace app {

/// A logarithmic axis of a drawing: decades, along a stretch of px.
class LogAxis
{
public:
    /// Covers `values` (those above 0) in whole decades, from `from` px (the smallest) to `to` px.
    LogAxis(const std::vector<double> &values, double from, double to);

    /// Where `value` is, in px; what is below the axis is at its start.
    double at(double value) const
    {
        const double decade = value > 0.0 ? std::max(std::log10(value), double(m_first)) : m_first;
        return m_from + (m_to - m_from) * (decade - m_first) / (m_last - m_first);
    }
    int first() const { return m_first; }
    int last() const { return m_last; }
    /// Decades between two labels, so that there are not too many.
    int stride() const { return 1 + (m_last - m_first - 1) / 8; }

private:
    int m_first = 0;
    int m_last = 1;
    double m_from;
    double m_to;
};

/// Moves `places` apart so that no two are nearer than `gap`, keeps their order, and stays within `from` to `to` if
/// there is room. They must be sorted.
void spreadOut(std::vector<double> &places, double gap, double from, double to);

}

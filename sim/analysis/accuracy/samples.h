#pragma once

#include <vector>

namespace sim {

/// Returns the `share` quantile (0 to 1) of `sorted`, interpolated linearly. `sorted` must not be empty.
double quantile(const std::vector<double> &sorted, double share);

/// Repeated measurements of one quantity.
class Samples
{
public:
    void add(double value);
    int count() const { return static_cast<int>(m_sorted.size()); }
    /// Returns the median, or 0 without samples.
    double median() const;
    /// Returns half the distance between the quartiles, or 0 without samples.
    double spread() const;

private:
    std::vector<double> m_sorted;
};

}

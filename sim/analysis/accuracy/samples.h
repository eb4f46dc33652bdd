#pragma once

#include <vector>

namespace sim {

/// The value that `share` of `sorted` are below, between two of them by proportion.
double quantile(const std::vector<double> &sorted, double share);

/// What the rounds of a measurement found of one thing.
class Samples
{
public:
    void add(double value);
    int count() const { return static_cast<int>(m_sorted.size()); }
    /// 0 without any.
    double median() const;
    /// Half the distance between the quartiles.
    double spread() const;

private:
    std::vector<double> m_sorted;
};

}

#pragma once

#include "app/model/series/measure_series.h"

#include <cstdint>
#include <vector>

namespace app {

/// A stance phase: the time from the touch-down of a foot to its lift-off.
struct Stance
{
    std::int64_t from = 0; ///< the first frame in which it stands
    std::int64_t to = 0;   ///< the last one
    double slip = 0.0; ///< sideways movement in the meantime, px: the sum of all distances, back and forth
    friend bool operator==(const Stance &, const Stance &) = default;
};

/// The stance phases of each foot, from the samples of a time series. When the series grows, only the new samples are
/// read.
class Stances
{
public:
    /// Reads the samples that have changed since the last call. Call it after each MeasureSeries::changed().
    void follow(const MeasureSeries &series, std::size_t feet);

    std::size_t feet() const { return m_feet.size(); }
    /// Returns the stance phases of a foot, in order.
    const std::vector<Stance> &of(std::size_t foot) const { return m_feet[foot]; }

private:
    bool goesOn(const MeasureSeries &series, std::size_t feet) const;
    void add(const Sample &sample, std::int64_t frame);
    void forgetBefore(std::int64_t frame);

    std::vector<std::vector<Stance>> m_feet;
    std::vector<char> m_stood; ///< by foot, in the output step that was read last
    std::int64_t m_first = 0;  ///< the frame of the first sample
    std::int64_t m_next = 0;   ///< the frame to read next
    std::int64_t m_framesPerOutput = 1;
};

}

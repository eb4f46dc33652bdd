#pragma once

#include <cstdint>

namespace app {

/// The frames that plots against time show: from `first` to `last`, both included.
struct PlotWindow
{
    /// The fewest rows that are shown, and by what numbers times 2, 4, 8... there are more.
    static constexpr std::int64_t leastRows = 30;

    std::int64_t first = 0;
    std::int64_t last = 0;
    friend bool operator==(const PlotWindow &, const PlotWindow &) = default;
};

/// What a window is asked to show.
struct PlotView
{
    std::int64_t at = 0;       ///< the cursor's frame
    std::int64_t computed = 0; ///< the last frame of the run
    int framesPerOutput = 1;
    std::int64_t mostRows = 480; ///< leastRows times a power of two
};

/// The next window after `was`. It stands still as long as the cursor is in it, so that axes are quiet and a curve is
/// drawn anew only where it grows: a young run fills windows that double, a longer one slides by parts of a window.
PlotWindow windowAfter(const PlotWindow &was, const PlotView &view);

/// The fewest rows to the bucket with which a window has no more than `mostBuckets` of them: a power of two.
std::int64_t strideOf(const PlotWindow &window, int framesPerOutput, std::int64_t mostBuckets);

/// The numbers that an axis covers.
struct PlotRange
{
    double low = 0.0;
    double high = 1.0;
    friend bool operator==(const PlotRange &, const PlotRange &) = default;
};

/// The next range after `was` for numbers from `low` to `high`: with a margin and round ends, and the old one as long as
/// they fit it and fill a good part of it. What does not change but for rounding is a line in the middle.
PlotRange rangeAfter(const PlotRange &was, double low, double high);

}

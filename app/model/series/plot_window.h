#pragma once

#include <cstdint>

namespace app {

/// The frames on the time axis of plots: from `first` to `last`, both included.
struct PlotWindow
{
    /// The smallest number of output steps on display. Larger windows have 2, 4, 8... times as many.
    static constexpr std::int64_t leastSteps = 30;

    std::int64_t first = 0;
    std::int64_t last = 0;
    friend bool operator==(const PlotWindow &, const PlotWindow &) = default;
};

/// The range that a window has to show.
struct PlotView
{
    std::int64_t at = 0;       ///< the cursor's frame
    std::int64_t computed = 0; ///< the last computed frame of the run
    int framesPerOutput = 1;
    std::int64_t mostSteps = 480; ///< leastSteps times a power of two
};

/// Returns the next window after `was`. The window stays fixed while the cursor is inside it, so the axes do not jitter
/// and curves are redrawn only where they grow. A young run fills windows that double; in a longer run the window
/// slides by a fraction of its width.
PlotWindow windowAfter(const PlotWindow &was, const PlotView &view);

/// Returns the smallest number of output steps per bucket that needs at most `mostBuckets` buckets: a power of two.
std::int64_t strideOf(const PlotWindow &window, int framesPerOutput, std::int64_t mostBuckets);

/// The range of numbers on an axis.
struct PlotRange
{
    double low = 0.0;
    double high = 1.0;
    friend bool operator==(const PlotRange &, const PlotRange &) = default;
};

/// Returns the next range after `was` for numbers from `low` to `high`, with a margin and round ends. The old range is
/// kept while the numbers fit it and fill a good part of it. Numbers that differ only by rounding become a line in the
/// middle.
PlotRange rangeAfter(const PlotRange &was, double low, double high);

}

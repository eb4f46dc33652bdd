#include "app/model/series/plot_window.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr std::int64_t parts = 8;    ///< fraction of a window by which it slides, as a divisor
constexpr double margin = 0.06;      ///< fraction of the numbers' span, above and below
constexpr double fillsEnough = 0.45; ///< of a range
constexpr double rounding =
    1e-10; ///< fraction of the largest number: a smaller difference counts as no change
constexpr double nothing = 1e-12;      ///< absolute limit of such a difference
constexpr double ticksInARange = 10.0; ///< the round ends are multiples of about a tenth of the range

/// Returns 1, 2 or 5 times a power of ten, at least `step`.
double roundStep(double step)
{
    const double power = std::pow(10.0, std::floor(std::log10(step)));
    for (const double times : {1.0, 2.0, 5.0}) {
        if (times * power >= step * (1.0 - 1e-9))
            return times * power;
    }
    return 10.0 * power;
}

}

PlotWindow windowAfter(const PlotWindow &was, const PlotView &view)
{
    const std::int64_t framesPerOutput = view.framesPerOutput;
    const std::int64_t reach = std::max(view.at, view.computed) / framesPerOutput;
    std::int64_t steps = PlotWindow::leastSteps;
    while (steps < reach && steps < view.mostSteps)
        steps *= 2;
    if (reach <= steps)
        return {0, steps * framesPerOutput};
    const bool isAsWide = was.last - was.first == steps * framesPerOutput && was.first % framesPerOutput == 0;
    if (isAsWide && view.at >= was.first && view.at <= was.last)
        return was;
    const std::int64_t part = std::max<std::int64_t>(1, steps / parts);
    const std::int64_t at = view.at / framesPerOutput;
    const auto down = [part](std::int64_t frame) { return std::max<std::int64_t>(0, frame / part * part); };
    const auto endingAfter = [&](std::int64_t frame) { return down(frame - steps + 2 * part - 1); };
    std::int64_t start = 0;
    if (!isAsWide) // after zooming, the cursor is in the middle, or near the end of the run
        start = std::min(down(at - steps / 2), endingAfter(reach));
    else if (view.at > was.last)
        start = endingAfter(at);
    else
        start = down(at - part);
    return {start * framesPerOutput, (start + steps) * framesPerOutput};
}

std::int64_t strideOf(const PlotWindow &window, int framesPerOutput, std::int64_t mostBuckets)
{
    const std::int64_t steps = (window.last - window.first) / framesPerOutput + 1;
    std::int64_t stride = 1;
    while ((steps + stride - 1) / stride > mostBuckets)
        stride *= 2;
    return stride;
}

PlotRange rangeAfter(const PlotRange &was, double low, double high)
{
    const double size = std::max(std::abs(low), std::abs(high));
    if (high - low <= std::max(nothing, rounding * size)) {
        const double half = size > nothing ? roundStep(0.05 * size) : 1.0;
        const double middle = std::round(0.5 * (low + high) / half) * half;
        low = middle - half;
        high = middle + half;
    }
    const double span = high - low;
    const double wide = was.high - was.low;
    const bool fits = low >= was.low && high <= was.high;
    if (fits && span >= fillsEnough * wide)
        return was;
    const double step = roundStep(span / ticksInARange);
    return {std::floor((low - margin * span) / step) * step, std::ceil((high + margin * span) / step) * step};
}

}

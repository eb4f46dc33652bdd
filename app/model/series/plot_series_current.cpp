// Reads the numbers of single moments for plots: at the cursor, and inside its frame.

#include "app/model/series/plot_series.h"
#include "sim/run/script/composed_interval.h"

#include <limits>

namespace app {

namespace {

/// Limit for computing the output step before the cursor again: points times output steps.
constexpr std::int64_t mostComputedAgain = 200'000;

}

std::optional<std::vector<double>> PlotSeries::sampledAt(std::int64_t frame) const
{
    const Samples &samples = run();
    if (samples.stride() > 1 || samples.isEmpty() || frame < samples.firstFrame() ||
        frame >= samples.nextFrame())
        return std::nullopt;
    std::vector<double> values(m_quantities.size());
    const std::size_t bucket = samples.bucketNear(frame);
    for (std::size_t column = 0; column < values.size(); ++column)
        values[column] = samples.at(bucket, column).first;
    return values;
}

/// Reads the quantities of `state`. Quantities that compare two moments compare it with frame `start`.
std::vector<double> PlotSeries::read(const sim::Track &track,
                                     std::shared_ptr<const sim::ComposedInterval> interval,
                                     const sim::State &state, std::int64_t start) const
{
    std::vector<double> values(m_quantities.size(), std::numeric_limits<double>::quiet_NaN());
    const QuantityReader reader(allBound(), std::move(interval));
    std::optional<sim::State> before;
    if (start >= 0 && (start - track.cachedFrameBefore(start)) / m_framesPerOutput * state.pointCount() <=
                          mostComputedAgain)
        before = track.stateAt(start);
    reader.read({state, before ? &*before : nullptr, static_cast<double>(m_framesPerOutput)}, values);
    return values;
}

std::vector<double> PlotSeries::readAt(const sim::Timeline &run) const
{
    const sim::Track &track = run.track();
    const sim::Cursor at = track.cursor();
    std::shared_ptr<const sim::ComposedInterval> interval = track.intervalPtr();
    const sim::State state = run.hasPendingInput() ? track.preview(interval) : track.state();
    return read(track, std::move(interval), state, at.phase > 0 ? at.frame : at.frame - m_framesPerOutput);
}

std::vector<double> PlotSeries::now() const
{
    const sim::Timeline &timeline = m_run.timeline();
    if (timeline.cursor().phase == 0 && !timeline.hasPendingInput()) {
        if (std::optional<std::vector<double>> values = sampledAt(timeline.cursor().frame))
            return *std::move(values);
    }
    return readAt(timeline);
}

std::vector<double> PlotSeries::begun() const
{
    const sim::Timeline &timeline = m_run.timeline();
    const sim::Track &track = timeline.track();
    const std::int64_t frame = timeline.cursor().frame;
    if (timeline.cursor().phase == 0)
        return now();
    if (std::optional<std::vector<double>> values = sampledAt(frame))
        return *std::move(values);
    const sim::State state = track.stateAt(frame);
    return read(track, track.intervalAt(frame), state, frame - m_framesPerOutput);
}

std::optional<PlotSeries::Inside> PlotSeries::inside(const sim::Timeline &shown) const
{
    const sim::Timeline &run = shown.cursor().phase > 0 ? shown : m_run.timeline();
    const sim::Cursor at = run.cursor();
    if (at.phase == 0)
        return std::nullopt;
    const double share = double(at.phase) / run.track().interval().pipeline.phasesPerOutput();
    return Inside{static_cast<double>(at.frame) + share * m_framesPerOutput, readAt(run)};
}

}

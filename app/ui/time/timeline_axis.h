#pragma once

#include <cstdint>
#include <vector>

namespace app {

/// The axis of a timeline: its range of frames, and their places on the screen. It grows in steps of 120, 300, 600,
/// 1200, 3000... frames, so that it rarely changes and its six parts are round numbers.
class TimelineAxis
{
public:
    /// The margin at both ends, px.
    static constexpr double margin = 16.0;

    /// Resets the axis to 120 frames.
    void reset();
    /// Grows until `frame` is on the axis. Returns whether the axis has changed.
    bool cover(std::int64_t frame);
    void setWidth(double width) { m_width = width; }

    std::int64_t frames() const { return m_frames; }
    double left() const { return margin; }
    double right() const { return m_width - margin; }
    double xOf(std::int64_t frame) const;
    /// Returns the nearest frame on the axis.
    std::int64_t frameAt(double x) const;
    /// Returns the frames that have a label: the ends, and those between for which labels `labelWidth` px wide fit.
    std::vector<std::int64_t> ticks(double labelWidth) const;

private:
    static constexpr std::int64_t shortest = 120;

    std::int64_t m_frames = shortest;
    int m_growth = 0; ///< number of times it has grown
    double m_width = 0.0;
};

}

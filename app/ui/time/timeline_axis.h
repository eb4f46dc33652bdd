#pragma once

#include <cstdint>
#include <vector>

namespace app {

/// Which frames a timeline shows, and where they are on the screen. It grows in steps of 120, 300, 600, 1200,
/// 3000... frames, so that it stands still most of the time and its six parts are round numbers.
class TimelineAxis
{
public:
    /// Free at both ends, in px.
    static constexpr double margin = 16.0;

    /// Starts again with 120 frames.
    void reset();
    /// Grows until `frame` is on the axis. Returns whether it had to.
    bool cover(std::int64_t frame);
    void setWidth(double width) { m_width = width; }

    std::int64_t frames() const { return m_frames; }
    double left() const { return margin; }
    double right() const { return m_width - margin; }
    double xOf(std::int64_t frame) const;
    /// The nearest frame; what is off the ends gives the ends.
    std::int64_t frameAt(double x) const;
    /// The frames that have a label: the ends, and those between them for which labels `labelWidth` px wide have
    /// room.
    std::vector<std::int64_t> ticks(double labelWidth) const;

private:
    static constexpr std::int64_t shortest = 120;

    std::int64_t m_frames = shortest;
    int m_growth = 0; ///< how often it grew
    double m_width = 0.0;
};

}

#include "app/ui/time/timeline_axis.h"

#include <algorithm>
#include <cmath>

namespace app {

void TimelineAxis::reset()
{
    m_frames = shortest;
    m_growth = 0;
}

bool TimelineAxis::cover(std::int64_t frame)
{
    const bool grows = frame > m_frames;
    while (frame > m_frames) {
        m_frames = m_growth % 3 == 0 ? m_frames / 2 * 5 : m_frames * 2;
        ++m_growth;
    }
    return grows;
}

double TimelineAxis::xOf(std::int64_t frame) const
{
    const double share = static_cast<double>(frame) / static_cast<double>(m_frames);
    return left() + (right() - left()) * std::clamp(share, 0.0, 1.0);
}

std::int64_t TimelineAxis::frameAt(double x) const
{
    const double length = right() - left();
    if (length <= 0.0)
        return 0;
    const double share = std::clamp((x - left()) / length, 0.0, 1.0);
    return std::llround(share * static_cast<double>(m_frames));
}

std::vector<std::int64_t> TimelineAxis::ticks(double labelWidth) const
{
    constexpr double gap = 12.0;
    std::int64_t parts = 1;
    for (const std::int64_t more : {2, 3, 6}) {
        if ((right() - left()) / static_cast<double>(more) >= 1.5 * labelWidth + gap)
            parts = more;
    }
    std::vector<std::int64_t> frames;
    for (std::int64_t i = 0; i <= parts; ++i)
        frames.push_back(m_frames / parts * i);
    return frames;
}

}

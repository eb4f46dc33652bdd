#include "app/ui/scene/layers/trail.h"

#include "app/ui/scene/layers/scene_content.h"

#include <algorithm>

namespace app {

namespace {

/// Fast playback skips frames between two repaints. Up to this gap, a straight line between them is accurate
/// enough.
constexpr std::int64_t widestGap = 4;

bool same(const Eigen::ArrayX2d &a, const Eigen::ArrayX2d &b)
{
    return a.rows() == b.rows() && (a == b).all();
}

}

void Trail::follow(const sim::Timeline &timeline)
{
    const sim::Cursor at = timeline.cursor();
    while (!m_marks.empty() && m_marks.back().frame > at.frame)
        m_marks.pop_back();
    if (timeline.state().pointCount() > crowdPoints) {
        m_marks.clear();
        return;
    }
    if (at.phase > 0)
        return;
    const Eigen::ArrayX2d &position = timeline.state().position;
    const std::int64_t gap = std::max<std::int64_t>(widestGap, timeline.track().framesPerOutput());
    if (!m_marks.empty()) {
        const Mark &last = m_marks.back();
        const bool follows = last.frame < at.frame && at.frame - last.frame <= gap;
        const bool stays = last.frame == at.frame && same(last.position, position);
        if (last.position.rows() != position.rows() || !(follows || stays))
            m_marks.clear(); // the run has jumped or changed
        else if (stays)
            return;
    }
    m_marks.push_back({at.frame, position});
    while (at.frame - m_marks.front().frame > length)
        m_marks.pop_front();
}

}

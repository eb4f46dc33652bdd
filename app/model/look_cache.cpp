#include "app/model/look_cache.h"

#include "app/model/links_shown.h"
#include "sim/run/script/composed_interval.h"

namespace app {

namespace {

constexpr std::size_t most = 4;

}

std::shared_ptr<const lessons::Look> LookCache::of(const lessons::Step &step, const sim::Script &script,
                                                   const std::shared_ptr<const sim::Segment> &segment)
{
    for (const Made &made : m_made) {
        if (made.segment.lock() == segment)
            return made.look;
    }
    lessons::Look look = step.look(segment->scene, segment->values);
    if (!script.effectsOff.empty())
        dropLinks(look, script.build(segment->values).effects, segment->scene.effects);
    m_made.push_back({segment, std::make_shared<const lessons::Look>(std::move(look))});
    if (m_made.size() > most)
        m_made.pop_front();
    return m_made.back().look;
}

}

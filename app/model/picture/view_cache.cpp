#include "app/model/picture/view_cache.h"

#include "app/model/picture/link_visibility.h"
#include "sim/run/script/composed_interval.h"

namespace app {

namespace {

constexpr std::size_t mostViews = 4;

}

std::shared_ptr<const lessons::View>
ViewCache::of(const lessons::Step &step, const sim::Script &script,
              const std::shared_ptr<const sim::ComposedInterval> &interval)
{
    for (const Made &made : m_made) {
        if (made.interval.lock() == interval)
            return made.view;
    }
    lessons::View view = step.view(interval->scene, interval->values);
    if (!script.effectsOff.empty())
        dropLinks(view, script.build(interval->values).effects, interval->scene.effects);
    m_made.push_back({interval, std::make_shared<const lessons::View>(std::move(view))});
    if (m_made.size() > mostViews)
        m_made.pop_front();
    return m_made.back().view;
}

}

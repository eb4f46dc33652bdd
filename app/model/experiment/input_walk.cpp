#include "app/model/experiment/input_walk.h"

#include "sim/scene/scene.h"

#include <algorithm>
#include <map>
#include <utility>

namespace app {

namespace {

/// The name of the body that the user holds.
class DragCheck
{
public:
    EventEffect apply(const sim::Event &event, const sim::Scene &scene)
    {
        if (const auto *grab = std::get_if<sim::Grab>(&event.what)) {
            const bool held = !m_held.empty();
            const bool isThere = scene.find(grab->body) >= 0;
            m_held = isThere ? grab->body : std::string();
            if (isThere)
                return EventEffect::works;
            return held ? EventEffect::onlyLetsGo : EventEffect::noSuchBody;
        }
        const bool releases = std::holds_alternative<sim::Release>(event.what);
        if (!releases && !std::holds_alternative<sim::Move>(event.what))
            return EventEffect::works;
        const bool holds = !m_held.empty();
        if (releases)
            m_held.clear();
        return holds ? EventEffect::works : EventEffect::nothingHeld;
    }

    /// Releases the held body if the new scene does not have it.
    void enter(const sim::Scene &scene)
    {
        if (!m_held.empty() && scene.find(m_held) < 0)
            m_held.clear();
    }

private:
    std::string m_held;
};

/// The scenes of a run. The last two are cached, because many inputs alternate between two values.
class Scenes
{
public:
    explicit Scenes(const sim::Script &script) : m_script(script) {}

    /// @throws SceneRefused: the scene cannot be built
    const sim::Scene &of(const sim::Values &values, int event)
    {
        const auto found = std::find_if(m_last.begin(), m_last.end(),
                                        [&](const auto &one) { return one.first == values.all(); });
        if (found != m_last.end()) {
            std::rotate(m_last.begin(), found, std::next(found));
        } else {
            m_last.insert(m_last.begin(), {values.all(), build(values, event)});
            m_last.resize(std::min<std::size_t>(m_last.size(), 2));
        }
        return m_last.front().second;
    }

private:
    sim::Scene build(const sim::Values &values, int event) const
    {
        try {
            return m_script.build(values);
        } catch (const sim::Error &error) {
            throw SceneRefused(error, event);
        }
    }

    const sim::Script &m_script;
    std::vector<std::pair<std::map<std::string, double>, sim::Scene>> m_last; ///< up to two, latest first
};

}

void walkInput(const sim::Script &script, const std::vector<sim::Event> &input,
               const std::function<void(const sim::Scene &, int)> &newScene,
               const std::function<void(int, EventEffect)> &each)
{
    sim::Values values = script.values;
    Scenes scenes(script);
    const sim::Scene *scene = &scenes.of(values, -1);
    newScene(*scene, -1);
    DragCheck drag;
    const int count = static_cast<int>(input.size());
    for (int first = 0, end = 0; first < count; first = end) {
        const auto at = [&input](int index) -> const sim::Event & { return input[std::size_t(index)]; };
        const auto rowOf = [&](int index) {
            return sim::outputStepEnd(at(index).frame, script.step.framesPerOutput);
        };
        int changed = -1;
        for (end = first; end < count && rowOf(end) == rowOf(first); ++end) {
            const auto *set = std::get_if<sim::Set>(&at(end).what);
            if (!set)
                continue;
            values.set(set->parameter, set->value);
            changed = end;
        }
        if (changed >= 0) {
            scene = &scenes.of(values, changed);
            newScene(*scene, changed);
            drag.enter(*scene);
        }
        for (int index = first; index < end; ++index)
            each(index, drag.apply(at(index), *scene));
    }
}

}

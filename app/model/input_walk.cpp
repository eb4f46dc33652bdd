#include "app/model/input_walk.h"

#include <algorithm>

namespace app {

namespace {

/// The row whose computation an event of `frame` precedes. Frame 0 is the start: its events belong to the first.
std::int64_t rowOf(std::int64_t frame, int rowFrames)
{
    return std::max<std::int64_t>(1, (frame + rowFrames - 1) / rowFrames);
}

/// What a hand holds, by name.
class Hand
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

    /// A body that the new scene does not have is lost.
    void enter(const sim::Scene &scene)
    {
        if (!m_held.empty() && scene.find(m_held) < 0)
            m_held.clear();
    }

private:
    std::string m_held;
};

sim::Scene build(const sim::Script &script, const sim::Values &values, int event)
{
    try {
        return script.build(values);
    } catch (const sim::Error &error) {
        throw SceneRefused(error, event);
    }
}

}

void walkInput(const sim::Script &script, const std::vector<sim::Event> &input,
               const std::function<void(const sim::Scene &, int)> &newScene,
               const std::function<void(int, EventEffect)> &each)
{
    sim::Values values = script.values;
    sim::Scene scene = build(script, values, -1);
    newScene(scene, -1);
    Hand hand;
    const int count = static_cast<int>(input.size());
    for (int first = 0, end = 0; first < count; first = end) {
        const auto at = [&input](int index) -> const sim::Event & { return input[std::size_t(index)]; };
        const std::int64_t row = rowOf(at(first).frame, script.step.rowFrames);
        int changed = -1;
        for (end = first; end < count && rowOf(at(end).frame, script.step.rowFrames) == row; ++end) {
            const auto *set = std::get_if<sim::Set>(&at(end).what);
            if (!set)
                continue;
            values.set(set->parameter, set->value);
            changed = end;
        }
        if (changed >= 0) {
            scene = build(script, values, changed);
            newScene(scene, changed);
            hand.enter(scene);
        }
        for (int index = first; index < end; ++index)
            each(index, hand.apply(at(index), scene));
    }
}

}

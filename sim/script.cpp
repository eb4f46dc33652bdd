#include "sim/script.h"

#include <algorithm>

namespace sim {

Scene sceneOf(const Script &script, const Values &values)
{
    Scene scene = script.build(values);
    for (const auto &[name, start] : script.bodies) {
        const int point = scene.find(name);
        if (point < 0)
            continue;
        scene.start.place(point, start.x);
        if (start.v && scene.start.feels(point) && scene.hasInertia(point))
            scene.start.push(point, *start.v);
    }
    std::erase_if(scene.effects, [&](const EffectPtr &effect) {
        return std::find(script.effectsOff.begin(), script.effectsOff.end(), effect->id()) !=
               script.effectsOff.end();
    });
    script.method->prepare(scene.start);
    return scene;
}

Event eventOf(std::int64_t frame, const Input &what)
{
    return {frame, std::visit([](const auto &one) -> decltype(Event::what) { return one; }, what)};
}

void sortByFrame(std::vector<Event> &input)
{
    std::stable_sort(input.begin(), input.end(),
                     [](const Event &a, const Event &b) { return a.frame < b.frame; });
}

}

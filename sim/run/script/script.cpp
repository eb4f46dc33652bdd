#include "sim/run/script/script.h"

#include "sim/base/error.h"
#include "sim/pipeline/method.h"
#include "sim/scene/scene.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace sim {

namespace {

bool isFinite(Vec2 v)
{
    return std::isfinite(v.x) && std::isfinite(v.y);
}

/// Returns the name of an event in files if one of its numbers is not finite, else an empty string.
struct NonFiniteName
{
    std::string operator()(const Move &move) const { return isFinite(move.to) ? "" : "move"; }
    std::string operator()(const Pointer &pointer) const { return isFinite(pointer.at) ? "" : "pointer"; }
    std::string operator()(const Target &target) const { return isFinite(target.at) ? "" : "target"; }
    std::string operator()(const Gust &gust) const { return std::isfinite(gust.degrees) ? "" : "gust"; }
    std::string operator()(const Set &set) const { return std::isfinite(set.value) ? "" : "set"; }
    template <class Other>
    std::string operator()(const Other &) const
    {
        return {};
    }
};

}

std::int64_t outputStepEnd(std::int64_t frame, int framesPerOutput)
{
    return std::max<std::int64_t>(1, (frame + framesPerOutput - 1) / framesPerOutput) * framesPerOutput;
}

Scene sceneOf(const Script &script, const Values &values)
{
    Scene scene = script.build(values);
    for (const auto &[name, start] : script.bodies) {
        if (!isFinite(start.x) || (start.v && !isFinite(*start.v)))
            throw Error("start-not-finite", {{"body", name}});
        const int point = scene.find(name);
        if (point < 0)
            continue;
        scene.start.place(point, start.x);
        if (start.v && scene.start.isDynamic(point) && scene.movesByVelocity(point))
            scene.start.setVelocity(point, *start.v);
    }
    std::erase_if(scene.effects, [&](const EffectPtr &effect) {
        return std::find(script.effectsOff.begin(), script.effectsOff.end(), effect->id()) !=
               script.effectsOff.end();
    });
    scene.values = std::make_shared<const Values>(values);
    script.method->prepareState(scene.start);
    return scene;
}

Event eventOf(std::int64_t frame, const Input &what)
{
    return {frame, std::visit([](const auto &input) -> decltype(Event::what) { return input; }, what)};
}

void checkFinite(const Event &event)
{
    const std::string name = std::visit(NonFiniteName{}, event.what);
    if (!name.empty())
        throw Error("input-not-finite", {{"event", name}, {"frame", std::to_string(event.frame)}});
}

void sortByFrame(std::vector<Event> &input)
{
    std::stable_sort(input.begin(), input.end(),
                     [](const Event &a, const Event &b) { return a.frame < b.frame; });
}

std::int64_t firstDifference(const std::vector<Event> &a, const std::vector<Event> &b)
{
    const auto [inA, inB] = std::mismatch(a.begin(), a.end(), b.begin(), b.end());
    std::int64_t frame = std::numeric_limits<std::int64_t>::max();
    if (inA != a.end())
        frame = std::min(frame, inA->frame);
    if (inB != b.end())
        frame = std::min(frame, inB->frame);
    return frame;
}

}

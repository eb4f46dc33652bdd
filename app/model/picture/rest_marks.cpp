#include "app/model/picture/rest_marks.h"

#include <algorithm>
#include <map>

namespace app {

namespace {

constexpr double shortest = 1e-6; ///< px; shorter lengths count as zero

using Pair = std::pair<int, int>;

Pair pairOf(const sim::RestTarget &rest)
{
    return std::minmax(rest.mover, rest.anchor);
}

/// Returns whether `one` is the better place for the mark. Fixed points stay, otherwise the smaller disc moves. Of
/// two equal discs, the later point moves.
bool goesRather(const sim::RestTarget &one, const sim::RestTarget &other, const sim::State &state,
                const lessons::View &view)
{
    if (state.isDynamic(one.mover) != state.isDynamic(other.mover))
        return state.isDynamic(one.mover);
    const auto radius = [&view](int point) { return view.bodies[static_cast<std::size_t>(point)].radius; };
    if (radius(one.mover) != radius(other.mover))
        return radius(one.mover) < radius(other.mover);
    return one.mover > other.mover;
}

std::vector<sim::RestTarget> restsOf(const sim::Effect &effect, const sim::State &state)
{
    std::vector<sim::RestTarget> rests;
    effect.addRestTargets(state, rests);
    return rests;
}

void addMarks(std::vector<RestMark> &marks, const sim::Effect &effect, const sim::State &state,
              const lessons::View &view)
{
    std::map<Pair, sim::RestTarget> chosen;
    for (const sim::RestTarget &rest : restsOf(effect, state)) {
        if (sim::length(rest.position - state.positionOf(rest.anchor)) <= shortest)
            continue;
        const auto [place, isFirst] = chosen.try_emplace(pairOf(rest), rest);
        if (!isFirst && goesRather(rest, place->second, state, view))
            place->second = rest;
    }
    for (const auto &[pair, rest] : chosen)
        marks.push_back({rest, effect.kind()});
}

}

std::vector<RestMark> restMarks(const sim::Scene &scene, const sim::State &state, const lessons::View &view)
{
    std::vector<RestMark> marks;
    for (const sim::EffectPtr &effect : scene.effects) {
        if (!effect->isIdle())
            addMarks(marks, *effect, state, view);
    }
    return marks;
}

bool hasRests(const sim::Scene &scene)
{
    return std::any_of(scene.effects.begin(), scene.effects.end(),
                       [&](const sim::EffectPtr &effect) { return !restsOf(*effect, scene.start).empty(); });
}

}

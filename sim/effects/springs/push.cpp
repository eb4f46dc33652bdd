#include "sim/effects/springs/push.h"

#include "sim/effects/pairs/pair_kernels.h"
#include "sim/scene/values.h"

#include <algorithm>
#include <numeric>

namespace sim {

template class PairForce<PushLaw>;

namespace {

/// Returns all pairs of `points`. The point with the lower index is the mover.
std::vector<PointPair> allPairs(std::vector<int> points, Reaction reaction)
{
    std::sort(points.begin(), points.end());
    std::vector<PointPair> pairs;
    for (auto one = points.begin(); one != points.end(); ++one) {
        for (auto other = std::next(one); other != points.end(); ++other)
            pairs.push_back({*one, *other, 0, reaction == Reaction::equal});
    }
    return pairs;
}

}

Push::Push(const std::vector<int> &points, double k, double distance, Reaction reaction)
    : DescribedEffect({k, distance}, allPairs(points, reaction), {{}})
{
}

bool Push::addToDraft(BlueprintDraft &draft) const
{
    const auto points = static_cast<std::size_t>(draft.state.pointCount());
    if (2 * links().size() != points * (points - 1))
        return false; // it acts on some points only, and a blueprint cannot express that
    draft.addEffect("push", {{"push", law().k}, {"distance", law().distance}});
    return true;
}

std::vector<Region> PushLaw::regions(DirectionRule directionRule)
{
    return {{"sim/effects/springs/push.h", "push"},
            {"sim/base/direction.h",
             directionRule == DirectionRule::published ? "published_direction" : "direction"}};
}

std::vector<LiveValue> PushLaw::liveValues(Vec2 one, Vec2 other, Vec2 fallback, const Numbers &,
                                           DirectionRule directionRule) const
{
    const PushPull found = push(one, other, k, distance, [&](Vec2 d) {
        if (directionRule == DirectionRule::published)
            return publishedDistanceAndDirection(d);
        const Direction heading = direction(d);
        return heading.length < coincidenceDistance ? Direction{heading.length, fallback} : heading;
    });
    return {{"from", found.from}, {"missing", found.missing}, {"pull", found.pull}};
}

namespace {

constexpr ParameterSpec pushParameters[] = {
    {
        .id = "push",
        .name = SIM_TEXT("Push"),
        .symbol = "k",
        .unit = SIM_TEXT("1/frame²"),
        .help = SIM_TEXT("How hard two bodies push: this share of the missing distance, each frame."),
        .defaultValue = 0.2,
        .min = 0.0,
        .max = 1e9,
    },
    {
        .id = "distance",
        .name = SIM_TEXT("Distance"),
        .unit = SIM_TEXT("px"),
        .help = SIM_TEXT("Two bodies closer than this push each other."),
        .defaultValue = 20.0,
        .min = 0.0,
        .max = 1e6,
        .sliderMin = 0.0,
        .sliderMax = 100.0,
        .decimals = 0,
    }};

EffectPtr makePush(const Blueprint &blueprint, const Values &values)
{
    std::vector<int> all(blueprint.points.size());
    std::iota(all.begin(), all.end(), 0);
    return std::make_shared<Push>(all, values["push"], values["distance"], Reaction::equal);
}

}

namespace descriptions {
constinit const EffectDescription push = {
    .id = "push",
    .title = SIM_TEXT("push"),
    .kind = EffectKind::spring,
    .purpose = SIM_TEXT(
        "Pushes bodies apart that come too close, so that creatures do not walk through each other."),
    .parameters = pushParameters,
    .make = makePush};
}

}

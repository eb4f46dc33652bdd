#include "sim/effects/springs/radial_spring.h"

#include "sim/effects/pairs/pair_kernels.h"

namespace sim {

template class PairForce<RadialLaw>;

std::vector<Region> RadialLaw::regions(DirectionRule directionRule)
{
    if (directionRule == DirectionRule::published)
        return {{"sim/effects/springs/radial_spring.h", "radial_spring"},
                {"sim/base/direction.h", "published_direction"},
                {"sim/effects/pairs/spring.h", "spring"}};
    return {{"sim/effects/springs/radial_spring.h", "spring_pull"}};
}

std::vector<LiveValue> RadialLaw::liveValues(Vec2 mover, Vec2 anchor, Vec2 fallback, const Numbers &numbers,
                                             DirectionRule directionRule)
{
    if (directionRule == DirectionRule::published) {
        const PublishedDirection heading = publishedDirection(mover - anchor);
        const RadialPull s =
            radialSpring(mover, anchor, numbers.k, numbers.radius, [&](Vec2) { return heading.out; });
        return {{"from", s.from},     {"angle", heading.angle}, {"out", heading.out},
                {"target", s.target}, {"d", s.end.d},           {"pull", s.end.pull}};
    }
    const PairPull found = pull(mover, anchor, numbers);
    if (found.length < coincidenceDistance)
        return {{"from", mover - anchor},
                {"length", found.length},
                {"pull", pullWhenCoincident(fallback, numbers)}};
    return {{"from", mover - anchor},
            {"length", found.length},
            {"share", numbers.radius / found.length - 1.0},
            {"pull", found.pull}};
}

namespace descriptions {
constinit const EffectDescription radial_spring = {
    "radial_spring", SIM_TEXT("springs"), EffectKind::spring,
    SIM_TEXT("Keep two points a length apart: they pull when the distance is longer, and push when it is "
             "shorter.")};
}

}

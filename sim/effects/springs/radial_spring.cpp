#include "sim/effects/springs/radial_spring.h"

#include "sim/effects/pairs/pair_kernels.h"

namespace sim {

template class PairForce<RadialLaw>;

std::vector<Region> RadialLaw::regions(Directions directions)
{
    if (directions == Directions::published)
        return {{"sim/effects/springs/radial_spring.h", "radial_spring"},
                {"sim/base/direction.h", "published_direction"},
                {"sim/effects/pairs/spring.h", "spring"}};
    return {{"sim/effects/springs/radial_spring.h", "spring_pull"}};
}

std::vector<Live> RadialLaw::live(Vec2 mover, Vec2 anchor, Vec2 parting, const Numbers &one,
                                  Directions directions)
{
    if (directions == Directions::published) {
        const PublishedHeading heading = publishedDirection(mover - anchor);
        const RadialPull s =
            radialSpring(mover, anchor, one.k, one.radius, [&](Vec2) { return heading.out; });
        return {{"from", s.from},     {"angle", heading.angle}, {"out", heading.out},
                {"target", s.target}, {"d", s.end.d},           {"pull", s.end.pull}};
    }
    const Pull found = pull(mover, anchor, one);
    if (found.length < inOnePlace)
        return {{"from", mover - anchor}, {"length", found.length}, {"pull", pullInOnePlace(parting, one)}};
    return {{"from", mover - anchor},
            {"length", found.length},
            {"share", one.radius / found.length - 1.0},
            {"pull", found.pull}};
}

namespace described {
constinit const Description radial_spring = {
    "radial_spring", SIM_TEXT("springs"), Kind::spring,
    SIM_TEXT("Keep two points a length apart: they pull when it is more, and push when it is less.")};
}

}

#include "sim/effects/springs/springs.h"

#include "sim/base/error.h"

namespace sim {

namespace {

/// Returns two opposite links per spring, because both ends feel it.
std::vector<PointPair> linksOf(const std::vector<Spring> &springs, int points)
{
    std::vector<PointPair> links;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const Spring &spring = springs[i];
        for (const int end : {spring.a, spring.b}) {
            if (end < 0 || end >= points)
                throw Error("spring-without-end", {{"spring", std::to_string(i)},
                                                   {"end", std::to_string(end)},
                                                   {"points", std::to_string(points)}});
        }
        links.push_back({spring.a, spring.b, static_cast<int>(i)});
        links.push_back({spring.b, spring.a, static_cast<int>(i)});
    }
    return links;
}

std::vector<RadialLaw::Numbers> numbersOf(const std::vector<Spring> &springs)
{
    std::vector<RadialLaw::Numbers> numbers;
    for (const Spring &spring : springs)
        numbers.push_back({spring.k, spring.length});
    return numbers;
}

}

Springs::Springs(const std::vector<Spring> &springs, int points)
    : DescribedEffect({}, linksOf(springs, points), numbersOf(springs))
{
}

namespace descriptions {
constinit const EffectDescription springs = {"springs", SIM_TEXT("springs"), EffectKind::spring,
                                             SIM_TEXT("Keep two points a length apart: they pull when the "
                                                      "distance is longer, and push when it is shorter.")};
}

}

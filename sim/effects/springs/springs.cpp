#include "sim/effects/springs/springs.h"

#include "sim/base/error.h"

namespace sim {

namespace {

/// Each spring as both of its ends see it.
std::vector<PointPair> endsOf(const std::vector<Spring> &springs, int points)
{
    std::vector<PointPair> ends;
    for (std::size_t i = 0; i < springs.size(); ++i) {
        const Spring &one = springs[i];
        for (const int end : {one.a, one.b}) {
            if (end < 0 || end >= points)
                throw Error("spring-without-end", {{"spring", std::to_string(i)},
                                                   {"end", std::to_string(end)},
                                                   {"points", std::to_string(points)}});
        }
        ends.push_back({one.a, one.b, static_cast<int>(i)});
        ends.push_back({one.b, one.a, static_cast<int>(i)});
    }
    return ends;
}

std::vector<RadialLaw::Numbers> numbersOf(const std::vector<Spring> &springs)
{
    std::vector<RadialLaw::Numbers> numbers;
    for (const Spring &one : springs)
        numbers.push_back({one.k, one.length});
    return numbers;
}

}

Springs::Springs(const std::vector<Spring> &springs, int points)
    : DescribedEffect({}, endsOf(springs, points), numbersOf(springs))
{
}

namespace descriptions {
constinit const EffectDescription springs = {
    "springs", SIM_TEXT("springs"), EffectKind::spring,
    SIM_TEXT("Keep two points a length apart: they pull when it is more, and push when it is less.")};
}

}

#include "measures.h"

#include "lessons/api/creature.h"
#include "sim/effects/springs/push.h"
#include "sim/scene/values.h"
#include "view.h"

#include <QCoreApplication>

#include <cmath>
#include <limits>

using namespace lessons;
using sim::Scene;
using sim::State;
using sim::Values;

namespace walking_gait {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(WalkingGait)
};

constexpr double nothing = std::numeric_limits<double>::quiet_NaN();

int bodyOf(const State &state)
{
    return state.points() - 1;
}

double slipOf(const Scene &scene, const State &state, const State *before, const Values &values)
{
    double total = 0.0;
    int standing = 0;
    for (int i = 0; before && before->points() == state.points() && i < bodyOf(state); ++i) {
        const bool foot = !isBody(scene.names[static_cast<std::size_t>(i)]);
        if (!foot || !stands(scene, state, values, i) || !stands(scene, *before, values, i))
            continue;
        total += std::abs(state.at(i).x - before->at(i).x);
        ++standing;
    }
    return standing > 0 ? total / standing : nothing;
}

double pushesOf(const Scene &scene, const State &state, const State *, const Values &)
{
    Eigen::ArrayX2d sum = Eigen::ArrayX2d::Zero(state.points(), 2);
    for (const sim::EffectPtr &effect : scene.effects) {
        if (const auto *push = dynamic_cast<const sim::Push *>(effect.get()))
            push->add(state, {0, state.points()}, 1.0, sim::Directions::apart, sum);
    }
    const auto total = sum.colwise().sum().eval();
    return std::hypot(total[0], total[1]);
}

}

Measure swingWidth()
{
    return {
        .name = Text::tr("Swing"),
        .unit = Text::tr("px"),
        .help = Text::tr("How far foot 0 is from the middle of its places. The leg is what it would be if it "
                         "followed exactly."),
        .decimals = 1,
        .of =
            [](const Scene &, const State &state, const State *, const Values &values) {
                const sim::Vec2 middle = state.at(bodyOf(state)) + sim::Vec2{0.0, values["drop"]};
                return sim::length(state.at(0) - middle);
            },
    };
}

Measure momentumOfAll()
{
    return {
        .name = Text::tr("Momentum"),
        .unit = Text::tr("px/frame"),
        .help = Text::tr("All velocities added up; how long that arrow is. Every mass is 1."),
        .decimals = 3,
        .of =
            [](const Scene &, const State &state, const State *, const Values &) {
                const auto sum = state.velocity.colwise().sum().eval();
                return std::hypot(sum[0], sum[1]);
            },
    };
}

Measure walkingSpeed()
{
    return {
        .name = Text::tr("Walks"),
        .unit = Text::tr("px/frame"),
        .help = Text::tr("How far the body came to the right in the last frame."),
        .decimals = 2,
        .of =
            [](const Scene &, const State &state, const State *before, const Values &) {
                const bool same = before && before->points() == state.points();
                return same ? state.at(bodyOf(state)).x - before->at(bodyOf(state)).x : nothing;
            },
    };
}

Measure slip()
{
    return {
        .name = Text::tr("Slip"),
        .unit = Text::tr("px/frame"),
        .help = Text::tr("How far the standing feet slid in the last frame, on the average."),
        .decimals = 2,
        .of = slipOf,
    };
}

Measure clockSpeed()
{
    return {
        .name = Text::tr("Clock"),
        .unit = Text::tr("rad/frame"),
        .help = Text::tr("How fast the gait clock turns."),
        .decimals = 3,
        .of = [](const Scene &, const State &state, const State *,
                 const Values &) { return state.gaitSpeed.rows() > 0 ? state.gaitSpeed[0] : nothing; },
    };
}

Measure sumOfPushes()
{
    return {
        .name = Text::tr("Pushes"),
        .unit = Text::tr("px/frame²"),
        .help = Text::tr("All pushes between bodies added up; how long that arrow is."),
        .decimals = 3,
        .of = pushesOf,
    };
}

}

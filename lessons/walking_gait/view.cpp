#include "view.h"

#include "lessons/api/creature.h"
#include "lessons/api/view/acting.h"
#include "lessons/api/view/creature_view.h"
#include "lessons/walking_gait/text.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/push.h"
#include "sim/scene/values.h"

#include <QCoreApplication>

#include <cmath>
#include <limits>

using namespace lessons;
using sim::Scene;
using sim::State;
using sim::Values;

namespace walking_gait {

namespace {

constexpr double noFloor = 1e4; ///< px, far below the stage

/// Returns the y at which the ground is drawn, in px. A foot touches the ground with its position, which is
/// the centre of its disc, so the line is lower by the radius of the disc.
double groundLine(const Values &values)
{
    return values["ground"] + footWidth / 2;
}

Overlay cross(sim::Vec2 at, const QString &label = {})
{
    return {.shape = Overlay::Shape::cross, .a = at, .label = label};
}

Overlay line(sim::Vec2 from, sim::Vec2 to)
{
    return {.shape = Overlay::Shape::line, .a = from, .b = to};
}

/// Calls `visit(leg, target)` for each leg that pulls. Legs that are switched off do not pull.
template <class Visit>
void forEachLeg(const Scene &scene, const State &state, Visit &&visit)
{
    for (const sim::EffectPtr &effect : scene.effects) {
        const auto *springs = dynamic_cast<const sim::LegSpring *>(effect.get());
        if (!springs)
            continue;
        const std::vector<sim::Leg> legs = springs->legs();
        for (std::size_t i = 0; i < legs.size(); ++i)
            visit(legs[i], springs->target(state, static_cast<int>(i)));
    }
}

View withFeet(View view)
{
    for (std::size_t i = 0; i < view.bodies.size(); ++i) {
        if (view.bodies[i].shape == BodyView::Shape::foot)
            view.feet.push_back(static_cast<int>(i));
    }
    view.stage = {0, 40, 540, 400};
    return view;
}

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

int bodyOf(const State &state)
{
    return state.pointCount() - 1;
}

double slipOf(const Scene &scene, const State &state, const State *before, const Values &values)
{
    double total = 0.0;
    int standing = 0;
    for (int i = 0; before && before->pointCount() == state.pointCount() && i < bodyOf(state); ++i) {
        const bool foot = !isBody(scene.names[static_cast<std::size_t>(i)]);
        if (!foot || !isPlanted(scene, state, values, i) || !isPlanted(scene, *before, values, i))
            continue;
        total += std::abs(state.positionOf(i).x - before->positionOf(i).x);
        ++standing;
    }
    return standing > 0 ? total / standing : undefined;
}

double pushesOf(const Scene &scene, const State &state, const State *, const Values &)
{
    Eigen::ArrayX2d sum = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
    for (const sim::EffectPtr &effect : scene.effects) {
        if (const auto *push = dynamic_cast<const sim::Push *>(effect.get()))
            push->add(state, {0, state.pointCount()}, 1.0, sim::DirectionRule::regularised, sum);
    }
    const auto total = sum.colwise().sum().eval();
    return std::hypot(total[0], total[1]);
}

}

View bonesView(const Scene &scene, const Values &)
{
    View view = creatureView(scene);
    view.springs = actingSprings(scene);
    view.angle = lessons::AngleView{.from = scene.find("foot0"), .to = scene.find("body")};
    return view;
}

View straightLegsView(const Scene &scene, const Values &)
{
    return creatureViewWithLegs(scene);
}

View curvedLegsView(const Scene &scene, const Values &values)
{
    View view = creatureViewWithLegs(scene);
    for (LegView &leg : view.legs)
        leg.curve = values["curve"];
    return view;
}

View groundView(const Scene &scene, const Values &values)
{
    View view = withFeet(curvedLegsView(scene, values));
    if (effectOf<sim::Ground>(scene))
        view.ground = groundLine(values);
    view.followedPoint = scene.start.pointCount() - 1;
    return view;
}

View roomView(const Scene &scene, const Values &values)
{
    View view = withFeet(curvedLegsView(scene, values));
    const bool hasGround = effectOf<sim::Ground>(scene);
    if (effectOf<sim::Walls>(scene))
        view.room = sim::Room{values["left"], values["right"], hasGround ? groundLine(values) : noFloor, 0.0};
    else if (hasGround)
        view.ground = groundLine(values);
    return view;
}

bool isPlanted(const Scene &scene, const State &state, const Values &values, int point)
{
    return effectOf<sim::Ground>(scene) && state.isDynamic(point) &&
           state.positionOf(point).y >= values["ground"];
}

Overlays boneLines(const Scene &scene, const State &state, const Values &)
{
    Overlays all;
    forEachLeg(scene, state, [&](const sim::Leg &leg, sim::Vec2 target) {
        all.push_back(line(state.positionOf(leg.body), target));
        all.push_back(cross(target, Text::tr("foot %1").arg(leg.foot)));
    });
    return all;
}

Overlays footTargets(const Scene &scene, const State &state, const Values &)
{
    Overlays all;
    forEachLeg(scene, state, [&](const sim::Leg &, sim::Vec2 target) { all.push_back(cross(target)); });
    return all;
}

Overlays legControlPoints(const Scene &scene, const State &state, const Values &values)
{
    Overlays all;
    forEachLeg(scene, state, [&](const sim::Leg &leg, sim::Vec2) {
        const sim::Vec2 foot = state.positionOf(leg.foot);
        const sim::Vec2 bend = {foot.x, foot.y - values["curve"]};
        all.insert(all.end(), {line(foot, bend), line(bend, state.positionOf(leg.body)), cross(bend)});
    });
    return all;
}

Overlays targetsOnCircle(const Scene &scene, const State &state, const Values &values)
{
    Overlays all = footTargets(scene, state, values);
    const sim::Vec2 body = state.positionOf(state.pointCount() - 1);
    all.push_back(
        {.shape = Overlay::Shape::ring, .a = {body.x, body.y + values["drop"]}, .size = values["leg"]});
    return all;
}

Overlays centreAndTargets(const Scene &scene, const State &state, const Values &values)
{
    Overlays all = footTargets(scene, state, values);
    const auto mean = state.position.colwise().mean().eval();
    all.push_back(cross({mean[0], mean[1]}, Text::tr("middle")));
    return all;
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
                const sim::Vec2 centre = state.positionOf(bodyOf(state)) + sim::Vec2{0.0, values["drop"]};
                return sim::length(state.positionOf(0) - centre);
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
                const bool isComparable = before && before->pointCount() == state.pointCount();
                return isComparable ? state.positionOf(bodyOf(state)).x - before->positionOf(bodyOf(state)).x
                                    : undefined;
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
                 const Values &) { return state.gaitSpeed.rows() > 0 ? state.gaitSpeed[0] : undefined; },
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

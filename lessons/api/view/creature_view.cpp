#include "lessons/api/view/creature_view.h"

#include "lessons/api/creature.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/offset_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"

#include <algorithm>

namespace lessons {

namespace {

/// Adds one zigzag a link, but none for a link that leads back along one that is there already.
void addLinks(std::vector<SpringView> &looks, const std::vector<sim::PointPair> &links, double length,
              sim::Vec2 at = {})
{
    const std::size_t first = looks.size();
    for (const sim::PointPair &link : links) {
        const auto leadsBack = [&](const SpringView &one) {
            return one.a == link.anchor && one.b == link.mover;
        };
        const auto from = looks.begin() + static_cast<std::ptrdiff_t>(first);
        if (at != sim::Vec2() || std::none_of(from, looks.end(), leadsBack))
            looks.push_back({.a = link.mover, .b = link.anchor, .length = length, .at = at});
    }
}

/// Legs whose places stay where they are, seen from the body.
void addLegs(std::vector<SpringView> &looks, const sim::LegSpring &springs, const sim::State &state)
{
    if (springs.rule().aim == sim::Aim::swing)
        return;
    const std::vector<sim::Leg> legs = springs.legs();
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const sim::Leg &leg = legs[i];
        looks.push_back({.a = leg.foot,
                         .b = leg.body,
                         .at = springs.target(state, static_cast<int>(i)) - state.positionOf(leg.body)});
    }
}

}

View creatureView(const sim::Scene &scene)
{
    View look;
    for (const std::string &name : scene.names) {
        look.bodies.push_back(isBody(name) ? BodyView{BodyView::Shape::body, bodyWidth / 2}
                                           : BodyView{BodyView::Shape::foot, footWidth / 2});
    }
    return look;
}

View creatureViewWithLegs(const sim::Scene &scene)
{
    View look = creatureView(scene);
    int firstFoot = 0;
    for (int i = 0; i < scene.start.pointCount(); ++i) {
        if (!isBody(scene.names[static_cast<std::size_t>(i)]))
            continue;
        for (int foot = firstFoot; foot < i; ++foot)
            look.legs.push_back({i, foot});
        firstFoot = i + 1;
    }
    return look;
}

std::vector<SpringView> actingSprings(const sim::Scene &scene)
{
    std::vector<SpringView> looks;
    for (const sim::EffectPtr &effect : scene.effects) {
        if (effect->isIdle())
            continue;
        if (const auto *toPlace = dynamic_cast<const sim::PointSpring *>(effect.get()))
            looks.push_back({.a = toPlace->mover(), .b = -1, .at = toPlace->centre()});
        else if (const auto *toPoints = dynamic_cast<const sim::BodySpring *>(effect.get()))
            addLinks(looks, toPoints->links(), 0.0);
        else if (const auto *beside = dynamic_cast<const sim::OffsetSpring *>(effect.get()))
            addLinks(looks, beside->links(), 0.0, {beside->numbers().front().offset, 0.0});
        else if (const auto *radial = dynamic_cast<const sim::RadialSpring *>(effect.get()))
            addLinks(looks, radial->links(), radial->numbers().front().radius);
        else if (const auto *legs = dynamic_cast<const sim::LegSpring *>(effect.get()))
            addLegs(looks, *legs, scene.start);
    }
    return looks;
}

View crowdByPartsView(const sim::Scene &scene, int creatures)
{
    View look = creatureView(scene);
    for (int foot = creatures; foot < scene.start.pointCount(); ++foot)
        look.legs.push_back({foot % creatures, foot});
    return look;
}

}

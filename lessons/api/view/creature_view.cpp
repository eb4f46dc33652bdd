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

/// Adds one zigzag per link, but only one for two links between the same points in opposite directions.
void addLinks(std::vector<SpringView> &springViews, const std::vector<sim::PointPair> &links, double length,
              sim::Vec2 at = {})
{
    const std::size_t first = springViews.size();
    for (const sim::PointPair &link : links) {
        const auto isOpposite = [&](const SpringView &view) {
            return view.a == link.anchor && view.b == link.mover;
        };
        const auto from = springViews.begin() + static_cast<std::ptrdiff_t>(first);
        if (at != sim::Vec2() || std::none_of(from, springViews.end(), isOpposite))
            springViews.push_back({.a = link.mover, .b = link.anchor, .length = length, .at = at});
    }
}

/// Adds one zigzag per leg whose target is fixed relative to the body.
void addLegs(std::vector<SpringView> &springViews, const sim::LegSpring &springs, const sim::State &state)
{
    if (springs.rule().aim == sim::Aim::swing)
        return;
    const std::vector<sim::Leg> legs = springs.legs();
    for (std::size_t i = 0; i < legs.size(); ++i) {
        const sim::Leg &leg = legs[i];
        springViews.push_back(
            {.a = leg.foot,
             .b = leg.body,
             .at = springs.target(state, static_cast<int>(i)) - state.positionOf(leg.body)});
    }
}

}

View creatureView(const sim::Scene &scene)
{
    View view;
    for (const std::string &name : scene.names) {
        view.bodies.push_back(isBody(name) ? BodyView{BodyView::Shape::body, bodyWidth / 2}
                                           : BodyView{BodyView::Shape::foot, footWidth / 2});
    }
    return view;
}

View creatureViewWithLegs(const sim::Scene &scene)
{
    View view = creatureView(scene);
    int firstFoot = 0;
    for (int i = 0; i < scene.start.pointCount(); ++i) {
        if (!isBody(scene.names[static_cast<std::size_t>(i)]))
            continue;
        for (int foot = firstFoot; foot < i; ++foot)
            view.legs.push_back({i, foot});
        firstFoot = i + 1;
    }
    return view;
}

std::vector<SpringView> actingSprings(const sim::Scene &scene)
{
    std::vector<SpringView> springViews;
    for (const sim::EffectPtr &effect : scene.effects) {
        if (effect->isIdle())
            continue;
        if (const auto *pointSpring = dynamic_cast<const sim::PointSpring *>(effect.get()))
            springViews.push_back({.a = pointSpring->mover(), .b = -1, .at = pointSpring->centre()});
        else if (const auto *bodySpring = dynamic_cast<const sim::BodySpring *>(effect.get()))
            addLinks(springViews, bodySpring->links(), 0.0);
        else if (const auto *offsetSpring = dynamic_cast<const sim::OffsetSpring *>(effect.get()))
            addLinks(springViews, offsetSpring->links(), 0.0, {offsetSpring->numbers().front().offset, 0.0});
        else if (const auto *radial = dynamic_cast<const sim::RadialSpring *>(effect.get()))
            addLinks(springViews, radial->links(), radial->numbers().front().radius);
        else if (const auto *legs = dynamic_cast<const sim::LegSpring *>(effect.get()))
            addLegs(springViews, *legs, scene.start);
    }
    return springViews;
}

View crowdByPartsView(const sim::Scene &scene, int creatures)
{
    View view = creatureView(scene);
    for (int foot = creatures; foot < scene.start.pointCount(); ++foot)
        view.legs.push_back({foot % creatures, foot});
    return view;
}

}

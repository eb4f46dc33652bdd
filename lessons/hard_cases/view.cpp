#include "view.h"

#include "lessons/api/creature.h"
#include "lessons/api/view/creature_view.h"
#include "lessons/api/view/tree_view.h"
#include "lessons/hard_cases/text.h"
#include "scenes.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/tree/joints.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>

using namespace lessons;

namespace hard_cases {

namespace {

constexpr double lightRadius = 6.0;  ///< px
constexpr double heavyRadius = 20.0; ///< px
constexpr double jointRadius = 4.0;  ///< px
constexpr double minShown = 0.5;     ///< px, smallest displacement that is shown with a line

sim::Vec2 centreOf(const sim::State &state)
{
    return {state.position.col(0).mean(), state.position.col(1).mean()};
}

BodyView bodyViewOf(const std::string &name)
{
    if (isBody(name))
        return {BodyView::Shape::body, bodyWidth / 2};
    if (name == "heavy" || name == "lead")
        return {BodyView::Shape::body, name == "heavy" ? heavyRadius : bodyWidth / 2};
    if (name == "light")
        return {BodyView::Shape::foot, lightRadius};
    return name.starts_with("p") ? BodyView{BodyView::Shape::joint, jointRadius} : BodyView{};
}

}

View caseView(const sim::Scene &scene, const sim::Values &)
{
    View view;
    for (const std::string &name : scene.names)
        view.bodies.push_back(bodyViewOf(name));
    if (std::any_of(scene.names.begin(), scene.names.end(), isBody))
        view = creatureViewWithLegs(scene);
    else if (scene.names.front() == "light")
        view.legs = {{1, 0}};
    for (const sim::EffectPtr &effect : scene.effects) {
        if (const auto *joints = dynamic_cast<const sim::Joints *>(effect.get()))
            return treeView(joints->tree());
        if (const auto *walls = dynamic_cast<const sim::Walls *>(effect.get()))
            view.room = walls->room();
        if (const auto *ground = dynamic_cast<const sim::Ground *>(effect.get()))
            view.ground = ground->plane().ground;
    }
    for (const sim::Sticks *sticks : sim::sticksAmong(scene.effects)) {
        for (const sim::Stick &stick : sticks->list())
            view.sticks.push_back({stick.a, stick.b, stick.length});
    }
    if (scene.names.front() == "lead" && view.sticks.empty())
        view.legs = {{0, 1}}; // a soft stick
    return view;
}

View triangleView(const sim::Scene &scene, const sim::Values &values)
{
    View view;
    view.bodies.resize(scene.names.size(), {BodyView::Shape::joint, jointRadius});
    view.sticks = {{0, 2, values["longest"]}, {0, 1, shortStick}, {1, 2, shortStick}};
    view.stage = QRectF(180, 95, 180, 200);
    return view;
}

std::vector<Overlay> turningPoints(const sim::Scene &scene, const sim::State &, const sim::Values &)
{
    const sim::Vec2 start = scene.start.positionOf(0);
    return {{.shape = Overlay::Shape::cross, .a = centre},
            {.shape = Overlay::Shape::cross, .a = start},
            {.shape = Overlay::Shape::cross, .a = centre + (centre - start)}};
}

std::vector<Overlay> centreOverlays(const sim::Scene &scene, const sim::State &state, const sim::Values &)
{
    const sim::Vec2 start = centreOf(scene.start);
    const sim::Vec2 now = centreOf(state);
    std::vector<Overlay> overlays = {{.shape = Overlay::Shape::cross, .a = start}};
    const double distance = sim::length(now - start);
    if (distance >= minShown)
        overlays.push_back(
            {.shape = Overlay::Shape::line,
             .a = start,
             .b = now,
             .label = Text::tr("the middle moved %1 px").arg(QLocale().toString(distance, 'f', 0))});
    return overlays;
}

}

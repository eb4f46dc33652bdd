#include "view.h"

#include "lessons/api/creature.h"
#include "lessons/api/view/creature_view.h"
#include "lessons/api/view/tree_view.h"
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

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(HardCases)
};

constexpr double lightRadius = 6.0;
constexpr double heavyRadius = 20.0;
constexpr double jointRadius = 4.0;
constexpr double leastShown = 0.5; ///< px: a shorter way has no line

sim::Vec2 middleOf(const sim::State &state)
{
    return {state.position.col(0).mean(), state.position.col(1).mean()};
}

BodyView bodyLook(const std::string &name)
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

View caseLook(const sim::Scene &scene, const sim::Values &)
{
    View look;
    for (const std::string &name : scene.names)
        look.bodies.push_back(bodyLook(name));
    if (std::any_of(scene.names.begin(), scene.names.end(), isBody))
        look = creatureViewWithLegs(scene);
    else if (scene.names.front() == "light")
        look.legs = {{1, 0}};
    for (const sim::EffectPtr &effect : scene.effects) {
        if (const auto *joints = dynamic_cast<const sim::Joints *>(effect.get()))
            return treeView(joints->tree());
        if (const auto *walls = dynamic_cast<const sim::Walls *>(effect.get()))
            look.room = walls->room();
        if (const auto *ground = dynamic_cast<const sim::Ground *>(effect.get()))
            look.ground = ground->plane().ground;
    }
    for (const sim::Sticks *sticks : sim::sticksAmong(scene.effects)) {
        for (const sim::Stick &stick : sticks->list())
            look.sticks.push_back({stick.a, stick.b, stick.length});
    }
    if (scene.names.front() == "lead" && look.sticks.empty())
        look.legs = {{0, 1}}; // a soft stick
    return look;
}

View threeSides(const sim::Scene &scene, const sim::Values &values)
{
    View look;
    look.bodies.resize(scene.names.size(), {BodyView::Shape::joint, jointRadius});
    look.sticks = {{0, 2, values["longest"]}, {0, 1, shortStick}, {1, 2, shortStick}};
    look.stage = QRectF(180, 95, 180, 200);
    return look;
}

std::vector<Overlay> turningPlaces(const sim::Scene &scene, const sim::State &, const sim::Values &)
{
    const sim::Vec2 start = scene.start.positionOf(0);
    return {{.shape = Overlay::Shape::cross, .a = centre},
            {.shape = Overlay::Shape::cross, .a = start},
            {.shape = Overlay::Shape::cross, .a = centre + (centre - start)}};
}

std::vector<Overlay> middleMarks(const sim::Scene &scene, const sim::State &state, const sim::Values &)
{
    const sim::Vec2 was = middleOf(scene.start);
    const sim::Vec2 is = middleOf(state);
    std::vector<Overlay> marks = {{.shape = Overlay::Shape::cross, .a = was}};
    const double way = sim::length(is - was);
    if (way >= leastShown)
        marks.push_back({.shape = Overlay::Shape::line,
                         .a = was,
                         .b = is,
                         .label = Text::tr("the middle moved %1 px").arg(QLocale().toString(way, 'f', 0))});
    return marks;
}

}

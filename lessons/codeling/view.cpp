#include "view.h"

#include "lessons/api/view/acting.h"
#include "lessons/codeling/text.h"
#include "scenes.h"
#include "sim/effects/drivers/motor.h"

#include <QCoreApplication>

#include <limits>

using namespace lessons;

namespace codeling {

namespace {

constexpr double undefined = std::numeric_limits<double>::quiet_NaN();

bool hasPoint(const sim::Scene &scene, int point)
{
    return scene.start.pointCount() > point;
}

double spineLength(const sim::State &state)
{
    return sim::length(state.positionOf(lead) - state.positionOf(tail));
}

/// Returns the chains of the tentacles, each from its side to its tip. Chains without points in `scene` are
/// left out.
std::vector<ChainView> chainsOf(const sim::Scene &scene, const sim::Values &values)
{
    const int chains = values.integer("tentacles"), links = values.integer("links");
    std::vector<ChainView> chainViews;
    for (int chain = 0; chain < chains; ++chain) {
        ChainView view;
        view.points = {chain < (chains + 1) / 2 ? side0 : side1};
        for (int link = 0; link < links; ++link)
            view.points.push_back(firstOfTentacles + chain * links + link);
        if (hasPoint(scene, view.points.back()))
            chainViews.push_back(view);
    }
    return chainViews;
}

}

View spineView(const sim::Scene &scene, const sim::Values &)
{
    View view;
    view.bodies.resize(scene.names.size(), {BodyView::Shape::joint, 5.0});
    view.bodies[lead] = {BodyView::Shape::body, 13.0};
    if (hasPoint(scene, tail))
        view.legs = {{lead, tail}};
    view.showsVelocities = true;
    return view;
}

View stretchingView(const sim::Scene &scene, const sim::Values &values)
{
    View view = spineView(scene, values);
    view.showsOnionSkins = true;
    return view;
}

View bodyView(const sim::Scene &scene, const sim::Values &values)
{
    View view;
    view.bodies.resize(scene.names.size(), {BodyView::Shape::none, 2.0});
    for (const int point : {lead, tail, side0, side1})
        view.bodies[static_cast<std::size_t>(point)] = {BodyView::Shape::joint, 4.0};
    view.skins = {{{lead, side1, tail, side0}, lead}};
    if (values.has("tentacles"))
        view.chains = chainsOf(scene, values);
    view.showsVelocities = view.chains.empty(); // a hundred arrows would be confusing
    view.showsOnionSkins = view.chains.empty();
    return view;
}

std::vector<Overlay> targetAndPull(const sim::Scene &scene, const sim::State &state,
                                   const sim::Values &values)
{
    const sim::Vec2 target = state.input.target;
    if (!effectOf<sim::Motor>(scene))
        return {{.shape = Overlay::Shape::cross, .a = target}};
    const sim::Vec2 pull = sim::motor(state.positionOf(lead), target, values["k"], values["dt"]).pull;
    return {
        {.shape = Overlay::Shape::cross, .a = target},
        {.shape = Overlay::Shape::arrow, .a = state.positionOf(lead), .b = pull, .label = Text::tr("motor")}};
}

Measure anticipationMeasure()
{
    return {
        .name = Text::tr("Way to the target"),
        .unit = Text::tr("px"),
        .help = Text::tr("It grows before a move: that is the anticipation."),
        .decimals = 1,
        .of = [](const sim::Scene &, const sim::State &state, const sim::State *,
                 const sim::Values &) { return sim::length(state.positionOf(lead) - state.input.target); },
    };
}

Measure stretchMeasure()
{
    return {
        .name = Text::tr("Stretch"),
        .help = Text::tr("How long the spine is, as a part of its length at rest."),
        .decimals = 2,
        .of =
            [](const sim::Scene &, const sim::State &state, const sim::State *, const sim::Values &values) {
                const double rest = values["rest_length"];
                return rest > 0.0 ? spineLength(state) / rest : undefined;
            },
    };
}

Measure areaMeasure()
{
    return {
        .name = Text::tr("Area"),
        .help = Text::tr("The area of the body, as a part of its area at rest."),
        .decimals = 3,
        .of =
            [](const sim::Scene &, const sim::State &state, const sim::State *, const sim::Values &values) {
                const double rest = restArea(values);
                return rest > 0.0 ? sim::areaOf(state, corners) / rest : undefined;
            },
    };
}

Measure widthMeasure()
{
    return {
        .name = Text::tr("Width"),
        .unit = Text::tr("px"),
        .help = Text::tr("How far apart the two sides are."),
        .decimals = 0,
        .of =
            [](const sim::Scene &scene, const sim::State &state, const sim::State *, const sim::Values &) {
                return sim::length(state.positionOf(scene.find("side0")) -
                                   state.positionOf(scene.find("side1")));
            },
    };
}

}

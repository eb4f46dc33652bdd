#include "view.h"

#include "lessons/api/view/acting.h"
#include "lessons/api/view/creature_view.h"
#include "lessons/single_spring/text.h"
#include "scenes.h"
#include "sim/base/direction.h"
#include "sim/effects/pairs/spring.h"
#include "sim/effects/springs/offset_spring.h"
#include "sim/scene/values.h"

#include <QCoreApplication>
#include <QLocale>

#include <numbers>

using lessons::Overlay;

namespace single_spring {

namespace {

/// Returns a number in the learner's locale, with a typographic minus sign.
QString number(double value, int decimals)
{
    QString text = QLocale().toString(value, 'f', decimals);
    return text.replace(u'-', u'−');
}

sim::Vec2 centreOf(const sim::Values &values)
{
    return {values["centre_x"], values["centre_y"]};
}

}

lessons::View discsAndSprings(const sim::Scene &scene, const sim::Values &)
{
    lessons::View view = lessons::creatureView(scene);
    view.springs = lessons::actingSprings(scene);
    return view;
}

lessons::View discsWithAngle(const sim::Scene &scene, const sim::Values &values)
{
    lessons::View view = discsAndSprings(scene, values);
    view.angle = lessons::AngleView{.from = body, .to = foot};
    return view;
}

std::vector<Overlay> inactivePull(const sim::Scene &, const sim::State &state, const sim::Values &values)
{
    const sim::Vec2 centre = centreOf(values);
    const sim::Vec2 pull = sim::spring(state.positionOf(foot), centre, values["k"]).pull;
    return {{.shape = Overlay::Shape::cross, .a = centre},
            {.shape = Overlay::Shape::arrow,
             .a = state.positionOf(foot),
             .b = pull,
             .label = Text::tr("pull, not acting yet")}};
}

std::vector<Overlay> centreCross(const sim::Scene &scene, const sim::State &, const sim::Values &values)
{
    if (!lessons::hasEffectOfKind(scene, sim::EffectKind::spring))
        return {};
    return {{.shape = Overlay::Shape::cross, .a = centreOf(values)}};
}

std::vector<Overlay> offsetCross(const sim::Scene &scene, const sim::State &state, const sim::Values &values)
{
    if (!lessons::hasEffectOfKind(scene, sim::EffectKind::spring))
        return {};
    return {
        {.shape = Overlay::Shape::cross, .a = sim::offsetTarget(state.positionOf(body), values["offset"])}};
}

std::vector<Overlay> ringAndAngle(const sim::Scene &scene, const sim::State &state, const sim::Values &values)
{
    if (!lessons::hasEffectOfKind(scene, sim::EffectKind::spring))
        return {};
    const sim::Vec2 centre = state.positionOf(body);
    const sim::Vec2 end = state.positionOf(foot);
    const sim::Vec2 corner = {end.x, centre.y};
    const double angle = sim::publishedDirection(end - centre).angle;
    const QString label =
        Text::tr("%1° = %2 rad").arg(number(angle * 180.0 / std::numbers::pi, 1), number(angle, 3));
    return {{.shape = Overlay::Shape::ring, .a = centre, .size = values["radius"]},
            {.shape = Overlay::Shape::line, .a = centre, .b = corner, .label = QStringLiteral("dx")},
            {.shape = Overlay::Shape::line, .a = corner, .b = end, .label = QStringLiteral("dy")},
            {.shape = Overlay::Shape::angle, .a = centre, .size = angle, .label = label}};
}

}

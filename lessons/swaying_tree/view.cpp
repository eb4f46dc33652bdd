#include "view.h"

#include "measuring.h"
#include "sim/base/direction.h"
#include "sim/effects/drivers/turn_to_pointer.h"
#include "sim/effects/tree/joints.h"
#include "sim/effects/tree/tree_wind.h"
#include "sim/run/script/segment.h"
#include "standing.h"

#include <QCoreApplication>
#include <QLocale>

#include <cmath>

using lessons::Guide;
using sim::Vec2;

namespace swaying_tree {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(SwayingTree)
};

/// The pointer while its button is down.
const std::optional<Vec2> &pressed(const sim::State &state)
{
    static const std::optional<Vec2> none;
    return state.outside.pointerDown ? state.outside.pointer : none;
}

Guide wind(Vec2 at)
{
    return {.shape = Guide::Shape::wind, .a = at};
}

/// A dashed line that shows an angle in degrees.
Guide angleLine(Vec2 from, double angle, const QString &label)
{
    constexpr double length = 60.0;
    return {.shape = Guide::Shape::line,
            .a = from,
            .b = from + sim::branchReach(angle, length, sim::degreesPerRadian),
            .label = label};
}

QString asMeant()
{
    return Text::tr("corrected");
}

QString asPrinted()
{
    return Text::tr("published");
}

}

std::vector<Guide> trunkEnd(const sim::Scene &scene, const sim::State &state, const sim::Values &values)
{
    const auto *joints = effectOf<sim::Joints>(scene);
    if (!joints)
        return {};
    const Vec2 end = sim::endOf(joints->tree(), state, 0, sim::degreesOf(formulaOf(values)));
    const Vec2 off = end - endOf(scene, state, 0);
    const QString label = Text::tr("%1 px off").arg(QLocale().toString(sim::length(off), 'f', 4));
    return {{.shape = Guide::Shape::cross, .a = end, .label = label}};
}

std::vector<Guide> windFromPointer(const sim::Scene &scene, const sim::State &state, const sim::Values &)
{
    if (!pressed(state) || !lessons::acts(scene, sim::Kind::wind))
        return {};
    return {wind(*pressed(state))};
}

std::vector<Guide> windByBothFormulas(const sim::Scene &scene, const sim::State &state, const sim::Values &)
{
    const auto *blows = effectOf<sim::TreeWind>(scene);
    if (!pressed(state) || !blows)
        return {};
    const Vec2 pointer = *pressed(state);
    const int i = nearestBranch(scene, state, pointer);
    const Vec2 end = endOf(scene, state, i);
    const auto lineFor = [&](sim::TreeFormula formula, const QString &label) {
        const double angle = blows->breezeAt(formula, i, state.at(i), state.angle[i], pointer).wind;
        return angleLine(end, angle, label);
    };
    return {wind(pointer), lineFor(sim::TreeFormula::corrected, asMeant()),
            lineFor(sim::TreeFormula::published, asPrinted())};
}

std::vector<Guide> aimByBothFormulas(const sim::Scene &scene, const sim::State &state, const sim::Values &)
{
    const auto *joints = effectOf<sim::Joints>(scene);
    if (!pressed(state) || !joints)
        return {};
    const Vec2 pointer = *pressed(state);
    const int i = nearestBranch(scene, state, pointer);
    const double scale = joints->tree().scale[static_cast<std::size_t>(i)];
    const Vec2 reach = sim::branchReach(state.angle[i], joints->tree().baseLength, sim::publishedDegrees);
    const sim::Sight sight = sim::sightPublished(pointer, state.at(i), reach, scale);
    const Vec2 out = sim::direction(pointer - state.at(i), i, -1).out;
    return {{.shape = Guide::Shape::cross, .a = pointer},
            angleLine(state.at(i), sim::turnToPointer(out), asMeant()),
            angleLine(state.at(i), sim::turnToPointerPublished(sight.d), asPrinted())};
}

std::vector<Guide> gustFromPointer(const sim::Scene &scene, const sim::State &state,
                                   const sim::Values &values)
{
    std::vector<Guide> guides = windFromPointer(scene, state, values);
    const sim::Gale &gale = state.gale;
    constexpr double farAway = 1000.0; // px, out of the picture
    if (!state.outside.pointer)
        return guides;
    if (gale.front > 0.0 && gale.front < farAway)
        guides.push_back({.shape = Guide::Shape::ring,
                          .a = *state.outside.pointer,
                          .size = gale.front,
                          .label = Text::tr("front")});
    if (gale.end > 0.0 && gale.end < farAway)
        guides.push_back({.shape = Guide::Shape::ring,
                          .a = *state.outside.pointer,
                          .size = gale.end,
                          .label = Text::tr("end")});
    return guides;
}

QString noteOfGround(const sim::Track &run)
{
    constexpr double deep = 10.0; // px: less is not seen
    const sim::Scene &scene = run.shown().scene;
    const sim::State &state = run.now();
    if (largestBend(scene, state) < 1.0)
        return {};
    // A branch begins where its parent ends.
    if (!(state.position.col(1) > state.at(0).y + deep).any())
        return {};
    return Text::tr("Part of the tree is below the ground: the rule turns angles, and knows no ground.");
}

}

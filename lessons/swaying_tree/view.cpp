#include "view.h"

#include "lessons/api/view/acting.h"
#include "lessons/swaying_tree/text.h"
#include "scenes.h"
#include "sim/base/direction.h"
#include "sim/effects/drivers/turn_to_pointer.h"
#include "sim/effects/tree/joints.h"
#include "sim/effects/tree/torsion.h"
#include "sim/effects/tree/tree_wind.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>

using lessons::effectOf;
using lessons::Measure;
using lessons::Overlay;
using sim::Vec2;

namespace swaying_tree {

namespace {

/// Returns the pointer's position while its button is down.
const std::optional<Vec2> &pressed(const sim::State &state)
{
    static const std::optional<Vec2> none;
    return state.input.pointerDown ? state.input.pointer : none;
}

Overlay windAt(Vec2 at)
{
    return {.shape = Overlay::Shape::wind, .a = at};
}

/// Returns a dashed line in the direction `angle`, in degrees.
Overlay angleLine(Vec2 from, double angle, const QString &label)
{
    constexpr double length = 60.0;
    return {.shape = Overlay::Shape::line,
            .a = from,
            .b = from + sim::branchReach(angle, length, sim::degreesPerRadian),
            .label = label};
}

QString correctedLabel()
{
    return Text::tr("corrected");
}

QString publishedLabel()
{
    return Text::tr("published");
}

using Energy = double (*)(const sim::Torsion &, const sim::State &);

Measure energyMeasure(const QString &name, const QString &help, Energy energy)
{
    return {
        .name = name,
        .help = help,
        .decimals = 2,
        .of =
            [energy](const sim::Scene &scene, const sim::State &state, const sim::State *,
                     const sim::Values &) {
                const auto *springs = effectOf<sim::Torsion>(scene);
                return springs ? energy(*springs, state) : std::numeric_limits<double>::quiet_NaN();
            },
    };
}

double kineticEnergy(const sim::Torsion &springs, const sim::State &state)
{
    return springs.kineticEnergy(state);
}

double potentialEnergy(const sim::Torsion &springs, const sim::State &state)
{
    return springs.springEnergy(state);
}

double totalEnergy(const sim::Torsion &springs, const sim::State &state)
{
    return kineticEnergy(springs, state) + potentialEnergy(springs, state);
}

/// Returns whether a bend of more than half a turn means that: springs feel how far they were turned. Rules that set an
/// angle know only its direction.
bool countsTurns(const sim::Scene &scene)
{
    return effectOf<sim::Torsion>(scene) != nullptr;
}

double turned(const sim::Scene &scene, const sim::State &state, int branch)
{
    return state.angle[branch] - scene.start.angle[branch];
}

double shortWay(const sim::Scene &scene, const sim::State &state, int branch)
{
    return std::remainder(turned(scene, state, branch), 360.0);
}

}

double bendOf(const sim::Scene &scene, const sim::State &state, int branch)
{
    return (countsTurns(scene) ? turned : shortWay)(scene, state, branch);
}

double largestBend(const sim::Scene &scene, const sim::State &state)
{
    const auto bend = countsTurns(scene) ? turned : shortWay;
    double largest = 0.0;
    for (int branch = 0; branch < static_cast<int>(state.angle.size()); ++branch)
        largest = std::max(largest, std::abs(bend(scene, state, branch)));
    return largest;
}

sim::Vec2 endOf(const sim::Scene &scene, const sim::State &state, int branch)
{
    const auto *joints = effectOf<sim::Joints>(scene);
    if (!joints)
        return state.positionOf(branch);
    return sim::endOf(joints->tree(), state, branch, sim::degreesPerRadian);
}

int nearestBranch(const sim::Scene &scene, const sim::State &state, sim::Vec2 position)
{
    int nearest = 0;
    double min = std::numeric_limits<double>::infinity();
    for (int i = 0; i < state.pointCount(); ++i) {
        const double distance = sim::length(endOf(scene, state, i) - position);
        if (distance < min) {
            min = distance;
            nearest = i;
        }
    }
    return nearest;
}

std::vector<Overlay> trunkEnd(const sim::Scene &scene, const sim::State &state, const sim::Values &values)
{
    const auto *joints = effectOf<sim::Joints>(scene);
    if (!joints)
        return {};
    const Vec2 end = sim::endOf(joints->tree(), state, 0, sim::degreesOf(formulaOf(values)));
    const Vec2 error = end - endOf(scene, state, 0);
    const QString label = Text::tr("%1 px off").arg(QLocale().toString(sim::length(error), 'f', 4));
    return {{.shape = Overlay::Shape::cross, .a = end, .label = label}};
}

std::vector<Overlay> windFromPointer(const sim::Scene &scene, const sim::State &state, const sim::Values &)
{
    if (!pressed(state) || !lessons::hasEffectOfKind(scene, sim::EffectKind::wind))
        return {};
    return {windAt(*pressed(state))};
}

std::vector<Overlay> windByBothFormulas(const sim::Scene &scene, const sim::State &state, const sim::Values &)
{
    const auto *blows = effectOf<sim::TreeWind>(scene);
    if (!pressed(state) || !blows)
        return {};
    const Vec2 pointer = *pressed(state);
    const int i = nearestBranch(scene, state, pointer);
    const Vec2 end = endOf(scene, state, i);
    const auto lineFor = [&](sim::TreeFormula formula, const QString &label) {
        const double angle = blows->windOn(formula, i, state.positionOf(i), state.angle[i], pointer).wind;
        return angleLine(end, angle, label);
    };
    return {windAt(pointer), lineFor(sim::TreeFormula::corrected, correctedLabel()),
            lineFor(sim::TreeFormula::published, publishedLabel())};
}

std::vector<Overlay> aimByBothFormulas(const sim::Scene &scene, const sim::State &state, const sim::Values &)
{
    const auto *joints = effectOf<sim::Joints>(scene);
    if (!pressed(state) || !joints)
        return {};
    const Vec2 pointer = *pressed(state);
    const int i = nearestBranch(scene, state, pointer);
    const double scale = joints->tree().scaleOf(i);
    const Vec2 reach = sim::branchReach(state.angle[i], joints->tree().baseLength, sim::publishedDegrees);
    const sim::PointerOffset sight = sim::pointerOffsetPublished(pointer, state.positionOf(i), reach, scale);
    const Vec2 out = sim::direction(pointer - state.positionOf(i), i, -1).out;
    return {{.shape = Overlay::Shape::cross, .a = pointer},
            angleLine(state.positionOf(i), sim::turnToPointer(out), correctedLabel()),
            angleLine(state.positionOf(i), sim::turnToPointerPublished(sight.d), publishedLabel())};
}

std::vector<Overlay> gustFromPointer(const sim::Scene &scene, const sim::State &state,
                                     const sim::Values &values)
{
    std::vector<Overlay> overlays = windFromPointer(scene, state, values);
    const sim::GustExtent &gust = state.gustExtent;
    constexpr double farAway = 1000.0; // px, outside the stage
    if (!state.input.pointer)
        return overlays;
    if (gust.front > 0.0 && gust.front < farAway)
        overlays.push_back({.shape = Overlay::Shape::ring,
                            .a = *state.input.pointer,
                            .size = gust.front,
                            .label = Text::tr("front")});
    if (gust.tail > 0.0 && gust.tail < farAway)
        overlays.push_back({.shape = Overlay::Shape::ring,
                            .a = *state.input.pointer,
                            .size = gust.tail,
                            .label = Text::tr("end")});
    return overlays;
}

QString groundNote(const sim::Track &run)
{
    constexpr double minDepth = 10.0; // px; less is not visible
    const sim::Scene &scene = run.interval().scene;
    const sim::State &state = run.state();
    if (largestBend(scene, state) < 1.0)
        return {};
    // A branch begins where its parent ends.
    if (!(state.position.col(1) > state.positionOf(0).y + minDepth).any())
        return {};
    return Text::tr("Part of the tree is below the ground: the rule turns angles, and knows no ground.");
}

Measure countMeasure()
{
    return {
        .name = Text::tr("Branches"),
        .help = Text::tr("How many branches the tree has."),
        .decimals = 0,
        .of = [](const sim::Scene &, const sim::State &state, const sim::State *,
                 const sim::Values &) { return double(state.pointCount()); },
    };
}

Measure bendMeasure()
{
    return {
        .name = Text::tr("Largest bend"),
        .unit = Text::tr("°"),
        .help = Text::tr("How far the most bent branch is turned from where it grew."),
        .decimals = 1,
        .of = [](const sim::Scene &scene, const sim::State &state, const sim::State *,
                 const sim::Values &) { return largestBend(scene, state); },
    };
}

std::vector<Measure> energyMeasures()
{
    return {energyMeasure(Text::tr("Energy"),
                          Text::tr("Of motion and springs together. Without wind and damping it stays."),
                          totalEnergy),
            energyMeasure(Text::tr("In motion"), Text::tr("The part that is in the turning branches."),
                          kineticEnergy),
            energyMeasure(Text::tr("In springs"), Text::tr("The part that the bent joints hold."),
                          potentialEnergy)};
}

}

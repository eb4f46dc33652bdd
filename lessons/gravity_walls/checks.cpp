#include "checks.h"

#include "lessons/api/checks/run_queries.h"
#include "lessons/api/creature.h"
#include "lessons/gravity_walls/text.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>

#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace gravity_walls {

namespace {

/// Returns whether the edge of a dynamic point touches the left (else the right) wall. With `atRest`, its
/// velocity across the wall must be 0, too.
bool touchesSide(const Timeline &run, bool left, bool atRest = false)
{
    const sim::State &state = run.state();
    const Eigen::ArrayXd halfWidth = halfWidths(run.track().interval().scene);
    for (int i = 0; i < state.pointCount(); ++i) {
        const double edge = left ? state.position(i, 0) - halfWidth[i] : state.position(i, 0) + halfWidth[i];
        const double wall = run.values()[left ? "left" : "right"];
        if (state.isDynamic(i) && std::abs(edge - wall) < 1e-9 && (!atRest || state.velocity(i, 0) == 0.0))
            return true;
    }
    return false;
}

/// Returns whether, inside a frame, a dynamic point is past a wall that has not moved it back yet.
bool isPastAWall(const Timeline &run)
{
    const sim::State &state = run.state();
    const Eigen::ArrayXd halfWidth = halfWidths(run.track().interval().scene);
    const Eigen::ArrayXd x = state.position.col(0), y = state.position.col(1);
    const auto past = (x + halfWidth > run.values()["right"] + 1e-9) ||
                      (x - halfWidth < run.values()["left"] - 1e-9) ||
                      (y + halfWidth > run.values()["floor"] + 1e-9);
    return run.cursor().phase > 0 && (past && state.inverseMass != 0.0).any();
}

/// Returns whether the whole body is above the upper edge of the picture, at y = 0.
bool isAboveThePicture(const Timeline &run)
{
    return positionOf(run, "body").y < -bodyWidth / 2;
}

/// Returns whether all feet hang still below the body, at the distance at which the spring balances gravity.
bool areFeetHanging(const Timeline &run)
{
    const double k = run.values()["k"];
    if (k <= 0.0 || !isStill(run))
        return false;
    const double distance = run.values()["radius"] + run.values()["gravity"] / k;
    const sim::State &state = run.state();
    const sim::Vec2 body = state.positionOf(state.pointCount() - 1);
    for (int i = 0; i + 1 < state.pointCount(); ++i) {
        if (sim::length(state.positionOf(i) - body - sim::Vec2{0.0, distance}) > 0.5)
            return false;
    }
    return true;
}

Condition pastAWall()
{
    return {isPastAWall,
            Text::tr("press **Shift+→** until something has moved into a wall: throw it at one first.")};
}

Condition hanging()
{
    return {areFeetHanging, Text::tr("hold it still, high over the floor, until the feet hang still.")};
}

Condition touching(const QString &todo, bool atRest)
{
    return {[atRest](const Timeline &run) {
                return touchesSide(run, true, atRest) || (atRest && touchesSide(run, false, atRest));
            },
            todo};
}

double wallDistance(const Timeline &run)
{
    return run.values()["right"] - run.values()["left"];
}

double heightAboveFloor(const Timeline &run)
{
    return run.values()["floor"] - positionOf(run, "body").y;
}

}

std::vector<Try> wallsTries()
{
    return {
        {
            .text = Text::tr(
                "Throw the creature, at 5 px per frame or more, so that some part of it hits the left "
                "wall."),
            .conditions =
                {
                    released(),
                    thrownAtLeast(),
                    touching(Text::tr("throw it so that it hits the left wall."), false),
                },
            .hint =
                Text::tr("Press **Space**, take the large disc, swing it quickly to the left, and let go on "
                         "the way."),
        },
        {
            .text = Text::tr(
                "Stop inside a frame (**Shift+→**) when something has moved into a wall, before it is put "
                "back."),
            .conditions =
                {
                    insideFrame(),
                    pastAWall(),
                },
            .hint =
                Text::tr("Throw the creature at a wall and stop just before it is there. Then press "
                         "**Shift+→** again and again: after a move, look whether an edge is past the wall."),
        },
        {
            .text =
                Text::tr("Set **bounce** to 0 and throw it at a side wall. What hits it loses its speed."),
            .conditions =
                {
                    parameterSetTo("bounce", 0.0),
                    releasedSinceSet("bounce"),
                    thrownAtLeast(),
                    touching(Text::tr("throw it so that it hits a side wall."), true),
                },
            .hint = Text::tr(
                "Type 0 into the field beside **Bounce**, press **Space**, and throw the creature at "
                "the left or the right wall."),
        },
        {
            .text = Text::tr("There is no ceiling. Throw the body out over the top."),
            .conditions =
                {
                    released("body"),
                    thrownAtLeast(),
                    {isAboveThePicture,
                     Text::tr("throw it upwards, and harder: the body has to get above y = 0.")},
                },
            .hint =
                Text::tr("Press **Space**, take the large disc, swing it quickly up past the upper edge, and "
                         "let go on the way."),
        },
    };
}

std::vector<Try> gravityTries()
{
    return {
        {
            .text = Text::tr("Hold the body high up until the feet hang still. They hang radius + g / k "
                             "below it: 52.5 px."),
            .conditions = {holding("body"), hanging()},
            .hint =
                Text::tr("Press **Space**, take the large disc, lift it to the upper edge, and hold it there "
                         "until the feet have stopped swinging."),
        },
        {
            .text = Text::tr("Do the same with **damping** at 0.6. Do the feet hang any lower?"),
            .conditions = {parameterSetTo("damp", 0.6), holding("body"), hanging()},
            .hint = Text::tr(
                "Type 0.6 into the field beside **Damping**. Then lift the large disc and hold it, as "
                "before."),
            .answer = Text::tr("No, 52.5 px again: there the spring pulls up as much as gravity pulls down, "
                               "and damping has nothing to take."),
        },
        {
            .text = Text::tr("Stop inside a frame right after gravity has pulled."),
            .conditions =
                {
                    insideFrame(),
                    {[](const Timeline &run) {
                         const sim::Phase *last = lastPhase(run);
                         return last && last->kind == sim::EffectKind::gravity;
                     },
                     Text::tr("press **Shift+→** until gravity is the last phase that was done.")},
                },
            .hint = Text::tr("Stop, and press **Shift+→** until the strip under the timeline marks gravity."),
        },
        {
            .text = Text::tr(
                "Put the walls 60 px apart (**left** 240, **right** 300), lift the body, and let it down "
                "on its feet."),
            .conditions =
                {
                    {[](const Timeline &run) { return wallDistance(run) <= 60.0; }},
                    releasedSinceSet("left", "body"),
                    releasedSinceSet("right", "body"),
                    allStill(),
                    {[](const Timeline &run) {
                         return heightAboveFloor(run) >= 30.0 &&
                                heightAboveFloor(run) <= run.values()["radius"] + bodyWidth;
                     },
                     Text::tr("lift it again, and let it down with all feet under it. It stands %1 px over "
                              "the floor."),
                     heightAboveFloor, 0},
                },
            .hint = Text::tr(
                "Type 240 beside **Left wall** and 300 beside **Right wall**. Press **Space**, lift the "
                "large disc until its feet hang under it, let it down slowly until they stand, and let "
                "go."),
        },
    };
}

}

#include "checks.h"

#include "lessons/api/checks/run_queries.h"
#include "lessons/api/creature.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>

#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace gravity_walls {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(GravityWalls)
};

/// Whether some point that is not held stands with its edge on the left wall (or the right one).
bool touchesSide(const Timeline &run, bool left, bool withoutSpeed = false)
{
    const sim::State &now = run.state();
    const Eigen::ArrayXd half = halfWidths(run.track().interval().scene);
    for (int i = 0; i < now.pointCount(); ++i) {
        const double edge = left ? now.position(i, 0) - half[i] : now.position(i, 0) + half[i];
        const double wall = run.values()[left ? "left" : "right"];
        if (now.isDynamic(i) && std::abs(edge - wall) < 1e-9 && (!withoutSpeed || now.velocity(i, 0) == 0.0))
            return true;
    }
    return false;
}

/// Whether the cursor stands inside a frame where something has moved past a wall that has not put it back yet.
bool somethingIsPastAWall(const Timeline &run)
{
    const sim::State &now = run.state();
    const Eigen::ArrayXd half = halfWidths(run.track().interval().scene);
    const Eigen::ArrayXd x = now.position.col(0), y = now.position.col(1);
    const auto past = (x + half > run.values()["right"] + 1e-9) || (x - half < run.values()["left"] - 1e-9) ||
                      (y + half > run.values()["floor"] + 1e-9);
    return run.cursor().phase > 0 && (past && now.inverseMass != 0.0).any();
}

/// Whether every foot hangs straight below the body, where its spring carries its weight.
bool feetHang(const Timeline &run)
{
    const double k = run.values()["k"];
    if (k <= 0.0 || !isStill(run))
        return false;
    const double below = run.values()["radius"] + run.values()["gravity"] / k;
    const sim::State &now = run.state();
    const sim::Vec2 body = now.positionOf(now.pointCount() - 1);
    for (int i = 0; i + 1 < now.pointCount(); ++i) {
        if (sim::length(now.positionOf(i) - body - sim::Vec2{0.0, below}) > 0.5)
            return false;
    }
    return true;
}

Condition hanging()
{
    return {feetHang, Text::tr("hold it still, high over the floor, until the feet hang still.")};
}

Condition touching(const QString &todo, bool withoutSpeed)
{
    return {[withoutSpeed](const Timeline &run) {
                return touchesSide(run, true, withoutSpeed) ||
                       (withoutSpeed && touchesSide(run, false, withoutSpeed));
            },
            todo};
}

double wallsApart(const Timeline &run)
{
    return run.values()["right"] - run.values()["left"];
}

double overFloor(const Timeline &run)
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
                    insideAFrame(),
                    {somethingIsPastAWall,
                     Text::tr(
                         "press **Shift+→** until something has moved into a wall: throw it at one first.")},
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
                    {[](const Timeline &run) { return positionOf(run, "body").y < -bodyWidth / 2; },
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
                    insideAFrame(),
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
                    {[](const Timeline &run) { return wallsApart(run) <= 60.0; }},
                    releasedSinceSet("left", "body"),
                    releasedSinceSet("right", "body"),
                    allStill(),
                    {[](const Timeline &run) {
                         return overFloor(run) >= 30.0 &&
                                overFloor(run) <= run.values()["radius"] + bodyWidth;
                     },
                     Text::tr("lift it again, and let it down with all feet under it. It stands %1 px over "
                              "the floor."),
                     overFloor, 0},
                },
            .hint = Text::tr(
                "Type 240 beside **Left wall** and 300 beside **Right wall**. Press **Space**, lift the "
                "large disc until its feet hang under it, let it down slowly until they stand, and let "
                "go."),
        },
    };
}

}

#include "tries.h"

#include "lessons/api/checks.h"
#include "lessons/api/creature.h"

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
    const sim::State &now = run.now();
    const Eigen::ArrayXd half = halfWidths(run.track().shown().scene);
    for (int i = 0; i < now.points(); ++i) {
        const double edge = left ? now.position(i, 0) - half[i] : now.position(i, 0) + half[i];
        const double wall = run.values()[left ? "left" : "right"];
        if (now.feels(i) && std::abs(edge - wall) < 1e-9 && (!withoutSpeed || now.velocity(i, 0) == 0.0))
            return true;
    }
    return false;
}

/// Whether the cursor stands inside a frame where something has moved past a wall that has not put it back yet.
bool somethingIsPastAWall(const Timeline &run)
{
    const sim::State &now = run.now();
    const Eigen::ArrayXd half = halfWidths(run.track().shown().scene);
    const Eigen::ArrayXd x = now.position.col(0), y = now.position.col(1);
    const auto past = (x + half > run.values()["right"] + 1e-9) || (x - half < run.values()["left"] - 1e-9) ||
                      (y + half > run.values()["floor"] + 1e-9);
    return run.at().phase > 0 && (past && now.inverseMass != 0.0).any();
}

/// Whether every foot hangs straight below a body in the hand, where its spring carries its weight.
bool feetHang(const Timeline &run)
{
    const double k = run.values()["k"];
    if (heldBody(run) != "body" || k <= 0.0 || !isStill(run))
        return false;
    const double below = run.values()["radius"] + run.values()["gravity"] / k;
    const sim::State &now = run.now();
    const sim::Vec2 body = now.at(now.points() - 1);
    for (int i = 0; i + 1 < now.points(); ++i) {
        if (sim::length(now.at(i) - body - sim::Vec2{0.0, below}) > 0.5)
            return false;
    }
    return true;
}

/// Between walls so close that its feet cannot slide away.
bool standsOnItsFeet(const Timeline &run)
{
    const double above = run.values()["floor"] - placeOf(run, "body").y;
    const double wide = run.values()["right"] - run.values()["left"];
    return wide <= 60.0 && heldBody(run).empty() && above >= 30.0 &&
           above <= run.values()["radius"] + bodyWidth && isStill(run);
}

}

std::vector<Try> wallsTries()
{
    return {
        {Text::tr("Throw the creature so that some part of it hits the left wall."),
         [](const Timeline &run) { return wasThrown(run) && touchesSide(run, true); }},
        {Text::tr("Stop inside a frame (**Shift+→**) when something has moved into a wall, before it is put "
                  "back."),
         somethingIsPastAWall},
        {Text::tr("Set **bounce** to 0 and throw it at a side wall. What hits it loses its speed."),
         [](const Timeline &run) {
             return isSetTo(run, "bounce", 0.0) && wasThrown(run) &&
                    (touchesSide(run, true, true) || touchesSide(run, false, true));
         }},
        {Text::tr("There is no ceiling. Throw the body out over the top."),
         [](const Timeline &run) {
             return wasThrown(run, "body") && placeOf(run, "body").y < -bodyWidth / 2;
         }},
    };
}

std::vector<Try> gravityTries()
{
    return {
        {Text::tr(
             "Hold the body high up until the feet hang still. They hang radius + g / k below it: 52.5 px."),
         feetHang},
        {Text::tr("Do the same with **damping** at 0.6. Do the feet hang any lower?"),
         [](const Timeline &run) { return isSetTo(run, "damp", 0.6) && feetHang(run); }},
        {Text::tr("Stop inside a frame right after gravity has pulled."),
         [](const Timeline &run) {
             const sim::Phase *last = lastPhase(run);
             return last && last->kind == sim::Kind::gravity;
         }},
        {Text::tr("Put the walls 60 px apart (**left** 240, **right** 300), lift the body, and let it down "
                  "on its feet."),
         standsOnItsFeet},
    };
}

}

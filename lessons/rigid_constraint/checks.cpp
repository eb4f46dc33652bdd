#include "checks.h"

#include "figure.h"
#include "lessons/api/checks/hand.h"
#include "lessons/api/checks/run_queries.h"
#include "sim/run/script/segment.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>

#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace rigid_constraint {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(RigidConstraint)
};

/// How far the pointer is from where p0 started, in px; 0 before it comes.
double pointerFrom(const Timeline &run)
{
    const std::optional<sim::Vec2> pointer = run.now().outside.pointer;
    return pointer ? sim::length(*pointer - run.track().shown().scene.start.at(0)) : 0.0;
}

Condition pointerCame()
{
    return {[](const Timeline &run) { return run.now().outside.pointer.has_value(); },
            Text::tr("hold the mouse button down in the picture, and lead p0.")};
}

Condition ledTo(double far)
{
    return atLeast(far, pointerFrom,
                   Text::tr("lead p0 %2 px away or more, with the mouse button down. So far: %1 px.")
                       .replace(QStringLiteral("%2"), QString::number(far)),
                   0);
}

double p0FromPointer(const Timeline &run)
{
    return sim::length(placeOf(run, "p0") - run.now().outside.pointer.value_or(sim::Vec2{1e9, 1e9}));
}

double worstError(const Timeline &run)
{
    return largestError(run.track().shown().scene, run.now());
}

double worstStretch(const Timeline &run)
{
    return largestStretch(run.track().shown().scene, run.now());
}

double p1Strayed(const Timeline &run)
{
    const sim::Scene &scene = run.track().shown().scene;
    return sim::length(placeOf(run, "p1") - scene.start.at(scene.find("p1")));
}

/// A condition that all sticks are right to `most` px, between two frames.
Condition rightTo(double most, int decimals)
{
    return {[most](const Timeline &run) { return run.at().phase == 0 && worstError(run) <= most; },
            Text::tr("keep the pointer still. The largest error is %1 px."), worstError, decimals};
}

Condition wrongBy(double least)
{
    return atLeast(least, worstError, Text::tr("move the pointer faster. The largest error is %1 px."));
}

/// Whether p1 has stood still for ten frames in which p0 moved at least 20 px.
bool onlyP0Moves(const Timeline &run)
{
    if (run.at().frame < 10 || run.at().phase > 0)
        return false;
    const sim::State before = run.track().stateAt(run.at().frame - 10);
    const bool stands = before.points() > 1 && before.at(1) == run.now().at(1);
    return stands && sim::length(before.at(0) - run.now().at(0)) >= 20.0;
}

bool touchesAWall(const Timeline &run)
{
    const Eigen::ArrayXd x = run.now().position.col(0);
    const double reach = headRadius + 1e-6;
    return (x <= run.values()["left"] + reach).any() || (x >= run.values()["right"] - reach).any();
}

Condition hitsAWall()
{
    return {touchesAWall, Text::tr("throw it so that it hits a side wall.")};
}

}

std::vector<Try> pairTries()
{
    return {
        {Text::tr("Lead p0 at least 150 px away. p1 is pulled after it."),
         {pointerCame(), ledTo(150.0),
          atLeast(60.0, p1Strayed, Text::tr("let time run (**Space**): p1 has come %1 px of 60 px."), 0)}},
        {Text::tr("Stop inside a frame (**Shift+→**) when the pointer has moved p0 by 20 px or more, and "
                  "the stick has not acted."),
         {pointerCame(),
          insideAFrame(),
          {[](const Timeline &run) {
               const sim::Phase *last = lastPhase(run);
               return last && last->kind == sim::Kind::driver;
           },
           Text::tr("press **Shift+→** until the pointer has moved p0, and the stick has not acted.")},
          atLeast(20.0, worstError,
                  Text::tr("put the pointer farther from p0 before that frame. It was %1 px."), 0)}},
        Try{Text::tr("Set **length** to 0 and lead p0 away, 50 px or more. Where is p1?"),
            {isSet("length", 0.0),
             ledTo(50.0),
             {[](const Timeline &run) { return distance(run, "p0", "p1") < 0.01; },
              Text::tr("let time run (**Space**) until the stick is right.")}}}
            .answered(Text::tr("In the same place as p0: a stick of 0 px holds two points together.")),
    };
}

std::vector<Try> sharedErrorTries()
{
    return {
        {Text::tr("With **share** at 1, lead the pointer around p1. p1 does not move at all."),
         {pointerCame(),
          isSet("share", 1.0, Text::tr("set **share** to 1.")),
          ledTo(50.0),
          {onlyP0Moves,
           Text::tr("lead the pointer on, so that p0 comes 20 px or more in ten frames while p1 stands.")}}},
        {Text::tr("Set **share** to 0 and lead p0 at least 150 px away. It stays at the pointer."),
         {isSet("share", 0.0),
          ledTo(150.0),
          {[](const Timeline &run) { return p0FromPointer(run) < 0.01; },
           Text::tr("let time run (**Space**) until p0 is at the pointer.")}}},
        {Text::tr(
             "Set **share** to 0.5, lead p0 100 px away or more, and hold the pointer still until p0 has "
             "come to it."),
         {isSet("share", 0.5),
          ledTo(100.0),
          {[](const Timeline &run) { return p0FromPointer(run) < 0.5; },
           Text::tr("hold the pointer still while time runs. p0 is %1 px from it."), p0FromPointer}}},
    };
}

std::vector<Try> triangleTries()
{
    return {
        {Text::tr("Lead p0 away so fast that a stick is wrong by 10 px."),
         {pointerCame(), ledTo(100.0), wrongBy(10.0)}},
        {Text::tr("Then hold it still until all three sticks are right to 0.01 px."),
         {pointerCame(), ledTo(100.0), rightTo(0.01, 2)}},
        {Text::tr(
             "Set **length** to 150 and lead p0 off the line, until all three sticks are right to 0.01 px."),
         {isSet("length", 150.0), pointerCame(), ledTo(20.0), rightTo(0.01, 2)}},
    };
}

std::vector<Try> listTries()
{
    return {
        {Text::tr("Lead p0 at least 150 px away, and wait until every stick is right to 0.1 px."),
         {pointerCame(), ledTo(150.0), rightTo(0.1, 1)}},
        {Text::tr("Set **triangles** to 15 and shake p0, until a stick is wrong by 20 px."),
         {isSet("triangles", 15.0), pointerCame(), ledTo(20.0), wrongBy(20.0)}},
        {Text::tr("Go back in time, change **length**, and compare with the ghost."),
         {ghostDiffers("length"), besideGhost()}},
    };
}

std::vector<Try> verletTries()
{
    return {
        {Text::tr("Throw the box against a wall, at 5 px per frame or more."),
         {letGoOf(), fastEnough(), hitsAWall()}},
        {Text::tr("Set **iterations** to 20, carry the box 50 px or more, drop it, and wait until it lies "
                  "still."),
         {isSet("iterations", 20.0), letGoSinceSet("iterations"), carriedFar(50.0), allStill()}},
        {Text::tr("Set **gravity** to 0 and throw it. A second later it still glides."),
         {isSet("gravity", 0.0), letGoSinceSet("gravity"), fastEnough(), handsOff(30)}},
        {Text::tr("Stop inside a frame when the sticks have moved points, and the velocity is still the old "
                  "one."),
         {insideAFrame(),
          {[](const Timeline &run) {
               const sim::Phase *last = lastPhase(run);
               return last && last->kind == sim::Kind::stick;
           },
           Text::tr("press **Shift+→** until the sticks are the last phase that was done.")}}},
    };
}

std::vector<Try> ragdollTries()
{
    return {
        {Text::tr("Lift it by any point, 50 px or more, drop it, and wait until it lies still."),
         {letGoOf(), carriedFar(50.0), allStill()}},
        {Text::tr("Throw it at a wall, at 5 px per frame or more."), {letGoOf(), fastEnough(), hitsAWall()}},
        {Text::tr("Set **iterations** to 1 and shake it, until a stick is wrong by 25 %."),
         {isSet("iterations", 1.0),
          {[](const Timeline &run) { return !heldBody(run).empty(); },
           Text::tr("take it with the mouse, and shake it.")},
          atLeast(25.0, worstStretch, Text::tr("shake it harder. The worst stick is wrong by %1 %."), 0)}},
        {Text::tr("Go back in time to before you threw it, change **iterations**, and compare with the "
                  "ghost."),
         {ghostDiffers("iterations"),
          {[](const Timeline &run) {
               const std::vector<sim::Event> &input = run.script().input;
               return std::any_of(input.begin(), input.end(), [&](const sim::Event &event) {
                   return std::holds_alternative<sim::Release>(event.what) && event.frame > run.fork();
               });
           },
           Text::tr("go back to before you threw it, and change **iterations** there.")},
          besideGhost()}},
    };
}

}

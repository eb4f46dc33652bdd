#include "tries.h"

#include "figure.h"
#include "lessons/api/checks.h"
#include "lessons/api/hand.h"

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

/// Whether the pointer has carried p0 at least `far` px from where it started.
bool pointerLed(const Timeline &run, double far)
{
    const std::optional<sim::Vec2> pointer = run.now().outside.pointer;
    return pointer && sim::length(*pointer - run.track().shown().scene.start.at(0)) >= far;
}

double fromPointer(const Timeline &run, const std::string &name)
{
    return sim::length(placeOf(run, name) - run.now().outside.pointer.value_or(sim::Vec2{1e9, 1e9}));
}

double worstError(const Timeline &run)
{
    return largestError(run.track().shown().scene, run.now());
}

double worstStretch(const Timeline &run)
{
    return largestStretch(run.track().shown().scene, run.now());
}

bool strayedFromStart(const Timeline &run, const std::string &name, double far)
{
    const sim::Scene &scene = run.track().shown().scene;
    return sim::length(placeOf(run, name) - scene.start.at(scene.find(name))) >= far;
}

/// Whether the cursor stands inside a frame where the pointer has acted and the sticks have not.
bool pointerHasActedAlone(const Timeline &run)
{
    const sim::Phase *last = lastPhase(run);
    return last && last->kind == sim::Kind::driver;
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

bool liesStill(const Timeline &run)
{
    return lastLetGo(run) && lastLetGo(run)->reach() >= 50.0 && isStill(run);
}

}

std::vector<Try> pairTries()
{
    return {
        {Text::tr("Lead p0 at least 150 px away. p1 is pulled after it."),
         [](const Timeline &run) { return pointerLed(run, 150.0) && strayedFromStart(run, "p1", 60.0); }},
        {Text::tr("Stop inside a frame (**Shift+→**) when the pointer has moved p0 by 20 px or more, and "
                  "the stick has not acted."),
         [](const Timeline &run) { return pointerHasActedAlone(run) && worstError(run) >= 20.0; }},
        {Text::tr("Set **length** to 0 and lead p0 away. Where is p1?"),
         [](const Timeline &run) {
             return isSetTo(run, "length", 0.0) && pointerLed(run, 50.0) && distance(run, "p0", "p1") < 0.01;
         }},
    };
}

std::vector<Try> sharedErrorTries()
{
    return {
        {Text::tr("With **share** at 1, lead the pointer around p1. p1 does not move at all."),
         [](const Timeline &run) {
             return isSetTo(run, "share", 1.0) && pointerLed(run, 50.0) && onlyP0Moves(run);
         }},
        {Text::tr("Set **share** to 0 and lead p0 at least 150 px away. It stays at the pointer."),
         [](const Timeline &run) {
             return isSetTo(run, "share", 0.0) && pointerLed(run, 150.0) && fromPointer(run, "p0") < 0.01;
         }},
        {Text::tr("Set **share** to 0.5, move the pointer, and hold it still until p0 has come to it."),
         [](const Timeline &run) {
             return isSetTo(run, "share", 0.5) && pointerLed(run, 100.0) && fromPointer(run, "p0") < 0.5;
         }},
    };
}

std::vector<Try> triangleTries()
{
    return {
        {Text::tr("Move the pointer so fast that a stick is wrong by 10 px."),
         [](const Timeline &run) { return pointerLed(run, 100.0) && worstError(run) >= 10.0; }},
        {Text::tr("Then hold it still until all three sticks are right to 0.01 px."),
         [](const Timeline &run) {
             return pointerLed(run, 100.0) && worstError(run) <= 0.01 && run.at().phase == 0;
         }},
        {Text::tr(
             "Set **length** to 150 and lead p0 off the line, until all three sticks are right to 0.01 px."),
         [](const Timeline &run) {
             return isSetTo(run, "length", 150.0) && pointerLed(run, 20.0) && worstError(run) <= 0.01 &&
                    run.at().phase == 0;
         }},
    };
}

std::vector<Try> listTries()
{
    return {
        {Text::tr("Lead p0 at least 150 px away, and wait until every stick is right to 0.1 px."),
         [](const Timeline &run) {
             return pointerLed(run, 150.0) && worstError(run) <= 0.1 && run.at().phase == 0;
         }},
        {Text::tr("Set **triangles** to 15 and shake p0, until a stick is wrong by 20 px."),
         [](const Timeline &run) {
             return isSetTo(run, "triangles", 15.0) && pointerLed(run, 20.0) && worstError(run) >= 20.0;
         }},
        {Text::tr("Go back in time, change **length**, and compare with the ghost."),
         [](const Timeline &run) { return comparesWithGhost(run, "length"); }},
    };
}

std::vector<Try> verletTries()
{
    return {
        {Text::tr("Throw the box against a wall."),
         [](const Timeline &run) { return wasThrown(run) && touchesAWall(run); }},
        {Text::tr("Set **iterations** to 20, carry the box 50 px or more, drop it, and wait until it lies "
                  "still."),
         [](const Timeline &run) { return isSetTo(run, "iterations", 20.0) && liesStill(run); }},
        {Text::tr("Set **gravity** to 0 and throw it. A second later it still glides."),
         [](const Timeline &run) {
             return isSetTo(run, "gravity", 0.0) && wasThrown(run) && framesWithoutHand(run) >= 30 &&
                    sim::length(momentum(run)) >= 2.0;
         }},
        {Text::tr("Stop inside a frame when the sticks have moved points, and the velocity is still the old "
                  "one."),
         [](const Timeline &run) {
             const sim::Phase *last = lastPhase(run);
             return last && last->kind == sim::Kind::stick;
         }},
    };
}

std::vector<Try> ragdollTries()
{
    return {
        {Text::tr("Lift it by any point, drop it, and wait until it lies still."), liesStill},
        {Text::tr("Throw it at a wall."),
         [](const Timeline &run) { return wasThrown(run) && touchesAWall(run); }},
        {Text::tr("Set **iterations** to 1 and shake it, until a stick is wrong by 25 %."),
         [](const Timeline &run) {
             return isSetTo(run, "iterations", 1.0) && !heldBody(run).empty() && worstStretch(run) >= 25.0;
         }},
        {Text::tr("Go back in time to before you threw it, change **iterations**, and compare with the "
                  "ghost."),
         [](const Timeline &run) { return comparesWithGhost(run, "iterations"); }},
    };
}

}

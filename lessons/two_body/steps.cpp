#include "steps.h"

#include "lessons/api/checks.h"
#include "lessons/api/parameters.h"
#include "scenes.h"

#include <QCoreApplication>

#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace two_body {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(TwoBody)
};

Step stepOf(const char *id, const QString &title)
{
    Step step = lessons::stepCalled("two_body", id, title);
    step.parameters = {stiffness(), damping(), radius()};
    return step;
}

bool keepsTheTutorialsDamping(const Timeline &run)
{
    return isSetTo(run, "damp", 0.9);
}

/// The pair left by itself: no throw is as fast as this so long after the hand let go.
bool flewOff(const Timeline &run)
{
    return isSetTo(run, "k", 0.3) && keepsTheTutorialsDamping(run) && usesMethod(run, "published") &&
           framesWithoutHand(run) >= 60 && !onStage(middle(run)) && sim::length(momentum(run)) >= 2.0;
}

bool staysInItsPlace(const Timeline &run)
{
    return isSetTo(run, "k", 0.3) && keepsTheTutorialsDamping(run) &&
           usesMethod(run, "semi_implicit_euler") && run.at().frame >= 100 && framesWithoutHand(run) >= 100 &&
           sim::length(momentum(run)) < 0.01;
}

bool footMovedBodyDidNot(const Timeline &run)
{
    return hasMoved(run, foot) && !hasMoved(run, body);
}

std::vector<Try> mutualTries()
{
    return {
        {Text::tr(
             "Stop inside a frame when the foot has moved and the body has not. What does the body see?"),
         footMovedBodyDidNot},
        {Text::tr("Set **k** to 0.3 and hands off: the pair flies out of the picture by itself."), flewOff},
        {Text::tr("Keep k at 0.3, set **damping** to 0.85, and wait until the pair is still."),
         [](const Timeline &run) {
             return isSetTo(run, "k", 0.3) && isSetTo(run, "damp", 0.85) && isStill(run);
         }},
        {Text::tr("With k at 0.3 and damping at 0.9, choose the method **Semi-implicit Euler** and watch 100 "
                  "frames, hands off."),
         staysInItsPlace},
    };
}

std::vector<Try> legLineTries()
{
    return {
        {Text::tr("Hold one end and pull so fast that the leg stretches to 100 px or more."),
         [](const Timeline &run) {
             return !heldBody(run).empty() && distance(run, "foot", "body") >= 100.0;
         }},
        {Text::tr("Hold one end and press the leg to under 20 px. Then let go."),
         [](const Timeline &run) { return !heldBody(run).empty() && distance(run, "foot", "body") < 20.0; }},
        {Text::tr("Set **radius** to 100 and wait until the leg is still, 100 px long."),
         [](const Timeline &run) {
             return isSetTo(run, "radius", 100.0) && isStill(run) &&
                    std::abs(distance(run, "foot", "body") - 100.0) < 0.5;
         }},
        {Text::tr("Go back in time, change **k**, and compare with the ghost."),
         [](const Timeline &run) { return comparesWithGhost(run, "k"); }},
    };
}

}

Step mutualStep()
{
    Step step = stepOf("mutual", Text::tr("Each pulls the other"));
    step.narration =
        Text::tr("Now **both are pulled**: the foot to a place 50 px from the body, and the body to a "
                 "place 50 px from the foot. It is one rule, used twice.\n\n"
                 "The foot moves first, and the body sees it **where it already is**. So the two pulls "
                 "are not quite opposite, and the velocities add up to more than nothing. That sum is "
                 "the **momentum**, and here it comes from nowhere: the pair drifts.\n\n"
                 "With k = 0.3 it flies for ever. Set damping to 0.85 as well, and it calms down: "
                 "damping then takes more than the order of moves gives.\n\n"
                 "The method Semi-implicit Euler moves both **at once**. Their pulls are opposite, and "
                 "the momentum stays 0.");
    step.tries = mutualTries();
    step.scene = mutual::setUp;
    step.look = [](const sim::Scene &scene, const sim::Values &) { return mutual::look(scene); };
    return step;
}

Step legLineStep()
{
    Step step = stepOf("leg_line", Text::tr("A leg"));
    step.narration = Text::tr(
        "A body, a foot, and now a **leg**: a line from one to the other. In the code it is one line, "
        "too.\n\n"
        "It is drawn after each frame, from the two places as they are then, so it always fits. It adds "
        "no pull and costs no phase: **what is drawn cannot change what is computed**.\n\n"
        "But it shows how long the spring is. A leg longer than **radius** pulls its two ends "
        "together, a shorter one pushes them apart, and at 50 px it does nothing.");
    step.tries = legLineTries();
    step.scene = leg_line::setUp;
    step.look = [](const sim::Scene &scene, const sim::Values &) { return leg_line::look(scene); };
    return step;
}

}

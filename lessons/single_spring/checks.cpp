#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/run_queries.h"
#include "lessons/single_spring/text.h"
#include "sim/base/direction.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

using namespace lessons;
using sim::Timeline;

namespace single_spring {

namespace {

sim::Vec2 centreOf(const Timeline &run)
{
    return {run.values()["centre_x"], run.values()["centre_y"]};
}

double footToCentre(const Timeline &run)
{
    return sim::length(positionOf(run, "foot") - centreOf(run));
}

/// Returns the pointer's position at the release of the foot, in px. NaN if the last drag did not release it.
sim::Vec2 releasePosition(const Timeline &run)
{
    constexpr double none = std::numeric_limits<double>::quiet_NaN();
    const std::optional<DragGesture> drag = lastReleased(run, "foot");
    return drag && !drag->path.empty() ? drag->path.back().position : sim::Vec2{none, none};
}

/// Returns the speed at the release of the foot, in px/frame. 0 if the last drag did not release it.
double releaseSpeed(const Timeline &run)
{
    const std::optional<DragGesture> drag = lastReleased(run, "foot");
    return drag ? sim::length(drag->releaseVelocity()) : 0.0;
}

/// There has been no input for `frames` frames, and damping has not been set for as long.
Condition idleSinceDampingSet(std::int64_t frames, const QString &todo)
{
    return atLeast(
        static_cast<double>(frames),
        [](const Timeline &run) {
            return static_cast<double>(std::min(idleFrames(run), framesSinceSet(run, "damp")));
        },
        todo, 0);
}

Condition isMoving()
{
    return {[](const Timeline &run) { return run.cursor().phase == 0 && !isStill(run); },
            Text::tr("let go so that it moves: it stands still.")};
}

Condition restsAtDistance(double length, const QString &todo)
{
    return {[length](const Timeline &run) {
                return isStill(run) && std::abs(distance(run, "foot", "body") - length) < 0.5;
            },
            todo};
}

/// Returns the angle between the line from body to foot and straight down, in degrees.
double angleFromBelow(const Timeline &run)
{
    const sim::Vec2 from = positionOf(run, "foot") - positionOf(run, "body");
    const double difference = sim::publishedDirection(from).angle - std::numbers::pi / 2;
    return std::abs(difference) * 180.0 / std::numbers::pi;
}

/// Returns whether the foot is within 2 px of its position five frames ago.
bool isHeldStill(const Timeline &run)
{
    constexpr std::int64_t frames = 5;
    if (run.cursor().frame < frames)
        return false;
    const sim::State before = run.track().stateAt(run.cursor().frame - frames);
    const int foot = run.track().interval().scene.find("foot");
    return sim::length(before.positionOf(foot) - run.state().positionOf(foot)) <= 2.0;
}

double footLeftOfBody(const Timeline &run)
{
    return positionOf(run, "body").x - positionOf(run, "foot").x;
}

}

std::vector<Try> dragTries()
{
    return {
        {
            .text = Text::tr(
                "Carry the foot to within 15 px of the cross, hold it still, and let go. Nothing pulls it: "
                "it stays."),
            .conditions =
                {
                    released("foot"),
                    atMost(
                        1.0, releaseSpeed,
                        Text::tr(
                            "hold it still for a moment before you let go. Yours left at %1 px per frame.")),
                    allStill(),
                    atMost(15.0, footToCentre,
                           Text::tr("let go within 15 px of the cross. Yours lies %1 px from it.")),
                },
            .hint = Text::tr(
                "Press **Space**, so that time runs. Take the foot with the mouse, carry it onto the "
                "cross, and wait a moment there before you let go."),
        },
        {
            .text = Text::tr(
                "Throw it: let go while the mouse moves at 5 px per frame or more. It glides and stops."),
            .conditions = {released("foot"), thrownAtLeast(), allStill()},
            .hint = Text::tr(
                "Press **Space**. Take the foot, move the mouse quickly, and let go on the way. Then "
                "hands off until it stands."),
        },
        {
            .text =
                Text::tr("Set **damping** to 1 and throw it again. Does it ever stop? Give it 60 frames."),
            .conditions =
                {
                    parameterSetTo("damp", 1.0),
                    releasedSinceSet("damp", "foot"),
                    thrownAtLeast(),
                    isMoving(),
                    idleSinceDampingSet(
                        60, Text::tr("let it glide for 60 frames with this damping. So far: %1.")),
                },
            .hint = Text::tr(
                "Type 1 into the field beside **Damping**. Press **Space**, throw the foot as before, "
                "and wait two seconds."),
            .answer = Text::tr("No. Nothing takes a share of its velocity, so it keeps all of it and glides "
                               "on for ever."),
        },
    };
}

std::vector<Try> fixedCentreTries()
{
    return {
        {
            .text = Text::tr(
                "Pull the foot at least 100 px away from the cross, let go, and wait until it is still."),
            .conditions =
                {
                    released("foot"),
                    atLeast(
                        100.0,
                        [](const Timeline &run) { return sim::length(releasePosition(run) - centreOf(run)); },
                        Text::tr("let go at least 100 px from the cross. Yours left %1 px from it."), 0),
                    allStill(),
                },
            .hint =
                Text::tr("Press **Space**. Take the foot far out, let go, and wait until it stands on the "
                         "cross."),
        },
        {
            .text = Text::tr(
                "Show the page **Engine** of the code, and stop inside a frame (**Shift+→**) when the spring "
                "has pulled and nothing has moved yet."),
            .conditions = {insideFrame(), onlyPulled()},
            .hint = Text::tr(
                "Click **Engine** above the code, and stop (**Space**). Then press **Shift+→** once: "
                "that is one phase. The spring is the first of them."),
        },
        {
            .text = Text::tr(
                "Set **damping** to 1, pull the foot out and let go. Does it ever stop? Give it 100 frames."),
            .conditions =
                {
                    parameterSetTo("damp", 1.0),
                    releasedSinceSet("damp", "foot"),
                    isMoving(),
                    idleSinceDampingSet(
                        100, Text::tr("let it swing for 100 frames with this damping. So far: %1.")),
                },
            .hint =
                Text::tr("Type 1 into the field beside **Damping**, press **Space**, pull the foot out, let "
                         "go, and wait some seconds."),
            .answer = Text::tr("No. Nothing takes a share of its velocity, so it swings as wide as at first, "
                               "for ever."),
        },
        {
            .text = Text::tr("Go back in time, change **damping**, and compare with the ghost."),
            .conditions = {comparisonDiffers("damp"), playedSinceFork()},
            .hint = Text::tr(
                "Play some seconds and stop. Drag the timeline back to the left, change **Damping**, "
                "and play on from there. The old run goes on as a dashed ghost."),
        },
    };
}

std::vector<Try> movingBodyTries()
{
    return {
        {
            .text = Text::tr("Carry the body at least 100 px away, and wait until the foot lies on it."),
            .conditions =
                {
                    lastGrabbed("body"),
                    draggedAtLeast(100.0),
                    restsAtDistance(
                        0.0, Text::tr("let time run (**Space**) until the foot lies still on the body.")),
                },
            .hint = Text::tr(
                "Press **Space**. Take the large disc, carry it across the picture, and let go. Wait "
                "until the foot has come to rest on it."),
        },
        {
            .text = Text::tr(
                "Set the stiffness **k** to 0.02 and carry the body until the foot is 150 px behind."),
            .conditions =
                {
                    parameterSetTo("k", 0.02),
                    holding("body"),
                    draggedAtLeast(100.0),
                    atLeast(
                        150.0, [](const Timeline &run) { return distance(run, "foot", "body"); },
                        Text::tr("carry it farther or faster. The foot is %1 px behind."), 0),
                },
            .hint =
                Text::tr("Type 0.02 into the field beside **k**. Press **Space**, and swing the body quickly "
                         "from one corner of the picture to the other."),
        },
        {
            .text = Text::tr(
                "Throw the foot (at 5 px per frame or more), and stop inside a frame when the spring has "
                "pulled it and it has not moved."),
            .conditions = {released("foot"), thrownAtLeast(), insideFrame(), onlyPulled()},
            .hint =
                Text::tr("Press **Home**, then **Space**, throw the foot, and stop with **Space** while it "
                         "flies. Then press "
                         "**Shift+→** once."),
        },
    };
}

std::vector<Try> offsetTries()
{
    return {
        {
            .text = Text::tr("Let the foot go on the left of the body. Where does it come to rest?"),
            .conditions =
                {
                    released("foot"),
                    {[](const Timeline &run) { return releasePosition(run).x < positionOf(run, "body").x; },
                     Text::tr("let go on the left of the body.")},
                    allStill(),
                },
            .hint =
                Text::tr("Press **Space**. Drag the foot to the left of the body, let go, and wait until it "
                         "stands."),
            .answer = Text::tr("On the right, on the cross: the offset is added to the x of the body, "
                               "wherever the foot comes from."),
        },
        {
            .text = Text::tr("Set **offset** to −10 or less, and wait until the foot is still."),
            .conditions =
                {
                    {[](const Timeline &run) { return run.values()["offset"] < 0.0; }},
                    atMost(
                        -10.0, [](const Timeline &run) { return run.values()["offset"]; },
                        Text::tr("set **offset** to −10 or less. It is %1."), 0),
                    {[](const Timeline &run) {
                         return isStill(run) &&
                                std::abs(distance(run, "foot", "body") + run.values()["offset"]) < 0.5;
                     },
                     Text::tr("let time run (**Space**) until the foot lies still on the cross.")},
                },
            .hint = Text::tr("Type −60 into the field beside **Offset**, press **Space**, and wait."),
        },
        {
            .text = Text::tr("Carry the body at least 100 px. The target goes with it."),
            .conditions = {lastGrabbed("body"), draggedAtLeast(100.0)},
            .hint = Text::tr("Press **Space**, take the large disc, and carry it across the picture."),
        },
    };
}

std::vector<Try> radialTries()
{
    return {
        {
            .text = Text::tr(
                "Let the foot go close by on the left of the body, so that it comes to rest there, at "
                "least 20 px to the left."),
            .conditions =
                {
                    released("foot"),
                    allStill(),
                    {[](const Timeline &run) { return footLeftOfBody(run) >= 20.0; },
                     Text::tr("let go closer to the body, on its left: the foot came to rest elsewhere.")},
                },
            .hint =
                Text::tr("Press **Space**. Put the foot just to the left of the body, hold it still for a "
                         "moment, and let go."),
        },
        {
            .text = Text::tr(
                "Hold the foot straight below the body, to within 5°. What is the angle in radians?"),
            .conditions =
                {
                    holding("foot"),
                    atMost(5.0, angleFromBelow,
                           Text::tr("hold it straight below the body. It is off by %1°."), 0),
                    {isHeldStill, Text::tr("hold it still there for a moment.")},
                },
            .hint = Text::tr(
                "Press **Space**. Hold the foot straight below the body, with the mouse button down. "
                "The angle is written beside the arc."),
            .answer = Text::tr("1.57 rad: π / 2, a quarter of a turn. y points down, so the angle of what is "
                               "below is positive."),
        },
        {
            .text = Text::tr("Set **radius** to 120 and wait until the foot is still."),
            .conditions =
                {
                    parameterSetTo("radius", 120.0),
                    restsAtDistance(
                        120.0, Text::tr("let time run (**Space**) until the foot is still on the ring.")),
                },
            .hint = Text::tr("Type 120 into the field beside **Radius**, press **Space**, and wait."),
        },
        {
            .text = Text::tr(
                "Stop inside a frame when the spring has pulled. Find `angle` and `target` in the code."),
            .conditions = {insideFrame(), onlyPulled()},
            .hint =
                Text::tr("Stop with **Space**, and press **Shift+→** once. The code shows what each line has "
                         "found."),
        },
    };
}

}

#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/input_queries.h"
#include "lessons/api/checks/run_queries.h"
#include "lessons/api/creature.h"
#include "lessons/walking_gait/text.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"
#include "view.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace lessons;
using sim::Timeline;

namespace walking_gait {

namespace {

/// Returns how far right of the body the last drag moved foot 0, in px. Minus infinity if it moved another
/// body or is not finished.
double pulledPastBody(const Timeline &run)
{
    const std::optional<DragGesture> drag = lastReleased(run, "foot0");
    double farthest = -std::numeric_limits<double>::infinity();
    for (const PointerSample &sample : drag ? drag->path : std::vector<PointerSample>())
        farthest = std::max(farthest, sample.position.x - positionOf(run, "body").x);
    return farthest;
}

Condition footReleased()
{
    return {[](const Timeline &run) {
        const std::optional<DragGesture> drag = lastReleased(run);
        return drag && drag->body.starts_with("foot");
    }};
}

Condition holdingFoot()
{
    return {[](const Timeline &run) { return heldBody(run).starts_with("foot"); }};
}

/// Returns the number of frames since the last grab. 0 without one.
double framesSinceGrab(const Timeline &run)
{
    const std::vector<DragGesture> all = dragGestures(run);
    return all.empty() ? 0.0 : static_cast<double>(run.cursor().frame - all.back().grabFrame);
}

/// Returns how far the last drag went to one side, in px.
double sidewaysDragDistance(const Timeline &run)
{
    const std::vector<DragGesture> all = dragGestures(run);
    double farthest = 0.0;
    for (const PointerSample &sample : all.empty() ? std::vector<PointerSample>() : all.back().path)
        farthest = std::max(farthest, std::abs(sample.position.x - grabPosition(run, all.back()).x));
    return farthest;
}

/// Returns whether `body` is dragged anywhere in the script.
bool wasDragged(const Timeline &run, const std::string &body)
{
    const std::vector<sim::Event> &input = run.script().input;
    return std::any_of(input.begin(), input.end(), [&](const sim::Event &event) {
        const auto *grab = std::get_if<sim::Grab>(&event.what);
        return grab && grab->body == body;
    });
}

/// Returns the distance of foot 0 from the centre of the circle on which its target moves, in px.
double footDistance(const Timeline &run)
{
    const sim::Vec2 centre = positionOf(run, "body") + sim::Vec2{0.0, run.values()["drop"]};
    return sim::length(positionOf(run, "foot0") - centre);
}

QString hintDragSideways()
{
    return Text::tr("Press **Space**, take the large disc, and carry it slowly to one side of the picture.");
}

Try dragBody100()
{
    return {
        .text = Text::tr("Carry the body at least 100 px. Both feet follow, each on its side."),
        .conditions = {lastGrabbed("body"), draggedAtLeast(100.0)},
        .hint = hintDragSideways(),
    };
}

/// Returns whether any foot is planted.
bool hasPlantedFoot(const Timeline &run)
{
    const sim::Scene &scene = run.track().interval().scene;
    for (int i = 0; i < run.state().pointCount(); ++i) {
        const bool foot = !isBody(scene.names[static_cast<std::size_t>(i)]);
        if (foot && isPlanted(scene, run.state(), run.values(), i))
            return true;
    }
    return false;
}

/// Returns whether a planted foot moves up at 1 px/frame or more: it has just bounced.
bool justBounced(const Timeline &run)
{
    const sim::State &state = run.state();
    for (int i = 0; i + 1 < state.pointCount(); ++i) {
        if (isPlanted(run.track().interval().scene, state, run.values(), i) && state.velocity(i, 1) <= -1.0)
            return true;
    }
    return false;
}

/// Returns whether a dynamic point touches a side wall.
bool touchesWall(const Timeline &run)
{
    const sim::State &state = run.state();
    const Eigen::ArrayXd halfWidth = halfWidths(run.track().interval().scene);
    for (int i = 0; i < state.pointCount(); ++i) {
        const bool right = state.position(i, 0) + halfWidth[i] >= run.values()["right"];
        const bool left = state.position(i, 0) - halfWidth[i] <= run.values()["left"];
        if (state.isDynamic(i) && (left || right))
            return true;
    }
    return false;
}

bool wasKeyPressed(const Timeline &run, bool sim::Keys::*key)
{
    return hasApplied<sim::Key>(run, [&](const sim::Key &event) { return event.key == key && event.down; });
}

bool wasPointerPressed(const Timeline &run)
{
    return hasApplied<sim::Pointer>(run, [](const sim::Pointer &pointer) { return pointer.down; });
}

double clockSpeedOf(const Timeline &run)
{
    return run.state().gaitSpeed[0];
}

/// Returns whether the clock stood still ten frames ago. If it did not, its speed may only be passing through
/// 0 now.
bool stoodStill(const Timeline &run)
{
    constexpr std::int64_t frames = 10;
    return run.cursor().frame >= frames &&
           std::abs(run.track().stateAt(run.cursor().frame - frames).gaitSpeed[0]) <= 0.005;
}

/// Returns the distance of the nearest other body from the body `name`, in px.
double nearestBody(const Timeline &run, const std::string &name)
{
    double nearest = INFINITY;
    for (const std::string &other : run.track().interval().scene.names) {
        if (isBody(other) && other != name)
            nearest = std::min(nearest, distance(run, name, other));
    }
    return nearest;
}

/// Returns how far left of its start the creature is, in px. 0 if it is on the right.
double walkedLeft(const Timeline &run)
{
    const sim::Scene &scene = run.track().interval().scene;
    return std::max(0.0, scene.start.positionOf(scene.find("body")).x - positionOf(run, "body").x);
}

Condition walkedLeft100()
{
    return atLeast(100.0, walkedLeft,
                   Text::tr("let it walk on to 100 px left of where it began. So far: %1 px."), 0);
}

/// Returns the height to which the last finished drag lifted its body, in px.
double liftHeight(const Timeline &run)
{
    const std::optional<DragGesture> drag = lastReleased(run);
    double height = 0.0;
    for (const PointerSample &sample : drag ? drag->path : std::vector<PointerSample>())
        height = std::max(height, grabPosition(run, *drag).y - sample.position.y);
    return height;
}

Condition inTheAir()
{
    return {[](const Timeline &run) { return !hasPlantedFoot(run); },
            Text::tr("stop at a frame in which no foot touches the ground: go there with **→**.")};
}

Condition touchingWall(const QString &todo)
{
    return {touchesWall, todo};
}

/// Returns the distance of the nearest other body from the dragged body, in px.
double nearestToDraggedBody(const Timeline &run)
{
    return nearestBody(run, heldBody(run));
}

Condition closerThanDistance(std::function<double(const Timeline &)> nearest, const QString &todo)
{
    return {[nearest](const Timeline &run) { return nearest(run) < run.values()["distance"]; }, todo, nearest,
            0};
}

}

std::vector<Try> bonesTries()
{
    return {
        {
            .text = Text::tr(
                "Pull foot 0 to the right of the body, 20 px or more past it, let go, and wait until "
                "all is still. Where does it end?"),
            .conditions =
                {
                    released("foot0"),
                    atLeast(
                        20.0, pulledPastBody,
                        Text::tr("pull it 20 px or more past the body, to the right. It came %1 px past it."),
                        0),
                    allStill(),
                },
            .hint =
                Text::tr("Press **Space**. Take the small disc on the left, carry it past the body to the "
                         "right, let go, and wait."),
            .answer = Text::tr("On the left again: its bone has an angle of its own, and the spring pulls it "
                               "to that place from anywhere."),
        },
        dragBody100(),
        {
            .text = Text::tr(
                "Stop inside a frame (**Shift+→**) when the springs have pulled and nothing has moved."),
            .conditions = {insideFrame(), onlyPulled()},
            .hint = Text::tr("Stop, and press **Shift+→** once: the springs come first."),
        },
    };
}

std::vector<Try> legsTries()
{
    return {
        {
            .text = Text::tr("Set **leg** to 100 and wait until all is still. How long are the lines?"),
            .conditions = {parameterSetTo("leg", 100.0), allStill()},
            .hint = Text::tr("Type 100 into the field beside **Leg**, press **Space**, and wait."),
            .answer = Text::tr("100 px: at rest a line is as long as **leg** says."),
        },
        {
            .text = Text::tr(
                "Pull a foot at least 75 px away and let go. The line shows how far the foot swings."),
            .conditions = {footReleased(), draggedAtLeast(75.0)},
            .hint = Text::tr(
                "Press **Space**, take a small disc, pull it to the upper edge of the picture, and let "
                "go."),
        },
    };
}

std::vector<Try> feetBelowTries()
{
    return {
        {
            .text = Text::tr("Set **drop** to 0, as it was before, and wait until all is still."),
            .conditions = {parameterSetTo("drop", 0.0), allStill()},
            .hint = Text::tr("Type 0 into the field beside **Drop**, press **Space**, and wait."),
        },
        {
            .text =
                Text::tr("Set **drop** so that the feet belong above the body, and wait until all is still."),
            .conditions =
                {
                    {[](const Timeline &run) { return run.values()["drop"] < 0.0; }},
                    allStill(),
                },
            .hint = Text::tr("y points down, so above the body is below 0: type −50 beside **Drop**, press "
                             "**Space**, and wait."),
        },
        dragBody100(),
    };
}

std::vector<Try> curvedLegsTries()
{
    return {
        {
            .text = Text::tr("Set **curve** to 0. What do the legs look like?"),
            .conditions = [](const Timeline &run) { return isSetTo(run, "curve", 0.0); },
            .hint = Text::tr("Type 0 into the field beside **Curve**, and look at the legs."),
            .answer = Text::tr("Straight: the point that bends a leg lies on its foot then."),
        },
        {
            .text =
                Text::tr("Carry the body, go back in time, change **curve**, and compare with the ghost: the "
                         "run is the same."),
            .conditions =
                {
                    comparisonDiffers("curve"),
                    {[](const Timeline &run) { return wasDragged(run, "body"); },
                     Text::tr("carry the body first. Then go back in time, and change **curve** there.")},
                    playedSinceFork(),
                },
            .hint = Text::tr(
                "Press **Space**, carry the body, and stop. Drag the timeline back to the left, type "
                "another **Curve**, and play on for a second."),
        },
        {
            .text = Text::tr("Set **curve** below 0."),
            .conditions = [](const Timeline &run) { return run.values()["curve"] < 0.0; },
            .hint = Text::tr("Type −30 into the field beside **Curve**."),
        },
    };
}

std::vector<Try> swingTries()
{
    return {
        {
            .text = Text::tr(
                "Set **speed** to −0.05 for at least 60 frames. Which way do the feet go round now?"),
            .conditions = {parameterSetTo("speed", -0.05), unchangedFor("speed", 60)},
            .hint = Text::tr("Type −0.05 into the field beside **Speed**, press **Space**, and wait three "
                             "seconds."),
            .answer = Text::tr("Anticlockwise: the angle of each foot gets smaller from frame to frame."),
        },
        {
            .text = Text::tr(
                "Find a speed at which a foot goes round more than 150 px from the middle of its places. "
                "Hands off for 120 frames while you measure."),
            .conditions =
                {
                    {[](const Timeline &run) { return !isSetTo(run, "speed", 0.05); }},
                    idleFor(120),
                    atLeast(150.0, footDistance,
                            Text::tr("try another speed. Foot 0 is %1 px from the middle of its places."), 0),
                },
            .hint = Text::tr("A foot goes farthest when the clock turns about as fast as the foot swings by "
                             "itself. Type 0.45 beside **Speed**, press **Space**, and touch nothing."),
        },
        {
            .text = Text::tr(
                "Carry the body at least 100 px to the side. If you do it slowly, it looks like walking."),
            .conditions =
                {
                    lastGrabbed("body"),
                    atLeast(100.0, sidewaysDragDistance,
                            Text::tr("carry it 100 px to the side. It came %1 px."), 0),
                },
            .hint = hintDragSideways(),
        },
    };
}

std::vector<Try> bodyPulledTries()
{
    return {
        {
            .text = Text::tr("Pull a foot at least 75 px away and let go. Now the body comes along."),
            .conditions = {footReleased(), draggedAtLeast(75.0)},
            .hint = Text::tr(
                "Press **Space**, take a small disc, pull it to the upper edge of the picture, and let "
                "go."),
        },
        {
            .text = Text::tr(
                "Set **damping** to 1 and throw the creature, at 5 px per frame or more. After 100 frames "
                "its momentum is what your hand gave it."),
            .conditions = {parameterSetTo("damp", 1.0), releasedSinceSet("damp"), thrownAtLeast(),
                           idleFor(100)},
            .hint = Text::tr(
                "Type 1 into the field beside **Damping**. Press **Space**, take the large disc, swing "
                "it, and let go on the way. Then wait four seconds."),
        },
        {
            .text =
                Text::tr("Hold a foot for 60 frames. It feels nothing, but the body still feels its leg."),
            .conditions =
                {
                    holdingFoot(),
                    atLeast(60.0, framesSinceGrab,
                            Text::tr("hold it for 60 frames while time runs. So far: %1."), 0),
                },
            .hint = Text::tr("Press **Space**, take a small disc, and hold it for two seconds."),
        },
    };
}

std::vector<Try> groundTries()
{
    return {
        {
            .text = Text::tr(
                "Set **speed** to −0.05 and let the creature walk to 100 px left of where it began."),
            .conditions = {parameterSetTo("speed", -0.05), walkedLeft100()},
            .hint = Text::tr("Type −0.05 into the field beside **Speed**, press **Space**, and watch it go."),
        },
        {
            .text = Text::tr("Set **traction** to none for 150 frames: ice. It treads on the spot."),
            .conditions = {parameterSetTo("traction", 1.0), unchangedFor("traction", 150)},
            .hint =
                Text::tr("Play some seconds. Choose **none** beside **Traction**, and wait five seconds."),
        },
        {
            .text = Text::tr("Set **bounce** to 0.8 and stop just when a foot bounces."),
            .conditions =
                {
                    parameterSetTo("bounce", 0.8),
                    {justBounced,
                     Text::tr("stop at a frame in which a foot on the ground moves up, at 1 px per "
                              "frame or more: go there with **→**.")},
                },
            .onlyWhilePaused = true,
            .hint = Text::tr(
                "Type 0.8 into the field beside **Bounce**, and press **Enter**. Go on frame by frame "
                "with **→** until a "
                "foot that was on the ground goes up."),
        },
        {
            .text =
                Text::tr("Lift the body at least 60 px and let go. It lands on its feet and walks on, for 60 "
                         "frames."),
            .conditions =
                {
                    released("body"),
                    atLeast(60.0, liftHeight, Text::tr("lift it 60 px or more. It came %1 px up."), 0),
                    idleFor(60),
                    {hasPlantedFoot, Text::tr("let it walk on until a foot stands on the ground.")},
                },
            .hint = Text::tr(
                "Press **Space**, take the large disc, lift it near to the upper edge of the picture, "
                "let go, "
                "and wait two seconds."),
        },
    };
}

std::vector<Try> moreFeetTries()
{
    return {
        {
            .text = Text::tr(
                "Set **feet** to 12 and watch for 200 frames. How much does the body go up and down?"),
            .conditions = {parameterSetTo("feet", 12.0), unchangedFor("feet", 200)},
            .hint =
                Text::tr("Type 12 into the field beside **Feet**, press **Space**, and wait seven seconds."),
            .answer = Text::tr("By less than 1 px: some foot is always on its way down."),
        },
        {
            .text =
                Text::tr("Set **spread** to 0 for 200 frames. All feet step together: does it get anywhere?"),
            .conditions = {parameterSetTo("spread", 0.0), unchangedFor("spread", 200)},
            .hint =
                Text::tr("Type 0 into the field beside **Spread**, press **Space**, and wait seven seconds."),
            .answer = Text::tr("No. The body falls and rises and goes to and fro, but it gets nowhere."),
        },
        {
            .text =
                Text::tr("Set **speed** to 0.3, play 60 frames, and stop when no foot touches the ground."),
            .conditions =
                {
                    parameterSetTo("speed", 0.3),
                    parameterSetTo("spread", 360.0, Text::tr("set **spread** back to 360°.")),
                    parameterSetTo("feet", 5.0, Text::tr("set **feet** back to 5.")),
                    unchangedFor("speed", 60),
                    inTheAir(),
                },
            .onlyWhilePaused = true,
            .hint =
                Text::tr("Press **Reset all**. Type 0.3 into the field beside **Speed**. Play three seconds "
                         "and stop. Go on frame by "
                         "frame with **→** until all feet are in the air."),
        },
    };
}

std::vector<Try> steeringTries()
{
    return {
        {
            .text = Text::tr(
                "Hold the **←** key until the creature walks to the left, and let it walk to 100 px left of "
                "where it began."),
            .conditions =
                {
                    {[](const Timeline &run) { return wasKeyPressed(run, &sim::Keys::left); }},
                    {[](const Timeline &run) { return clockSpeedOf(run) < 0.0; },
                     Text::tr(
                         "hold **←** longer, until the clock’s speed is below 0. It is %1 rad per frame."),
                     clockSpeedOf, 3},
                    walkedLeft100(),
                },
            .hint =
                Text::tr("Click the picture, press **Space**, and hold **←** for two seconds. Let go when it "
                         "walks to the left, and watch."),
        },
        {
            .text = Text::tr(
                "Make it as fast as it can with the pointer: hold the button at least 200 px away from it."),
            .conditions =
                {
                    {[](const Timeline &run) { return wasPointerPressed(run) && run.values()["top"] > 0.0; }},
                    {[](const Timeline &run) { return std::abs(clockSpeedOf(run)) >= run.values()["top"]; },
                     Text::tr("hold the button 200 px or more to the left or right of it, while time runs. "
                              "The clock’s "
                              "speed is %1 rad per frame."),
                     clockSpeedOf, 3},
                },
            .hint = Text::tr(
                "Press **Space**. Press the mouse button in the picture, and with the button down go "
                "far to the "
                "left or right, past the edge of the picture if need be."),
        },
        {
            .text = Text::tr("Make it stand: bring the clock to within 0.005 rad/frame of 0."),
            .conditions =
                {
                    {[](const Timeline &run) {
                        return wasPointerPressed(run) || wasKeyPressed(run, &sim::Keys::left) ||
                               wasKeyPressed(run, &sim::Keys::right);
                    }},
                    {[](const Timeline &run) { return std::abs(clockSpeedOf(run)) <= 0.005; },
                     Text::tr("bring the clock’s speed to 0. It is %1 rad per frame."), clockSpeedOf, 3},
                    {stoodStill, Text::tr("let it stand for ten frames.")},
                },
            .hint = Text::tr(
                "Press **Space** and hold **←** until its legs hardly move. Or press the mouse button "
                "far off, and with the button down go straight above or below the body."),
        },
    };
}

std::vector<Try> wallsTries()
{
    return {
        {
            .text = Text::tr(
                "Set **at wall** to *walk on* and let it walk against a wall, for 200 frames in all."),
            .conditions =
                {
                    parameterSetTo("at_wall", 1.0),
                    unchangedFor("at_wall", 200),
                    touchingWall(Text::tr("let it walk on until it touches a wall.")),
                },
            .hint = Text::tr(
                "Choose **walk on** beside **At a wall**, press **Space**, and wait until it has walked "
                "against a wall for a while."),
        },
        {
            .text = Text::tr("Put the walls 150 px apart or closer, and see it turn to the left."),
            .conditions =
                {
                    {[](const Timeline &run) {
                        return run.values()["right"] - run.values()["left"] <= 150.0;
                    }},
                    parameterSetTo("at_wall", 0.0, Text::tr("choose **turn** beside **At a wall**.")),
                    {[](const Timeline &run) { return clockSpeedOf(run) < 0.0; },
                     Text::tr("let time run (**Space**) until it turns.")},
                },
            .hint =
                Text::tr("Choose **turn** beside **At a wall**. Type 200 beside **Left wall** and 340 beside "
                         "**Right wall**, press **Space**, and "
                         "wait until it turns."),
        },
        {
            .text = Text::tr("Throw the creature into a wall, so that it gets there within 40 frames."),
            .conditions =
                {
                    released(),
                    thrownAtLeast(),
                    {[](const Timeline &run) { return idleFrames(run) <= 40 && touchesWall(run); },
                     Text::tr("throw it harder or closer to a wall: it has to get there within 40 frames.")},
                },
            .hint =
                Text::tr("Press **Space**, take the large disc, swing it towards a wall, and let go on the "
                         "way."),
        },
    };
}

std::vector<Try> companyTries()
{
    return {
        {
            .text = Text::tr(
                "Take one creature by its body and drag it at least 40 px, into another. Both feel the "
                "push; the one in your hand cannot move."),
            .conditions =
                {
                    {[](const Timeline &run) { return isBody(heldBody(run)); }},
                    draggedAtLeast(40.0),
                    closerThanDistance(nearestToDraggedBody,
                                       Text::tr("drag it into another. The nearest body is %1 px away.")),
                },
            .hint =
                Text::tr("Press **Space**, take the large disc of one creature, and carry it onto the other "
                         "one."),
        },
        {
            .text =
                Text::tr("Set **felt by** to one, and look at the sum of the pushes while two bodies touch."),
            .conditions =
                {
                    parameterSetTo("felt_by", 1.0),
                    closerThanDistance(
                        [](const Timeline &run) { return nearestBody(run, "creature0.body"); },
                        Text::tr("let time run (**Space**) until two bodies touch. They are %1 px apart.")),
                },
            .hint = Text::tr("Choose **one** beside **Felt by**, press **Space**, and wait until two bodies "
                             "touch."),
        },
        {
            .text = Text::tr("Set **creatures** to 5 and watch the crowd for 300 frames."),
            .conditions = {parameterSetTo("creatures", 5.0), unchangedFor("creatures", 300)},
            .hint = Text::tr(
                "Type 5 into the field beside **Creatures**, press **Space**, and wait ten seconds."),
        },
    };
}

}

#include "checks.h"

#include "lessons/api/checks/run_queries.h"
#include "lessons/swaying_tree/text.h"
#include "scenes.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"
#include "view.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace swaying_tree {

namespace {

const sim::Scene &sceneOf(const Timeline &run)
{
    return run.track().interval().scene;
}

double currentBend(const Timeline &run)
{
    return largestBend(sceneOf(run), run.state());
}

/// Returns the angle of the trunk from straight up, in degrees.
double trunkAngle(const Timeline &run)
{
    return bendOf(sceneOf(run), run.state(), 0);
}

bool isBlowing(const Timeline &run)
{
    return run.state().input.pointerDown;
}

/// Returns whether the published formula is chosen at the cursor.
bool isPublished(const Timeline &run)
{
    return formulaOf(run.values()) == sim::TreeFormula::published;
}

/// Returns the number of frames since the button was last pressed or released, up to the cursor. -1 before
/// the first pointer event.
std::int64_t framesSinceButton(const Timeline &run)
{
    std::int64_t since = -1;
    bool down = false;
    for (const sim::Event &event : run.script().input) {
        const auto *pointer = std::get_if<sim::Pointer>(&event.what);
        if (event.frame > run.cursor().frame || !pointer)
            continue;
        if (since < 0 || pointer->down != down)
            since = event.frame;
        down = pointer->down;
    }
    return since < 0 ? -1 : run.cursor().frame - since;
}

/// Returns the state just before the last release of the button. Empty while the button is down and before a
/// release.
std::optional<sim::State> stateBeforeRelease(const Timeline &run)
{
    const std::int64_t since = framesSinceButton(run);
    if (since < 0 || isBlowing(run) || run.cursor().frame - since < 1)
        return {};
    return run.track().stateAt(run.cursor().frame - since - 1);
}

/// Returns the largest angle between a branch and the direction to the pointer, in degrees.
double largestAimError(const Timeline &run)
{
    const sim::State &state = run.state();
    const sim::Vec2 pointer = state.input.pointer.value_or(sim::Vec2{});
    double worst = 0.0;
    for (int i = 0; i < state.pointCount(); ++i) {
        const sim::Vec2 toPointer = pointer - state.positionOf(i);
        const double angle = std::atan2(toPointer.y, toPointer.x) * sim::degreesPerRadian;
        worst = std::max(worst, std::abs(std::remainder(state.angle[i] - angle, 360.0)));
    }
    return worst;
}

/// Returns the largest bend just before the last release of the button, in degrees. 0 without one.
double bendBeforeRelease(const Timeline &run)
{
    const std::optional<sim::State> state = stateBeforeRelease(run);
    return state ? largestBend(sceneOf(run), *state) : 0.0;
}

Condition blowing()
{
    return {isBlowing, Text::tr("hold the mouse button down in the picture.")};
}

Condition windReleased()
{
    return {[](const Timeline &run) { return stateBeforeRelease(run).has_value(); },
            Text::tr("hold the mouse button down beside the tree, and let go.")};
}

/// The button has been released since the parameter `id` was set last.
Condition windReleasedSinceSet(const std::string &id)
{
    return {[id](const Timeline &run) {
                return stateBeforeRelease(run) &&
                       run.cursor().frame - framesSinceButton(run) >= lastSetFrame(run, id);
            },
            windReleased().todo};
}

Condition unchangedButtonFor(std::int64_t frames)
{
    return atLeast(
        static_cast<double>(frames),
        [](const Timeline &run) { return static_cast<double>(framesSinceButton(run)); },
        Text::tr("go on blowing while time runs. So far: %1 frames of %2.")
            .replace(QStringLiteral("%2"), QString::number(frames)),
        0);
}

Condition pointingAtPointer()
{
    return atMost(1.0, largestAimError,
                  Text::tr("hold still while time runs (**Space**). Some branch is off by %1°."), 0);
}

Condition trunkLeans(double min)
{
    return atLeast(
        min, [](const Timeline &run) { return std::abs(trunkAngle(run)); },
        Text::tr("go on until the trunk leans by more than %2°. Now: %1°.")
            .replace(QStringLiteral("%2"), QString::number(min)),
        0);
}

Conditions returned(const Condition &first, const Condition &released)
{
    return {
        first, released,
        atLeast(60.0, bendBeforeRelease,
                Text::tr("bend a branch by more than 60° before you let go. It was %1°."), 0),
        atMost(1.0, currentBend,
               Text::tr("let time run (**Space**) until all are back within 1°. Some branch is off by %1°."),
               0)};
}

Condition easeIs30()
{
    return parameterSetTo("ease", 30.0, Text::tr("set **ease** to 30."));
}

/// Returns the branch whose end is nearest to the pointer.
int branchAtPointer(const Timeline &run)
{
    return nearestBranch(sceneOf(run), run.state(), run.state().input.pointer.value_or(sim::Vec2{}));
}

double pointerToBranch(const Timeline &run)
{
    const sim::Vec2 end = endOf(sceneOf(run), run.state(), branchAtPointer(run));
    return sim::length(end - run.state().input.pointer.value_or(sim::Vec2{}));
}

double bendAtPointer(const Timeline &run)
{
    return std::abs(bendOf(sceneOf(run), run.state(), branchAtPointer(run)));
}

/// Returns the smallest and the largest distance from the pointer to the end of a branch, in px.
std::pair<double, double> distances(const Timeline &run)
{
    double min = 1e9, max = 0.0;
    for (int i = 0; i < run.state().pointCount(); ++i) {
        const double distance = sim::length(endOf(sceneOf(run), run.state(), i) - *run.state().input.pointer);
        min = std::min(min, distance);
        max = std::max(max, distance);
    }
    return {min, max};
}

Condition otherTree()
{
    return {[](const Timeline &run) { return !isSetTo(run, "spread", 30.0) && run.cursor().frame > 0; }};
}

Try anotherTree(const QString &hint)
{
    return {
        .text = Text::tr(
            "Choose another tree from the gallery and blow at it, until a branch is bent by more than "
            "10°."),
        .conditions = {otherTree(), blowing(),
                       atLeast(10.0, currentBend,
                               Text::tr("blow on while time runs. The most that a branch is bent: %1°."), 0)},
        .hint = hint,
    };
}

/// The run is compared with one by the other formula, and the wind blows.
Conditions comparesFormulas()
{
    return {
        comparisonDiffers("formula"),
        {isBlowing, Text::tr("go back farther, to where you were still blowing, and choose it there.")},
        playedSinceFork(),
    };
}

/// Returns whether the trunk leans towards the pointer, from which the wind came.
bool swungPast(const Timeline &run)
{
    if (isBlowing(run) || std::abs(trunkAngle(run)) < 0.5)
        return false;
    const double fromLeft = run.state().positionOf(0).x - run.state().input.pointer->x;
    return trunkAngle(run) * fromLeft < 0.0;
}

/// Returns whether the gust has reached some branches, but not all.
bool isGustArriving(const Timeline &run)
{
    const auto [min, max] = distances(run);
    return run.state().gustExtent.front > min && run.state().gustExtent.front < max;
}

}

std::vector<Try> trunkTries()
{
    return {
        {
            .text = Text::tr("Switch **Formula** to published. Find its 0.0116 px in the code: the x of "
                             "`end` is no longer "
                             "275."),
            .conditions = [](const Timeline &run) { return isPublished(run); },
            .hint = Text::tr(
                "Choose **published** beside **Formula**, and press **→**. Then rest the pointer on `end` "
                "in the code."),
        },
        {
            .text = Text::tr("Make the trunk half as high as the stage: set **trunk length** to 200."),
            .conditions = [](const Timeline &run) { return isSetTo(run, "base_length", 200.0); },
            .hint = Text::tr("Type 200 into the field beside **Trunk length**."),
        },
    };
}

std::vector<Try> branchesTries()
{
    return {
        {
            .text = Text::tr("Set **spread** to 90°. Which way do the branches of every second level point?"),
            .conditions = [](const Timeline &run) { return isSetTo(run, "spread", 90.0); },
            .hint = Text::tr("Type 90 into the field beside **Spread**."),
            .answer = Text::tr("Straight up and down. Those of the levels between point left and right."),
        },
        {
            .text = Text::tr("Set **slope** to 0.7. How many levels are left, and how many branches?"),
            .conditions = [](const Timeline &run) { return isSetTo(run, "slope", 0.7); },
            .hint =
                Text::tr("Type 0.7 into the field beside **Slope**. The number of branches stands above the "
                         "parameters."),
            .answer =
                Text::tr("5 levels with 1 + 2 + 4 + 8 + 16 = 31 branches: at the next level they would be "
                         "0.17 of the trunk, less than 0.2."),
        },
        {
            .text = Text::tr("Make a tree with just three branches: raise **smallest branch**."),
            .conditions =
                {
                    {[](const Timeline &run) { return !isSetTo(run, "min_scale", 0.2); }},
                    {[](const Timeline &run) { return run.state().pointCount() == 3; },
                     Text::tr("make it three branches. This tree has %1."),
                     [](const Timeline &run) { return static_cast<double>(run.state().pointCount()); }, 0},
                },
            .hint =
                Text::tr("The children of the trunk are 0.8 (or 0.7) as large, and their children 0.64 (or "
                         "0.49). Type "
                         "0.65 beside **Smallest branch**."),
        },
    };
}

std::vector<Try> randomnessTries()
{
    return {
        {
            .text = Text::tr("Set **jitter** to 0, and the tree of the step before is back."),
            .conditions = [](const Timeline &run) { return isSetTo(run, "jitter", 0.0); },
            .hint = Text::tr("Type 0 into the field beside **Jitter**."),
        },
        {
            .text = Text::tr("Set **jitter** to 60°. Is it still a tree?"),
            .conditions = [](const Timeline &run) { return isSetTo(run, "jitter", 60.0); },
            .hint = Text::tr("Type 60 into the field beside **Jitter**."),
            .answer = Text::tr("Hardly: chance turns branches farther than they spread, so some grow back "
                               "towards the ground."),
        },
        {
            .text =
                Text::tr("Choose a tree from the gallery, or make one of your own with another **spread**."),
            .conditions = [](const Timeline &run) { return !isSetTo(run, "spread", 30.0); },
            .hint = Text::tr(
                "Above the parameters, press **Presets** and choose a picture. Or type another number "
                "beside **Spread**."),
        },
    };
}

std::vector<Try> towardsPointerTries()
{
    return {
        {
            .text = Text::tr("Hold the button down beside the tree. Every branch points at you."),
            .conditions =
                {
                    blowing(),
                    {[](const Timeline &run) { return !isPublished(run); },
                     Text::tr("set **Formula** to corrected.")},
                    pointingAtPointer(),
                },
            .hint =
                Text::tr("Press **Space**. Put the pointer into the picture beside the tree, hold the mouse "
                         "button down, and keep still."),
        },
        {
            .text = Text::tr(
                "Do the same with **Formula** set to published, and hold still. Count the frames until the "
                "whole tree points at you."),
            .conditions = {{isPublished}, blowing(), pointingAtPointer()},
            .hint = Text::tr(
                "Choose **published** beside **Formula**. Then hold the mouse button down beside the "
                "tree and count."),
        },
        {
            .text = Text::tr(
                "Hold the button down low beside the trunk, then let go. Does the tree get up again?"),
            .conditions =
                {
                    windReleased(),
                    atLeast(
                        45.0, [](const Timeline &run) { return std::abs(trunkAngle(run)); },
                        Text::tr(
                            "hold the button lower, so that the trunk leans by more than 45°. Yours leans by "
                            "%1°."),
                        0),
                },
            .hint = Text::tr(
                "Press **Space**. Hold the mouse button down near the ground, right of the trunk, for "
                "a moment, and let go."),
            .answer = Text::tr("No. Nothing turns a branch back: it stays as it was turned last."),
        },
    };
}

std::vector<Try> windTries()
{
    return {
        {
            .text = Text::tr("Blow until the trunk leans by more than 60°."),
            .conditions = {blowing(), trunkLeans(60.0)},
            .hint = Text::tr(
                "Press **Space**. Hold the mouse button down low in the left or right corner for two "
                "seconds."),
        },
        {
            .text =
                Text::tr("Set **ease** to 30 and blow for ten frames. With 2 the tree turns much faster."),
            .conditions = {easeIs30(), blowing(), unchangedButtonFor(10)},
            .hint =
                Text::tr("Press **Home**. Type 2 beside **Ease**, press **Space**, and hold the mouse button "
                         "down for a second. "
                         "Then type 30 beside **Ease**, and hold it again."),
        },
        {
            .text = Text::tr("Blow from close by. Go back a few frames, set **Formula** to published, and "
                             "play on: the ghost is the wind as meant."),
            .conditions = comparesFormulas(),
            .hint = Text::tr(
                "Press **Home**, then **Space**, and hold the mouse button down close to the tree for "
                "two seconds. Stop, drag the timeline back by twenty frames, choose **published** beside "
                "**Formula**, and play on."),
        },
    };
}

std::vector<Try> restTries()
{
    return {
        {
            .text = Text::tr(
                "Bend a branch by more than 60°, let go, and count the frames until all are back within "
                "1°."),
            .conditions = returned(windReleased(), windReleased()),
            .hint = Text::tr(
                "Press **Space**. Hold the mouse button down at the foot of the trunk for two seconds, "
                "let go, and wait."),
        },
        {
            .text = Text::tr("Do the same with **ease** at 30. How much longer does it take?"),
            .conditions = returned(easeIs30(), windReleasedSinceSet("ease")),
            .hint = Text::tr(
                "Type 30 into the field beside **Ease**. Hold the mouse button down at the foot of the "
                "trunk for seven seconds, let go, and wait."),
            .answer =
                Text::tr("About four times as long: each frame takes a thirtieth of the way that is left, "
                         "not an eighth."),
        },
        {
            .text = Text::tr(
                "Stop inside a frame (**Shift+→**) when the tree has returned and the wind has not bent it "
                "yet."),
            .conditions =
                {
                    insideFrame(),
                    blowing(),
                    {[](const Timeline &run) {
                         const sim::Phase *last = lastPhase(run);
                         return last && last->kind == sim::EffectKind::spring;
                     },
                     Text::tr("press **Shift+→** until the return is the last phase that was done.")},
                    {[](const Timeline &run) { return currentBend(run) > 1.0; },
                     Text::tr("blow for a while first: nothing is bent by more than 1°.")},
                },
            .hint = Text::tr(
                "Press **Space** and hold the mouse button down beside the tree. With the button down, "
                "press **Space** to stop, and then **Shift+→** until the tree has returned."),
        },
    };
}

std::vector<Try> distanceTries()
{
    return {
        {
            .text = Text::tr("Blow at a twig from less than 20 px until it is bent by more than 30°."),
            .conditions =
                {
                    blowing(),
                    atMost(20.0, pointerToBranch,
                           Text::tr("blow from less than 20 px from the end of a twig. It is %1 px."), 0),
                    atLeast(30.0, bendAtPointer, Text::tr("follow the twig. It is bent by %1°."), 0),
                },
            .hint = Text::tr(
                "Press **Space**. Hold the mouse button down right at the end of a twig, and follow the "
                "twig."),
        },
        {
            .text = Text::tr(
                "Now from far away, for example from a corner, for 60 frames: nothing bends by more than "
                "15°."),
            .conditions =
                {
                    blowing(),
                    unchangedButtonFor(60),
                    atMost(15.0, currentBend, Text::tr("blow from farther away. Some branch is bent by %1°."),
                           0),
                },
            .hint = Text::tr(
                "Press **Space**, and hold the mouse button down in an upper corner of the picture for "
                "three seconds."),
        },
        {
            .text =
                Text::tr("While you blow, go back a few frames, set **Formula** to published, and play on. "
                         "Which tree bends more?"),
            .conditions = comparesFormulas(),
            .hint = Text::tr(
                "Press **Space** and hold the mouse button down for two seconds. Stop, drag the timeline "
                "back by twenty frames, choose **published** beside **Formula**, and play on."),
            .answer = Text::tr("The corrected one. In the published formula the same distance counts twice "
                               "for a branch half as large."),
        },
    };
}

std::vector<Try> thicknessTries()
{
    return {
        {
            .text = Text::tr(
                "Blow until some twig is bent by more than 20°, and twenty times as far as the trunk."),
            .conditions =
                {
                    blowing(),
                    atLeast(20.0, currentBend,
                            Text::tr("blow from closer. The most that a twig is bent: %1°."), 0),
                    atLeast(
                        20.0,
                        [](const Timeline &run) {
                            return currentBend(run) / std::max(1e-9, std::abs(trunkAngle(run)));
                        },
                        Text::tr(
                            "blow at a twig far from the trunk. It is bent %1 times as far as the trunk."),
                        0),
                },
            .hint =
                Text::tr("Press **Space**, and hold the mouse button down left of the crown for a second."),
        },
        {
            .text = Text::tr("Set **wind** to 20 and lean the trunk by 10°."),
            .conditions = {parameterSetTo("wind", 20.0), blowing(), trunkLeans(10.0)},
            .hint =
                Text::tr("Type 20 into the field beside **Wind**. Press **Space**, and hold the mouse button "
                         "down close beside the trunk for two seconds."),
        },
        {
            .text =
                Text::tr("While you blow from close by, go back a few frames, set **Formula** to published, "
                         "and play on. Which twigs quiver?"),
            .conditions = comparesFormulas(),
            .hint = Text::tr(
                "Press **Home**, then **Space**, and hold the mouse button down on a twig in the crown for "
                "two seconds. Stop, drag the timeline back by twenty frames, choose **published** beside "
                "**Formula**, and play on."),
            .answer =
                Text::tr("The twigs of the published formula that are close to you: a frame turns them past "
                         "the wind, the next one back."),
        },
    };
}

std::vector<Try> turbulenceTries()
{
    return {
        {
            .text = Text::tr("Hold the button for 60 frames and watch the twigs, then the trunk."),
            .conditions = {blowing(), unchangedButtonFor(60)},
            .hint = Text::tr("Press **Space**, and hold the mouse button down left of the crown for three "
                             "seconds."),
        },
        {
            .text =
                Text::tr("Go back to where your wind began, set **turbulence** to 0, and play on. The ghost "
                         "trembles, the tree does not."),
            .conditions =
                {
                    comparisonDiffers("turbulence"),
                    parameterSetTo("turbulence", 0.0, Text::tr("set **turbulence** to 0 there.")),
                    blowing(),
                    playedSinceFork(),
                },
            .hint =
                Text::tr("Hold the mouse button down for two seconds while it plays, and stop. Drag the "
                         "timeline back to soon after the wind began, type 0 beside **Turbulence**, and play "
                         "on."),
        },
        anotherTree(
            Text::tr("Above the parameters, press **Presets** and choose a picture. Press **Space** and hold "
                     "the mouse button down close to the tree.")),
    };
}

std::vector<Try> realSwayTries()
{
    return {
        {
            .text = Text::tr(
                "Blow, let go, and watch: the trunk swings past its rest, towards where the wind came from."),
            .conditions =
                {
                    windReleased(),
                    {swungPast, Text::tr("let time run (**Space**) until the trunk swings past its "
                                         "rest, by 0.5° or more. If it does not, blow harder.")},
                },
            .hint = Text::tr(
                "Press **Space**. Hold the mouse button down left of the tree for two seconds, let go, "
                "and wait."),
        },
        {
            .text = Text::tr(
                "Hold the button at the left edge and stop (**Space**) when the gust has reached some "
                "branches, but not all."),
            .conditions =
                {
                    blowing(),
                    {isGustArriving, Text::tr("stop when the gust has reached some branches, but not all. "
                                              "Hold the button at the left "
                                              "edge, and press **Space** earlier or later.")},
                },
            .onlyWhilePaused = true,
            .hint =
                Text::tr("Press **Space**, and press the mouse button at the left edge. Half a second later, "
                         "with the button down, press **Space** again."),
        },
        {
            .text = Text::tr(
                "Set **damping** to 1, blow, and let go. After 300 frames it still sways: look at the "
                "energy."),
            .conditions =
                {
                    parameterSetTo("damp", 1.0),
                    windReleasedSinceSet("damp"),
                    atLeast(
                        300.0,
                        [](const Timeline &run) { return static_cast<double>(framesSinceButton(run)); },
                        Text::tr("hands off, and let time run for 300 frames. So far: %1."), 0),
                    {[](const Timeline &run) { return currentBend(run) > 1.0; },
                     Text::tr("blow harder: nothing is bent by more than 1°.")},
                },
            .hint = Text::tr(
                "Type 1 into the field beside **Damping**. Press **Space**, hold the mouse button down "
                "for a second, let go, and wait ten seconds."),
        },
        anotherTree(
            Text::tr("Above the parameters, press **Presets** and choose a picture. Press **Space** and hold "
                     "the mouse button down left of the tree for two seconds.")),
    };
}

}

#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/input_queries.h"
#include "lessons/api/checks/run_queries.h"
#include "lessons/codeling/text.h"
#include "scenes.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace codeling {

namespace {

/// Returns whether a click has set a target, up to the cursor.
bool hasClicked(const Timeline &run)
{
    return hasApplied<sim::Target>(run, [](const sim::Target &) { return true; });
}

/// Returns whether a click has set a target after the parameter `id` was set last.
bool hasClickedSinceSet(const Timeline &run, const std::string &id)
{
    return hasClicked(run) && hasInputFrom<sim::Target>(run, lastSetFrame(run, id));
}

/// Returns the number of frames since the last click.
double framesSinceClick(const Timeline &run)
{
    std::int64_t last = 0;
    for (const sim::Event &event : run.script().input) {
        if (std::holds_alternative<sim::Target>(event.what) &&
            event.frame <= run.cursor().frame + run.track().framesPerOutput())
            last = std::max(last, event.frame);
    }
    return static_cast<double>(run.cursor().frame - last);
}

sim::Vec2 toTarget(const Timeline &run)
{
    return run.state().input.target - run.state().positionOf(lead);
}

/// Returns the distance of the last click from the lead's position at that time, in px. 0 without a click.
double clickDistance(const Timeline &run)
{
    std::optional<double> distance;
    for (const sim::Event &event : run.script().input) {
        const auto *target = std::get_if<sim::Target>(&event.what);
        if (!target || event.frame > run.cursor().frame + run.track().framesPerOutput())
            continue;
        const std::int64_t before = std::clamp<std::int64_t>(event.frame - 1, 0, run.cursor().frame);
        distance = sim::length(target->at - run.track().stateAt(before).positionOf(lead));
    }
    return distance.value_or(0.0);
}

Condition clicked()
{
    return {hasClicked, Text::tr("click the background.")};
}

Condition clickedSinceSet(const std::string &id)
{
    return {[id](const Timeline &run) { return hasClickedSinceSet(run, id); }, clicked().todo};
}

Condition arrived()
{
    return {[](const Timeline &run) { return sim::length(toTarget(run)) < 1.0 && isStill(run); },
            Text::tr("let time run (**Space**) until it lies still at its target.")};
}

/// Returns the speed at which the lead moves away from its target, in px/frame.
double retreatSpeed(const Timeline &run)
{
    const sim::Vec2 v = run.state().velocityOf(lead), offset = toTarget(run);
    return -dot(v, offset) / std::max(1.0, sim::length(offset));
}

Condition backsUp()
{
    return atLeast(3.0, retreatSpeed,
                   Text::tr("click farther away: it has to back up at 3 px per frame or more. Now: %1."));
}

double spineLength(const Timeline &run)
{
    return distance(run, "lead", "tail");
}

double bodyWidth(const Timeline &run)
{
    return distance(run, "side0", "side1");
}

double tailRightOfLead(const Timeline &run)
{
    return positionOf(run, "tail").x - positionOf(run, "lead").x;
}

/// Returns by how much the tail is farther from the lead than the rest length, in px. 0 if it is nearer.
double tailExcess(const Timeline &run)
{
    return std::max(0.0, spineLength(run) - run.values()["rest_length"]);
}

/// Returns the speed of the fastest point of a tentacle, in px/frame.
double maxTentacleSpeed(const Timeline &run)
{
    const auto &v = run.state().velocity;
    const Eigen::Index count = v.rows() - firstOfTentacles;
    return count > 0 ? v.bottomRows(count).matrix().rowwise().norm().maxCoeff() : 0.0;
}

}

std::vector<Try> motorTries()
{
    return {
        {
            .text = Text::tr("Click at least 100 px away, and wait until it has arrived."),
            .conditions =
                {
                    clicked(),
                    atLeast(100.0, clickDistance, Text::tr("click 100 px away or more. That was %1 px."), 0),
                    arrived(),
                },
            .hint = Text::tr("Press **Space**, and click the background near the edge of the picture. Then "
                             "wait."),
        },
        {
            .text = Text::tr(
                "Take the lead in your hand and throw it, at 5 px per frame or more. It comes back."),
            .conditions = {released("lead"), thrownAtLeast(), arrived()},
            .hint = Text::tr(
                "Press **Space**. Take the head (the lead), swing it quickly, let go on the way, and "
                "wait."),
        },
        {
            .text = Text::tr("Set **keep** to 1 and click somewhere else. After 100 frames it still swings."),
            .conditions =
                {
                    parameterSetTo("keep", 1.0),
                    clickedSinceSet("keep"),
                    {[](const Timeline &run) { return run.cursor().phase == 0 && !isStill(run); },
                     Text::tr("click somewhere else: it stands still.")},
                    atLeast(100.0, framesSinceClick,
                            Text::tr("let time run for 100 frames after the click. So far: %1."), 0),
                },
            .hint =
                Text::tr("Type 1 into the field beside **Keep**. Press **Space**, click the background, and "
                         "wait four seconds."),
        },
    };
}

std::vector<Try> orientationTries()
{
    return {
        {
            .text = Text::tr(
                "Send it to places so that it turns round: the tail at least 30 px to the right of the "
                "lead."),
            .conditions =
                {
                    clicked(),
                    atLeast(30.0, tailRightOfLead,
                            Text::tr("send it to the left. The tail is %1 px to the right of the lead."), 0),
                },
            .hint = Text::tr(
                "Press **Space**. Click far up in the picture, and when it is under way, click far to "
                "the left."),
        },
        {
            .text = Text::tr("Pull it at least 75 px away by its tail, let go, and wait until it is back."),
            .conditions = {released("tail"), draggedAtLeast(75.0), arrived()},
            .hint =
                Text::tr("Press **Space**. Take the tail, carry it across the picture, let go, and wait."),
        },
        {
            .text =
                Text::tr("Stop inside a frame when the lead has moved, and the tail is 5 px too far away."),
            .conditions =
                {
                    insideFrame(),
                    {[](const Timeline &run) { return hasMoved(run); },
                     Text::tr("press **Shift+→** until the lead has moved.")},
                    atLeast(
                        5.0, tailExcess,
                        Text::tr(
                            "stop while it is fast: click far away first. The tail is %1 px too far away.")),
                },
            .hint =
                Text::tr("Stop. Click the background far off, on the side away from its tail, and go on with "
                         "**→** until it is "
                         "fast. Then press **Shift+→** until the strip under the timeline marks the move."),
        },
    };
}

std::vector<Try> anticipationTries()
{
    return {
        {
            .text = Text::tr(
                "Click far away, and stop inside a frame right after the anticipation, when it backs up at "
                "3 px per "
                "frame or more."),
            .conditions =
                {
                    clicked(),
                    insideFrame(),
                    {[](const Timeline &run) {
                         const sim::Phase *last = lastPhase(run);
                         return last && last->kind == sim::EffectKind::driver;
                     },
                     Text::tr("press **Shift+→** until the anticipation is the last phase that was done.")},
                    backsUp(),
                },
            .hint =
                Text::tr("Stop. Click the background far from the creature, and press **Shift+→** until the "
                         "strip under the timeline marks the anticipation."),
        },
        {
            .text = Text::tr("Set **anticipation** to 0.6 and click far away. It winds up like a spring."),
            .conditions = {parameterSetTo("anticipation", 0.6), clicked(), backsUp()},
            .hint = Text::tr("Type 0.6 into the field beside **Anticipation**. Press **Space** and click far "
                             "away."),
        },
        {
            .text = Text::tr(
                "Go back in time to before a click, change **anticipation**, and compare with the ghost."),
            .conditions =
                {
                    comparisonDiffers("anticipation"),
                    {[](const Timeline &run) { return hasInputFrom<sim::Target>(run, run.forkFrame() + 1); },
                     Text::tr("go back to before a click, and change **anticipation** there.")},
                    playedSinceFork(),
                },
            .hint =
                Text::tr("Play, click the background, and stop. Drag the timeline back to before the click, "
                         "type another **Anticipation**, and play on for half a second."),
        },
    };
}

std::vector<Try> squashStretchTries()
{
    return {
        {
            .text = Text::tr("Send it so far that its spine gets 55 px long."),
            .conditions =
                {
                    clicked(),
                    atLeast(55.0, spineLength, Text::tr("send it farther. Its spine is %1 px long."), 0),
                },
            .hint =
                Text::tr("Press **Space**, and click the background in the corner that is farthest away."),
        },
        {
            .text = Text::tr("Send it where it looks, so that it is squashed to 32 px before it starts."),
            .conditions =
                {
                    clicked(),
                    atMost(32.0, spineLength,
                           Text::tr("send it far away, to where it looks. Its spine is %1 px long."), 0),
                },
            .hint = Text::tr(
                "Press **Space**. It looks to the right at the start: click the background far to the "
                "right, at the same height."),
        },
        {
            .text = Text::tr("Go back in time, set **soft** to 1, and compare with the ghost."),
            .conditions =
                {
                    comparisonDiffers("soft"),
                    parameterSetTo("soft", 1.0, Text::tr("set **soft** to 1 there.")),
                    playedSinceFork(),
                },
            .hint =
                Text::tr("Play, click the background, and stop. Drag the timeline back to the left, type 1 "
                         "beside **Soft**, and play on for a second."),
        },
    };
}

std::vector<Try> volumeTries()
{
    return {
        {
            .text = Text::tr("Squash it until it is 40 px wide."),
            .conditions =
                {
                    clicked(),
                    atLeast(40.0, bodyWidth,
                            Text::tr("send it far away, to where it looks. It is %1 px wide."), 0),
                },
            .hint = Text::tr(
                "Press **Space**. It looks to the right at the start: click the background far to the "
                "right, at the same height."),
        },
        {
            .text = Text::tr("Stretch it until it is only 22 px wide."),
            .conditions =
                {
                    clicked(),
                    atMost(22.0, bodyWidth, Text::tr("send it farther. It is %1 px wide."), 0),
                },
            .hint =
                Text::tr("Press **Space**, and click the background in the corner that is farthest away."),
        },
        {
            .text =
                Text::tr("Pull one side at least 40 px out. The other side makes up for it: the area stays."),
            .conditions =
                {
                    {[](const Timeline &run) { return heldBody(run).starts_with("side"); }},
                    draggedAtLeast(40.0),
                    {[](const Timeline &run) {
                         return std::abs(sim::areaOf(run.state(), corners) / restArea(run.values()) - 1.0) <
                                1e-6;
                     },
                     Text::tr("hold it still until the area is right again.")},
                },
            .hint = Text::tr(
                "Press **Space**. Take one of the two points at its sides, pull it away from the body, "
                "and do not let go."),
        },
    };
}

std::vector<Try> tentaclesTries()
{
    return {
        {
            .text = Text::tr("Set **tentacles** to 8, send it somewhere, and wait until it has arrived."),
            .conditions =
                {
                    parameterSetTo("tentacles", 8.0),
                    clickedSinceSet("tentacles"),
                    {[](const Timeline &run) {
                         return sim::length(toTarget(run)) < 2.0 &&
                                sim::length(run.state().velocityOf(lead)) < 0.1;
                     },
                     Text::tr("let time run (**Space**) until it has arrived.")},
                },
            .hint =
                Text::tr("Type 8 into the field beside **Tentacles**. Press **Space**, click the background, "
                         "and wait."),
        },
        {
            .text = Text::tr(
                "Set **water** to 0.98 and send it to and fro until a tentacle whips at 40 px per frame."),
            .conditions =
                {
                    parameterSetTo("water", 0.98),
                    clicked(),
                    atLeast(40.0, maxTentacleSpeed,
                            Text::tr("send it to and fro, farther and faster. The fastest tip moves at %1 px "
                                     "per frame."),
                            0),
                },
            .hint = Text::tr(
                "Type 0.98 into the field beside **Water**. Press **Space**, and click one corner and "
                "the opposite one in turn, twice a second."),
        },
        {
            .text = Text::tr("Go back in time, change **water**, and compare with the ghost."),
            .conditions = {comparisonDiffers("water"), playedSinceFork()},
            .hint = Text::tr("Play, click the background, and stop. Drag the timeline back to the left, type "
                             "another **Water**, and play on for a second."),
        },
    };
}

}

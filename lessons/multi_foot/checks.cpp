#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/run_queries.h"
#include "lessons/multi_foot/text.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>

using namespace lessons;
using sim::Timeline;

namespace multi_foot {

namespace {

bool isFoot(const std::string &name)
{
    return name.starts_with("foot");
}

Conditions footDraggedAndStill()
{
    return {{[](const Timeline &run) {
                const std::optional<DragGesture> drag = lastReleased(run);
                return drag && isFoot(drag->body);
            }},
            draggedAtLeast(75.0),
            allStill()};
}

Condition flewOff()
{
    return {flewOffStage, Text::tr("let time run (**Space**) until it has left the stage.")};
}

/// Returns whether the run has stopped, or its positions have grown so large that it soon will.
bool exploded(const Timeline &run)
{
    return run.stop() || run.state().position.abs().maxCoeff() > 1e6;
}

}

std::vector<Try> twoFeetTries()
{
    return {
        {
            .text = Text::tr("Pull a foot at least 75 px out, let go, and wait until all is still."),
            .conditions = footDraggedAndStill(),
            .hint = Text::tr(
                "Press **Space**. Take one of the small discs, pull it to the upper edge of the picture, "
                "let go, and wait."),
        },
        {
            .text = Text::tr("Carry the body at least 100 px. Both feet follow."),
            .conditions = {lastGrabbed("body"), draggedAtLeast(100.0)},
            .hint =
                Text::tr("Press **Space**, take the large disc, and carry it from one side of the picture to "
                         "the other."),
        },
        {
            .text = Text::tr("Set **damping** to 0.9 and hands off. How long does it take to fly away?"),
            .conditions = {parameterSetTo("damp", 0.9), idleFor(60), flewOff()},
            .hint =
                Text::tr("Press **Home**. Type 0.9 into the field beside **Damping**, press **Space**, and "
                         "touch nothing."),
            .answer = Text::tr("It has left the stage of 540 × 400 px after about 225 frames, 7.5 seconds. "
                               "Its springs make more momentum than damping takes."),
        },
    };
}

std::vector<Try> anyNumberTries()
{
    return {
        {
            .text = Text::tr("Pull one foot at least 75 px out, let go, and wait until all is still."),
            .conditions = footDraggedAndStill(),
            .hint = Text::tr(
                "Press **Space**, pull one of the small discs to the upper edge of the picture, let go, and "
                "wait."),
        },
        {
            .text = Text::tr("Set **feet** to 12 and give it 200 frames. Does it calm down?"),
            .conditions =
                {
                    parameterSetTo("feet", 12.0),
                    unchangedFor("feet", 200),
                    {[](const Timeline &run) { return (run.state().velocity.abs() <= 0.1).all(); },
                     Text::tr(
                         "press **Home**, and set **feet** to 12 there: the creature was out of shape.")},
                },
            .hint =
                Text::tr("Press **Home**. Type 12 into the field beside **Feet**, press **Space**, and wait "
                         "seven seconds."),
            .answer =
                Text::tr("Yes. After 50 frames nothing moves faster than a tenth of a pixel per frame."),
        },
        {
            .text = Text::tr("Go back in time, change **damping**, and compare with the ghost."),
            .conditions = {comparisonDiffers("damp"), playedSinceFork()},
            .hint = Text::tr(
                "Play some seconds, drag the timeline back to the left, change **Damping**, and play "
                "on for a second."),
        },
    };
}

std::vector<Try> grownFeetTries()
{
    return {
        {
            .text = Text::tr("Set **feet** to 16, choose the method **Semi-implicit Euler**, and wait until "
                             "all is still."),
            .conditions =
                {
                    parameterSetTo("feet", 16.0),
                    runsMethod("semi_implicit_euler", Text::tr("choose the method **Semi-implicit Euler**.")),
                    allStill(),
                },
            .hint =
                Text::tr("Type 16 into the field beside **Feet**. Above the picture, choose **Semi-implicit "
                         "Euler** as method. Press **Space** and wait."),
        },
        {
            .text = Text::tr("Set **feet** to 60 and play until it explodes."),
            .conditions =
                {
                    parameterSetTo("feet", 60.0),
                    {exploded, Text::tr("let time run (**Space**), with steps of 1 frame.")},
                },
            .hint = Text::tr(
                "Type 60 into the field beside **Feet**, and press **Space**. It takes some seconds."),
        },
        {
            .text =
                Text::tr("Keep the 60 feet, choose a **step** of 1/2 frame, and wait until all is still."),
            .conditions =
                {
                    {[](const Timeline &run) {
                        return !run.script().step.isAdaptive() && run.script().step.h == 0.5;
                    }},
                    parameterSetTo("feet", 60.0, Text::tr("set **feet** to 60.")),
                    allStill(),
                },
            .hint = Text::tr(
                "Leave 60 in the field beside **Feet**, press **Home** to go to frame 0, choose **1/2 "
                "frame** as step above the picture, and press **Space**."),
        },
    };
}

}

#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/run_queries.h"
#include "sim/run/timeline.h"

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
    return {flewOffStage, "off_stage"};
}

/// Returns whether the run has stopped, or its positions have grown so large that it soon will.
bool exploded(const Timeline &run)
{
    return run.stop() || run.state().position.abs().maxCoeff() > 1e6;
}

}

std::vector<Check> twoFeetChecks()
{
    return {
        {
            .id = "pull_foot",
            .conditions = footDraggedAndStill(),
        },
        {
            .id = "carry_body",
            .conditions = {lastGrabbed("body"), draggedAtLeast(100.0)},
        },
        {
            .id = "fly_away",
            .conditions = {parameterSetTo("damp", 0.9), idleFor(60), flewOff()},
        },
    };
}

std::vector<Check> anyNumberChecks()
{
    return {
        {
            .id = "pull_foot",
            .conditions = footDraggedAndStill(),
        },
        {
            .id = "twelve_feet",
            .conditions =
                {
                    parameterSetTo("feet", 12.0),
                    unchangedFor("feet", 200),
                    {[](const Timeline &run) { return (run.state().velocity.abs() <= 0.1).all(); }, "calm"},
                },
        },
        {
            .id = "compare",
            .conditions = {comparisonDiffers("damp"), playedSinceFork()},
        },
    };
}

std::vector<Check> grownFeetChecks()
{
    return {
        {
            .id = "sixteen_feet",
            .conditions =
                {
                    parameterSetTo("feet", 16.0),
                    runsMethod("semi_implicit_euler", "method"),
                    allStill(),
                },
        },
        {
            .id = "explode",
            .conditions =
                {
                    parameterSetTo("feet", 60.0),
                    {exploded, "exploded"},
                },
        },
        {
            .id = "half_frame",
            .conditions =
                {
                    stepIs(0.5),
                    parameterSetTo("feet", 60.0, "feet"),
                    allStill(),
                },
        },
    };
}

}

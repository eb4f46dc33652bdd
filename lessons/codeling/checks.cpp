#include "checks.h"

#include "lessons/api/checks/drag_gesture.h"
#include "lessons/api/checks/input_queries.h"
#include "lessons/api/checks/run_queries.h"
#include "scenes.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

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

/// A click: its position, and the state in which it was made.
struct Click
{
    sim::Vec2 at;
    sim::State state;
};

/// Returns the last click up to the cursor.
std::optional<Click> lastClick(const Timeline &run)
{
    std::optional<Click> last;
    for (const sim::Event &event : run.script().input) {
        const auto *target = std::get_if<sim::Target>(&event.what);
        if (!target || event.frame > run.cursor().frame + run.track().framesPerOutput())
            continue;
        const std::int64_t before = std::clamp<std::int64_t>(event.frame - 1, 0, run.cursor().frame);
        last = {target->at, run.track().stateAt(before)};
    }
    return last;
}

/// Returns the distance of the last click from the lead's position at that time, in px. 0 without a click.
double clickDistance(const Timeline &run)
{
    const std::optional<Click> click = lastClick(run);
    return click ? sim::length(click->at - click->state.positionOf(lead)) : 0.0;
}

/// Returns whether the last click was in front of the creature, which looks from its tail to its lead.
bool hasClickedAhead(const Timeline &run)
{
    const std::optional<Click> click = lastClick(run);
    if (!click)
        return false;
    const sim::Vec2 head = click->state.positionOf(lead);
    const sim::Vec2 back = click->state.positionOf(run.track().interval().scene.find("tail"));
    return dot(click->at - head, head - back) > 0.0;
}

Condition clicked()
{
    return {hasClicked, "click"};
}

Condition clickedSinceSet(const std::string &id)
{
    return {[id](const Timeline &run) { return hasClickedSinceSet(run, id); }, clicked().sentence};
}

Condition arrived()
{
    return {[](const Timeline &run) { return sim::length(toTarget(run)) < 1.0 && isStill(run); }, "arrived"};
}

/// Returns the speed at which the lead moves away from its target, in px/frame.
double retreatSpeed(const Timeline &run)
{
    const sim::Vec2 v = run.state().velocityOf(lead), offset = toTarget(run);
    return -dot(v, offset) / std::max(1.0, sim::length(offset));
}

Condition backsUp()
{
    return atLeast(3.0, retreatSpeed, "backs_up");
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

std::vector<Check> motorChecks()
{
    return {
        {
            .id = "click",
            .conditions =
                {
                    clicked(),
                    atLeast(100.0, clickDistance, "distance", 0),
                    arrived(),
                },
        },
        {
            .id = "throw",
            .conditions = {released("lead"), thrownAtLeast(), arrived()},
        },
        {
            .id = "keep",
            .conditions =
                {
                    parameterSetTo("keep", 1.0),
                    clickedSinceSet("keep"),
                    {[](const Timeline &run) { return run.cursor().phase == 0 && !isStill(run); }, "moving"},
                    atLeast(100.0, framesSinceClick, "frames", 0),
                },
        },
    };
}

std::vector<Check> orientationChecks()
{
    return {
        {
            .id = "turn_round",
            .conditions =
                {
                    clicked(),
                    atLeast(30.0, tailRightOfLead, "tail_right", 0),
                },
        },
        {
            .id = "tail",
            .conditions = {released("tail"), draggedAtLeast(75.0), arrived()},
        },
        {
            .id = "before_stick",
            .conditions =
                {
                    insideFrame(),
                    {[](const Timeline &run) { return hasMoved(run); }, "lead_moved"},
                    atLeast(5.0, tailExcess, "tail_away"),
                },
        },
    };
}

std::vector<Check> anticipationChecks()
{
    return {
        {
            .id = "wind_up",
            .conditions =
                {
                    clicked(),
                    insideFrame(),
                    {[](const Timeline &run) {
                         const sim::Phase *last = lastPhase(run);
                         return last && last->kind == sim::EffectKind::driver;
                     },
                     "phase"},
                    backsUp(),
                },
        },
        {
            .id = "larger",
            .conditions = {parameterSetTo("anticipation", 0.6), clicked(), backsUp()},
        },
        {
            .id = "compare",
            .conditions =
                {
                    comparisonDiffers("anticipation"),
                    {[](const Timeline &run) { return hasInputFrom<sim::Target>(run, run.forkFrame() + 1); },
                     "before_click"},
                    playedSinceFork(),
                },
        },
    };
}

std::vector<Check> squashStretchChecks()
{
    return {
        {
            .id = "stretch",
            .conditions =
                {
                    clicked(),
                    atLeast(55.0, spineLength, "spine", 0),
                },
        },
        {
            .id = "squash",
            .conditions =
                {
                    clicked(),
                    {hasClickedAhead, "ahead"},
                    atMost(32.0, spineLength, "spine", 0),
                },
        },
        {
            .id = "compare",
            .conditions =
                {
                    comparisonDiffers("soft"),
                    parameterSetTo("soft", 1.0, "soft"),
                    playedSinceFork(),
                },
        },
    };
}

std::vector<Check> volumeChecks()
{
    return {
        {
            .id = "wide",
            .conditions =
                {
                    clicked(),
                    atLeast(40.0, bodyWidth, "width", 0),
                },
        },
        {
            .id = "narrow",
            .conditions =
                {
                    clicked(),
                    atMost(22.0, bodyWidth, "width", 0),
                },
        },
        {
            .id = "side",
            .conditions =
                {
                    {[](const Timeline &run) { return heldBody(run).starts_with("side"); }},
                    draggedAtLeast(40.0),
                    {[](const Timeline &run) {
                         return std::abs(sim::areaOf(run.state(), corners) / restArea(run.values()) - 1.0) <
                                1e-6;
                     },
                     "area"},
                },
        },
    };
}

std::vector<Check> tentaclesChecks()
{
    return {
        {
            .id = "eight",
            .conditions =
                {
                    parameterSetTo("tentacles", 8.0),
                    clickedSinceSet("tentacles"),
                    {[](const Timeline &run) {
                         return sim::length(toTarget(run)) < 2.0 &&
                                sim::length(run.state().velocityOf(lead)) < 0.1;
                     },
                     "arrived"},
                },
        },
        {
            .id = "whip",
            .conditions =
                {
                    parameterSetTo("water", 0.98),
                    clicked(),
                    atLeast(40.0, maxTentacleSpeed, "tip_speed", 0),
                },
        },
        {
            .id = "compare",
            .conditions = {comparisonDiffers("water"), playedSinceFork()},
        },
    };
}

}

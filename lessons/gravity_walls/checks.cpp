#include "checks.h"

#include "lessons/api/checks/run_queries.h"
#include "lessons/api/creature.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/timeline.h"

#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace gravity_walls {

namespace {

/// Returns whether the edge of a dynamic point touches the left (else the right) wall. With `atRest`, its
/// velocity across the wall must be 0, too.
bool touchesSide(const Timeline &run, bool left, bool atRest = false)
{
    const sim::State &state = run.state();
    const Eigen::ArrayXd halfWidth = halfWidths(run.track().interval().scene);
    for (int i = 0; i < state.pointCount(); ++i) {
        const double edge = left ? state.position(i, 0) - halfWidth[i] : state.position(i, 0) + halfWidth[i];
        const double wall = run.values()[left ? "left" : "right"];
        if (state.isDynamic(i) && std::abs(edge - wall) < 1e-9 && (!atRest || state.velocity(i, 0) == 0.0))
            return true;
    }
    return false;
}

/// Returns whether, inside a frame, a dynamic point is past a wall that has not moved it back yet.
bool isPastAWall(const Timeline &run)
{
    const sim::State &state = run.state();
    const Eigen::ArrayXd halfWidth = halfWidths(run.track().interval().scene);
    const Eigen::ArrayXd x = state.position.col(0), y = state.position.col(1);
    const auto past = (x + halfWidth > run.values()["right"] + 1e-9) ||
                      (x - halfWidth < run.values()["left"] - 1e-9) ||
                      (y + halfWidth > run.values()["floor"] + 1e-9);
    return run.cursor().phase > 0 && (past && state.inverseMass != 0.0).any();
}

/// Returns whether the whole body is above the upper edge of the picture, at y = 0.
bool isAboveThePicture(const Timeline &run)
{
    return positionOf(run, "body").y < -bodyWidth / 2;
}

/// Returns whether all feet hang still below the body, at the distance at which the spring balances gravity.
bool areFeetHanging(const Timeline &run)
{
    const double k = run.values()["k"];
    if (k <= 0.0 || !isStill(run))
        return false;
    const double distance = run.values()["radius"] + run.values()["gravity"] / k;
    const sim::State &state = run.state();
    const sim::Vec2 body = state.positionOf(state.pointCount() - 1);
    for (int i = 0; i + 1 < state.pointCount(); ++i) {
        if (sim::length(state.positionOf(i) - body - sim::Vec2{0.0, distance}) > 0.5)
            return false;
    }
    return true;
}

Condition pastAWall()
{
    return {isPastAWall, "past_wall"};
}

Condition hanging()
{
    return {areFeetHanging, "hanging"};
}

Condition touching(const QString &sentence, bool atRest)
{
    return {[atRest](const Timeline &run) {
                return touchesSide(run, true, atRest) || (atRest && touchesSide(run, false, atRest));
            },
            sentence};
}

double wallDistance(const Timeline &run)
{
    return run.values()["right"] - run.values()["left"];
}

double heightAboveFloor(const Timeline &run)
{
    return run.values()["floor"] - positionOf(run, "body").y;
}

}

std::vector<Check> wallsChecks()
{
    return {
        {
            .id = "left_wall",
            .conditions =
                {
                    released(),
                    thrownAtLeast(),
                    touching("wall", false),
                },
        },
        {
            .id = "past_wall",
            .conditions =
                {
                    insideFrame(),
                    pastAWall(),
                },
        },
        {
            .id = "no_bounce",
            .conditions =
                {
                    parameterSetTo("bounce", 0.0),
                    releasedSinceSet("bounce"),
                    thrownAtLeast(),
                    touching("wall", true),
                },
        },
        {
            .id = "no_ceiling",
            .conditions =
                {
                    released("body"),
                    thrownAtLeast(),
                    {isAboveThePicture, "above"},
                },
        },
    };
}

std::vector<Check> gravityChecks()
{
    return {
        {
            .id = "hang",
            .conditions = {holding("body"), hanging()},
        },
        {
            .id = "damping",
            .conditions = {parameterSetTo("damp", 0.6), holding("body"), hanging()},
        },
        {
            .id = "after_gravity",
            .conditions =
                {
                    insideFrame(),
                    {[](const Timeline &run) {
                         const sim::Phase *last = lastPhase(run);
                         return last && last->kind == sim::EffectKind::gravity;
                     },
                     "phase"},
                },
        },
        {
            .id = "narrow_room",
            .conditions =
                {
                    {[](const Timeline &run) { return wallDistance(run) <= 60.0; }},
                    releasedSinceSet("left", "body"),
                    releasedSinceSet("right", "body"),
                    allStill(),
                    {[](const Timeline &run) {
                         return heightAboveFloor(run) >= 30.0 &&
                                heightAboveFloor(run) <= run.values()["radius"] + bodyWidth;
                     },
                     "height", heightAboveFloor, 0},
                },
        },
    };
}

}

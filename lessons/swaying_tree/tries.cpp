#include "tries.h"

#include "lessons/api/checks.h"
#include "measuring.h"
#include "standing.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace swaying_tree {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(SwayingTree)
};

const sim::Scene &sceneOf(const Timeline &run)
{
    return run.track().shown().scene;
}

double bend(const Timeline &run)
{
    return largestBend(sceneOf(run), run.now());
}

/// How far the trunk leans from straight up, in degrees.
double lean(const Timeline &run)
{
    return bendOf(sceneOf(run), run.now(), 0);
}

bool blows(const Timeline &run)
{
    return run.now().outside.pointerDown;
}

/// What the learner set, at the cursor.
bool isPublished(const Timeline &run)
{
    return formulaOf(run.values()) == sim::TreeFormula::published;
}

/// How many frames the button has been as it is, up to the cursor; -1 when it was never touched.
std::int64_t framesSinceButton(const Timeline &run)
{
    std::int64_t since = -1;
    bool down = false;
    for (const sim::Event &event : run.script().input) {
        const auto *pointer = std::get_if<sim::Pointer>(&event.what);
        if (event.frame > run.at().frame || !pointer)
            continue;
        if (since < 0 || pointer->down != down)
            since = event.frame;
        down = pointer->down;
    }
    return since < 0 ? -1 : run.at().frame - since;
}

/// The state in the frame in which the button was let go last; null while it is down, and before.
std::optional<sim::State> whenLetGo(const Timeline &run)
{
    const std::int64_t since = framesSinceButton(run);
    if (since < 0 || blows(run) || run.at().frame - since < 1)
        return {};
    return run.track().stateAt(run.at().frame - since - 1);
}

/// Whether every branch points at the pointer, to one degree.
bool allPointAtThePointer(const Timeline &run)
{
    const sim::State &now = run.now();
    if (!blows(run))
        return false;
    const sim::Vec2 pointer = *now.outside.pointer;
    for (int i = 0; i < now.points(); ++i) {
        const sim::Vec2 way = pointer - now.at(i);
        const double angle = std::atan2(way.y, way.x) * sim::degreesPerRadian;
        if (std::abs(std::remainder(now.angle[i] - angle, 360.0)) > 1.0)
            return false;
    }
    return true;
}

/// Whether the tree was bent by `degrees` when the button was let go, and has come back since.
bool cameBack(const Timeline &run, double degrees)
{
    const std::optional<sim::State> then = whenLetGo(run);
    return then && largestBend(sceneOf(run), *then) > degrees && bend(run) <= 1.0;
}

/// How far the branch next to the pointer is bent while the wind blows within `reach` px of its end.
double bendNextToThePointer(const Timeline &run, double reach)
{
    if (!blows(run))
        return 0.0;
    const sim::Vec2 pointer = *run.now().outside.pointer;
    const int branch = nearestBranch(sceneOf(run), run.now(), pointer);
    const bool near = sim::length(endOf(sceneOf(run), run.now(), branch) - pointer) <= reach;
    return near ? std::abs(bendOf(sceneOf(run), run.now(), branch)) : 0.0;
}

/// The distances from the pointer to the ends of the branches, least and most.
std::pair<double, double> distances(const Timeline &run)
{
    double least = 1e9, most = 0.0;
    for (int i = 0; i < run.now().points(); ++i) {
        const double one = sim::length(endOf(sceneOf(run), run.now(), i) - *run.now().outside.pointer);
        least = std::min(least, one);
        most = std::max(most, one);
    }
    return {least, most};
}

bool isOtherTree(const Timeline &run)
{
    return !isSetTo(run, "spread", 30.0) && run.at().frame > 0;
}

Try compareFormulas(const QString &text)
{
    return {text, [](const Timeline &run) { return blows(run) && comparesWithGhost(run, "formula"); }};
}

}

std::vector<Try> trunkTries()
{
    return {
        {Text::tr("Make the trunk half as high as the stage: set **trunk length** to 200."),
         [](const Timeline &run) { return isSetTo(run, "base_length", 200.0); }},
        {Text::tr(
             "Switch **Formula** to published. Find its 0.0116 px in the code: the x of `end` is no longer "
             "275."),
         [](const Timeline &run) { return isPublished(run); }},
    };
}

std::vector<Try> branchesTries()
{
    return {
        {Text::tr("Make a tree with just three branches: raise **smallest branch**."),
         [](const Timeline &run) { return run.now().points() == 3; }},
        {Text::tr("Set **spread** to 90°. Which way do the branches of every second level point?"),
         [](const Timeline &run) { return isSetTo(run, "spread", 90.0); }},
        {Text::tr("Set **slope** to 0.7. How many levels are left, and how many branches?"),
         [](const Timeline &run) { return isSetTo(run, "slope", 0.7); }},
    };
}

std::vector<Try> randomnessTries()
{
    return {
        {Text::tr("Set **jitter** to 0, and the tree of the step before is back."),
         [](const Timeline &run) { return isSetTo(run, "jitter", 0.0); }},
        {Text::tr("Set **jitter** to 60°. Is it still a tree?"),
         [](const Timeline &run) { return isSetTo(run, "jitter", 60.0); }},
        {Text::tr("Choose a tree from the gallery, or make one of your own with another **spread**."),
         [](const Timeline &run) { return !isSetTo(run, "spread", 30.0); }},
    };
}

std::vector<Try> towardsPointerTries()
{
    return {
        {Text::tr("Hold the button down beside the tree. Every branch points at you."),
         [](const Timeline &run) { return !isPublished(run) && allPointAtThePointer(run); }},
        {Text::tr("Do the same with **Formula** set to published, and hold still. Count the frames until the "
                  "whole tree points at you."),
         [](const Timeline &run) { return isPublished(run) && allPointAtThePointer(run); }},
        {Text::tr("Hold the button down low beside the trunk, then let go. Does the tree get up again?"),
         [](const Timeline &run) { return !blows(run) && std::abs(lean(run)) > 45.0; }},
    };
}

std::vector<Try> windTries()
{
    return {
        {Text::tr("Blow until the trunk leans by more than 60°."),
         [](const Timeline &run) { return blows(run) && std::abs(lean(run)) > 60.0; }},
        {Text::tr("Set **ease** to 2 and blow for ten frames. Then set it to 30, and do it again."),
         [](const Timeline &run) {
             return run.values()["ease"] >= 30.0 && blows(run) && framesSinceButton(run) >= 10;
         }},
        compareFormulas(
            Text::tr("Blow from close by. Go back a few frames, set **Formula** to published, and "
                     "play on: the ghost is the wind as meant.")),
    };
}

std::vector<Try> restTries()
{
    return {
        {Text::tr("Bend a branch by more than 60°, let go, and count the frames until all are back within "
                  "1°."),
         [](const Timeline &run) { return cameBack(run, 60.0); }},
        {Text::tr("Do the same with **ease** at 30. How much longer does it take?"),
         [](const Timeline &run) { return run.values()["ease"] >= 30.0 && cameBack(run, 60.0); }},
        {Text::tr("Stop inside a frame (**Shift+→**) when the tree has returned and the wind has not bent it "
                  "yet."),
         [](const Timeline &run) {
             const sim::Phase *last = lastPhase(run);
             return last && last->kind == sim::Kind::spring && blows(run) && bend(run) > 1.0;
         }},
    };
}

std::vector<Try> distanceTries()
{
    return {
        {Text::tr("Blow at a twig from less than 20 px until it is bent by more than 30°."),
         [](const Timeline &run) { return bendNextToThePointer(run, 20.0) > 30.0; }},
        {Text::tr("Now from a corner, for 60 frames: nothing bends by more than 15°."),
         [](const Timeline &run) { return blows(run) && framesSinceButton(run) >= 60 && bend(run) < 15.0; }},
        compareFormulas(
            Text::tr("While you blow, go back a few frames, set **Formula** to published, and play on. "
                     "Which tree bends more?")),
    };
}

std::vector<Try> thicknessTries()
{
    return {
        {Text::tr("Blow until some twig is bent twenty times as far as the trunk."),
         [](const Timeline &run) { return bend(run) > 20.0 && bend(run) >= 20.0 * std::abs(lean(run)); }},
        {Text::tr("Set **wind** to 20 and lean the trunk by 10°."),
         [](const Timeline &run) {
             return isSetTo(run, "wind", 20.0) && blows(run) && std::abs(lean(run)) >= 10.0;
         }},
        compareFormulas(
            Text::tr("While you blow from close by, go back a few frames, set **Formula** to published, "
                     "and play on. Which twigs quiver?")),
    };
}

std::vector<Try> turbulenceTries()
{
    return {
        {Text::tr("Hold the button for 60 frames and watch the twigs, then the trunk."),
         [](const Timeline &run) { return blows(run) && framesSinceButton(run) >= 60; }},
        {Text::tr("Go back to where your wind began, set **turbulence** to 0, and play on. The ghost "
                  "trembles, the tree does not."),
         [](const Timeline &run) {
             return isSetTo(run, "turbulence", 0.0) && blows(run) && comparesWithGhost(run, "turbulence");
         }},
        {Text::tr("Choose another tree from the gallery and blow at it."),
         [](const Timeline &run) { return isOtherTree(run) && blows(run) && bend(run) > 10.0; }},
    };
}

std::vector<Try> realSwayTries()
{
    return {
        {Text::tr(
             "Blow, let go, and watch: the trunk swings past its rest, towards where the wind came from."),
         [](const Timeline &run) {
             if (framesSinceButton(run) < 1 || blows(run) || std::abs(lean(run)) < 0.5)
                 return false;
             const double fromLeft = run.now().at(0).x - run.now().outside.pointer->x;
             return lean(run) * fromLeft < 0.0;
         }},
        {Text::tr("Hold the button at the left edge and stop (**Space**) when the gust has reached some "
                  "branches, but not all."),
         [](const Timeline &run) {
             if (!blows(run))
                 return false;
             const auto [least, most] = distances(run);
             return run.now().gale.front > least && run.now().gale.front < most;
         }},
        {Text::tr("Set **damping** to 1, blow, and let go. After 300 frames it still sways: look at the "
                  "energy."),
         [](const Timeline &run) {
             return isSetTo(run, "damp", 1.0) && whenLetGo(run) && framesSinceButton(run) >= 300 &&
                    bend(run) > 1.0;
         }},
        {Text::tr("Choose another tree from the gallery and blow at it."),
         [](const Timeline &run) { return isOtherTree(run) && blows(run) && bend(run) > 10.0; }},
    };
}

}

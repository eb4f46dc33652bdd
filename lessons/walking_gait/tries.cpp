#include "tries.h"

#include "lessons/api/checks.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace walking_gait {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(WalkingGait)
};

/// Whether foot 0 was pulled past the body to its right side, let go, and is at rest on the left again.
bool footCameBack(const Timeline &run)
{
    const std::optional<Carry> carry = lastLetGo(run, "foot0");
    const double body = placeOf(run, "body").x;
    if (!carry || placeOf(run, "foot0").x >= body || !isStill(run))
        return false;
    return std::any_of(carry->path.begin(), carry->path.end(),
                       [&](const HandPlace &place) { return place.at.x > body + 20.0; });
}

bool carriedBody(const Timeline &run, double reach)
{
    const std::vector<Carry> all = carries(run);
    return !all.empty() && all.back().body == "body" && all.back().reach() >= reach;
}

bool pulledAFoot(const Timeline &run, double reach)
{
    const std::optional<Carry> carry = lastLetGo(run);
    return carry && carry->body.starts_with("foot") && carry->reach() >= reach;
}

/// How far foot 0 is from the middle of its places, px.
double swing(const Timeline &run)
{
    const sim::Vec2 middle = placeOf(run, "body") + sim::Vec2{0.0, run.values()["drop"]};
    return sim::length(placeOf(run, "foot0") - middle);
}

Try carryOver150()
{
    return {Text::tr("Carry the body at least 150 px. Both feet follow, each on its side."),
            [](const Timeline &run) { return carriedBody(run, 150.0); }};
}

}

std::vector<Try> bonesTries()
{
    return {
        {Text::tr(
             "Pull foot 0 over to the right of the body, let go, and wait until all is still. Where does "
             "it end?"),
         footCameBack},
        carryOver150(),
        {Text::tr("Stop inside a frame (**Shift+→**) when the springs have pulled and nothing has moved."),
         springPulledNothingMoved},
    };
}

std::vector<Try> legsTries()
{
    return {
        {Text::tr("Set **leg** to 100 and wait until all is still. How long are the lines?"),
         [](const Timeline &run) { return isSetTo(run, "leg", 100.0) && isStill(run); }},
        {Text::tr("Pull a foot at least 100 px away and let go. The line shows how far the spring swings."),
         [](const Timeline &run) { return pulledAFoot(run, 100.0); }},
    };
}

std::vector<Try> feetBelowTries()
{
    return {
        {Text::tr("Set **drop** to 0, as it was before, and wait until all is still."),
         [](const Timeline &run) { return isSetTo(run, "drop", 0.0) && isStill(run); }},
        {Text::tr("Set **drop** so that the feet belong above the body, and wait until all is still."),
         [](const Timeline &run) { return run.values()["drop"] < 0.0 && isStill(run); }},
        carryOver150(),
    };
}

std::vector<Try> curvedLegsTries()
{
    return {
        {Text::tr("Set **curve** to 0. What do the legs look like?"),
         [](const Timeline &run) { return isSetTo(run, "curve", 0.0); }},
        {Text::tr("Carry the body, go back in time, change **curve**, and compare with the ghost: the "
                  "run is the same."),
         [](const Timeline &run) { return comparesWithGhost(run, "curve"); }},
        {Text::tr("Set **curve** below 0."), [](const Timeline &run) { return run.values()["curve"] < 0.0; }},
    };
}

std::vector<Try> swingTries()
{
    return {
        {Text::tr("Set **speed** to −0.05 for at least 60 frames. Which way do the feet go round now?"),
         [](const Timeline &run) {
             return isSetTo(run, "speed", -0.05) && framesSinceSet(run, "speed") >= 60;
         }},
        {Text::tr("Find a speed at which a foot goes round more than 150 px from the middle of its places. "
                  "Hands off while you measure."),
         [](const Timeline &run) { return framesWithoutHand(run) >= 120 && swing(run) > 150.0; }},
        {Text::tr("Carry the body 200 px to the side, slowly. It looks like walking."),
         [](const Timeline &run) { return carriedBody(run, 200.0); }},
    };
}

std::vector<Try> bodyPulledTries()
{
    return {
        {Text::tr("Pull a foot at least 100 px away and let go. Now the body comes along."),
         [](const Timeline &run) { return pulledAFoot(run, 100.0); }},
        {Text::tr(
             "Set **damping** to 1 and throw the creature. After 100 frames its momentum is what your hand "
             "gave it."),
         [](const Timeline &run) {
             return isSetTo(run, "damp", 1.0) && wasThrown(run) && framesWithoutHand(run) >= 100 &&
                    sim::length(momentum(run)) >= 1.0;
         }},
        {Text::tr("Hold a foot for 60 frames. It feels nothing, but the body still feels its leg."),
         [](const Timeline &run) {
             const std::vector<Carry> all = carries(run);
             return heldBody(run).starts_with("foot") && run.at().frame >= all.back().grabbed + 60;
         }},
    };
}

}

#include "tries.h"

#include "lessons/api/checks.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>
#include <limits>

using namespace lessons;
using sim::Timeline;

namespace walking_gait {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(WalkingGait)
};

/// How far to the right of the body the hand pulled foot 0 in its last carry, in px.
double pulledPastBody(const Timeline &run)
{
    const std::optional<Carry> carry = lastLetGo(run, "foot0");
    double most = -std::numeric_limits<double>::infinity();
    for (const HandPlace &place : carry ? carry->path : std::vector<HandPlace>())
        most = std::max(most, place.at.x - placeOf(run, "body").x);
    return most;
}

Condition letGoOfAFoot()
{
    return {[](const Timeline &run) {
        const std::optional<Carry> carry = lastLetGo(run);
        return carry && carry->body.starts_with("foot");
    }};
}

Condition holdingAFoot()
{
    return {[](const Timeline &run) { return heldBody(run).starts_with("foot"); }};
}

double framesHeld(const Timeline &run)
{
    const std::vector<Carry> all = carries(run);
    return all.empty() ? 0.0 : static_cast<double>(run.at().frame - all.back().grabbed);
}

/// How far to one side the hand carried what it took last, in px.
double carriedAside(const Timeline &run)
{
    const std::vector<Carry> all = carries(run);
    double most = 0.0;
    for (const HandPlace &place : all.empty() ? std::vector<HandPlace>() : all.back().path)
        most = std::max(most, std::abs(place.at.x - takenFrom(run, all.back()).x));
    return most;
}

/// Whether the hand has taken `body` anywhere in the run.
bool everTook(const Timeline &run, const std::string &body)
{
    const std::vector<sim::Event> &input = run.script().input;
    return std::any_of(input.begin(), input.end(), [&](const sim::Event &event) {
        const auto *grab = std::get_if<sim::Grab>(&event.what);
        return grab && grab->body == body;
    });
}

/// How far foot 0 is from the middle of its places, px.
double swing(const Timeline &run)
{
    const sim::Vec2 middle = placeOf(run, "body") + sim::Vec2{0.0, run.values()["drop"]};
    return sim::length(placeOf(run, "foot0") - middle);
}

Try carryOver100()
{
    return {Text::tr("Carry the body at least 100 px. Both feet follow, each on its side."),
            {tookLast("body"), carriedFar(100.0)}};
}

}

std::vector<Try> bonesTries()
{
    return {
        Try{Text::tr("Pull foot 0 to the right of the body, 20 px or more past it, let go, and wait until "
                     "all is still. Where does it end?"),
            {letGoOf("foot0"),
             atLeast(20.0, pulledPastBody,
                     Text::tr("pull it 20 px or more past the body, to the right. It came %1 px past it."),
                     0),
             allStill()}}
            .answered(Text::tr("On the left again: its bone has an angle of its own, and the spring pulls it "
                               "to that place from anywhere.")),
        carryOver100(),
        {Text::tr("Stop inside a frame (**Shift+→**) when the springs have pulled and nothing has moved."),
         {insideAFrame(), onlyPulled()}},
    };
}

std::vector<Try> legsTries()
{
    return {
        Try{Text::tr("Set **leg** to 100 and wait until all is still. How long are the lines?"),
            {isSet("leg", 100.0), allStill()}}
            .answered(Text::tr("100 px: at rest a line is as long as **leg** says.")),
        {Text::tr("Pull a foot at least 75 px away and let go. The line shows how far the foot swings."),
         {letGoOfAFoot(), carriedFar(75.0)}},
    };
}

std::vector<Try> feetBelowTries()
{
    return {
        {Text::tr("Set **drop** to 0, as it was before, and wait until all is still."),
         {isSet("drop", 0.0), allStill()}},
        {Text::tr("Set **drop** so that the feet belong above the body, and wait until all is still."),
         {{[](const Timeline &run) { return run.values()["drop"] < 0.0; }}, allStill()}},
        carryOver100(),
    };
}

std::vector<Try> curvedLegsTries()
{
    return {
        Try{Text::tr("Set **curve** to 0. What do the legs look like?"),
            [](const Timeline &run) { return isSetTo(run, "curve", 0.0); }}
            .answered(Text::tr("Straight: the point that bends a leg lies on its foot then.")),
        {Text::tr("Carry the body, go back in time, change **curve**, and compare with the ghost: the "
                  "run is the same."),
         {ghostDiffers("curve"),
          {[](const Timeline &run) { return everTook(run, "body"); },
           Text::tr("carry the body first. Then go back in time, and change **curve** there.")},
          besideGhost()}},
        {Text::tr("Set **curve** below 0."), [](const Timeline &run) { return run.values()["curve"] < 0.0; }},
    };
}

std::vector<Try> swingTries()
{
    return {
        Try{Text::tr("Set **speed** to −0.05 for at least 60 frames. Which way do the feet go round now?"),
            {isSet("speed", -0.05), keptFor("speed", 60)}}
            .answered(Text::tr("Anticlockwise: the angle of each foot gets smaller from frame to frame.")),
        {Text::tr("Find a speed at which a foot goes round more than 150 px from the middle of its places. "
                  "Hands off for 120 frames while you measure."),
         {{[](const Timeline &run) { return !isSetTo(run, "speed", 0.05); }},
          handsOff(120),
          atLeast(150.0, swing, Text::tr("try another speed. Foot 0 is %1 px from the middle of its places."),
                  0)}},
        {Text::tr("Carry the body at least 100 px to the side. If you do it slowly, it looks like walking."),
         {tookLast("body"),
          atLeast(100.0, carriedAside, Text::tr("carry it 100 px to the side. It came %1 px."), 0)}},
    };
}

std::vector<Try> bodyPulledTries()
{
    return {
        {Text::tr("Pull a foot at least 75 px away and let go. Now the body comes along."),
         {letGoOfAFoot(), carriedFar(75.0)}},
        {Text::tr("Set **damping** to 1 and throw the creature, at 5 px per frame or more. After 100 frames "
                  "its momentum is what your hand gave it."),
         {isSet("damp", 1.0), letGoSinceSet("damp"), fastEnough(), handsOff(100)}},
        {Text::tr("Hold a foot for 60 frames. It feels nothing, but the body still feels its leg."),
         {holdingAFoot(),
          atLeast(60.0, framesHeld, Text::tr("hold it for 60 frames while time runs. So far: %1."), 0)}},
    };
}

}

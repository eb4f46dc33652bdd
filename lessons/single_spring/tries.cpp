#include "tries.h"

#include "lessons/api/checks.h"
#include "sim/direction.h"

#include <QCoreApplication>

#include <cmath>
#include <numbers>

using namespace lessons;
using sim::Timeline;

namespace single_spring {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(SingleSpring)
};

sim::Vec2 centreOf(const Timeline &run)
{
    return {run.values()["centre_x"], run.values()["centre_y"]};
}

double footToCentre(const Timeline &run)
{
    return sim::length(placeOf(run, "foot") - centreOf(run));
}

/// Where the foot was when the hand let go of it; empty if it did not.
std::optional<sim::Vec2> footLetGoAt(const Timeline &run)
{
    const std::optional<Carry> carry = lastLetGo(run, "foot");
    if (!carry || carry->path.empty())
        return {};
    return carry->path.back().at;
}

/// The foot was let go `frames` ago or earlier, nothing has slowed it since, and it moves.
bool neverStops(const Timeline &run, std::int64_t frames)
{
    return lastLetGo(run, "foot") && framesWithoutHand(run) >= frames && isSetTo(run, "damp", 1.0) &&
           framesSinceSet(run, "damp") >= frames && run.at().phase == 0 && !isStill(run);
}

bool restsAtDistance(const Timeline &run, double wanted)
{
    return isStill(run) && std::abs(distance(run, "foot", "body") - wanted) < 0.5;
}

}

std::vector<Try> dragTries()
{
    return {
        {Text::tr(
             "Drag the foot to the cross, to 15 px, hold it still, and let go. Nothing pulls it: it stays."),
         [](const Timeline &run) {
             return lastLetGo(run, "foot") && footToCentre(run) <= 15.0 && isStill(run);
         }},
        {Text::tr("Throw it: let go while the mouse is moving. It glides and stops."),
         [](const Timeline &run) { return wasThrown(run, "foot") && isStill(run); }},
        {Text::tr("Set **damping** to 1 and throw it again. Does it ever stop? Give it 60 frames."),
         [](const Timeline &run) { return wasThrown(run, "foot") && neverStops(run, 60); }},
    };
}

std::vector<Try> fixedCentreTries()
{
    return {
        {Text::tr("Pull the foot at least 100 px away from the cross, let go, and wait until it is still."),
         [](const Timeline &run) {
             const std::optional<sim::Vec2> at = footLetGoAt(run);
             return at && sim::length(*at - centreOf(run)) >= 100.0 && isStill(run);
         }},
        {Text::tr("Stop inside a frame (**Shift+→**) when the spring has pulled and nothing has moved yet."),
         springPulledNothingMoved},
        {Text::tr(
             "Set **damping** to 1, pull the foot out and let go. Does it ever stop? Give it 100 frames."),
         [](const Timeline &run) { return neverStops(run, 100); }},
        {Text::tr("Go back in time, change **damping**, and compare with the ghost."),
         [](const Timeline &run) { return comparesWithGhost(run, "damp"); }},
    };
}

std::vector<Try> movingBodyTries()
{
    return {
        {Text::tr("Carry the body at least 200 px away, and wait until the foot lies on it."),
         [](const Timeline &run) {
             const std::vector<Carry> all = carries(run);
             return !all.empty() && all.back().body == "body" && all.back().reach() >= 200.0 &&
                    restsAtDistance(run, 0.0);
         }},
        {Text::tr("Set the stiffness **k** to 0.02 and carry the body until the foot is 150 px behind."),
         [](const Timeline &run) {
             return isSetTo(run, "k", 0.02) && heldBody(run) == "body" &&
                    carries(run).back().reach() >= 100.0 && distance(run, "foot", "body") >= 150.0;
         }},
        {Text::tr(
             "Throw the foot, and stop inside a frame when the spring has pulled it and it has not moved."),
         [](const Timeline &run) { return wasThrown(run, "foot") && springPulledNothingMoved(run); }},
    };
}

std::vector<Try> offsetTries()
{
    return {
        {Text::tr("Let the foot go on the left of the body. Where does it come to rest?"),
         [](const Timeline &run) {
             const std::optional<sim::Vec2> at = footLetGoAt(run);
             return at && at->x < placeOf(run, "body").x && isStill(run);
         }},
        {Text::tr("Give **offset** a minus, at least −10, and wait until the foot is still."),
         [](const Timeline &run) {
             const double offset = run.values()["offset"];
             return offset <= -10.0 && restsAtDistance(run, -offset);
         }},
        {Text::tr("Carry the body at least 100 px. The target goes with it."),
         [](const Timeline &run) {
             const std::vector<Carry> all = carries(run);
             return !all.empty() && all.back().body == "body" && all.back().reach() >= 100.0;
         }},
    };
}

std::vector<Try> radialTries()
{
    return {
        {Text::tr("Let the foot go close by on the left of the body, so that it comes to rest there."),
         [](const Timeline &run) {
             return lastLetGo(run, "foot") && placeOf(run, "foot").x < placeOf(run, "body").x - 20.0 &&
                    isStill(run);
         }},
        {Text::tr("Hold the foot straight below the body, to 5°. What is the angle in radians?"),
         [](const Timeline &run) {
             const sim::Vec2 from = placeOf(run, "foot") - placeOf(run, "body");
             const double off = sim::publishedDirection(from).angle - std::numbers::pi / 2;
             return heldBody(run) == "foot" && std::abs(off) <= 5.0 * std::numbers::pi / 180.0;
         }},
        {Text::tr("Set **radius** to 120 and wait until the foot is still."),
         [](const Timeline &run) { return isSetTo(run, "radius", 120.0) && restsAtDistance(run, 120.0); }},
        {Text::tr("Stop inside a frame when the spring has pulled. Find `angle` and `target` in the code."),
         springPulledNothingMoved},
    };
}

}

#include "tries.h"

#include "lessons/api/checks.h"
#include "lessons/api/hand.h"
#include "swimmer.h"

#include <QCoreApplication>

#include <algorithm>
#include <cmath>

using namespace lessons;
using sim::Timeline;

namespace codeling {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Codeling)
};

/// Whether a click has set a target up to the cursor.
bool wasSent(const Timeline &run)
{
    const std::vector<sim::Event> &input = run.script().input;
    const std::int64_t begun = run.at().frame + (run.at().phase > 0 ? run.track().rowFrames() : 0);
    return std::any_of(input.begin(), input.end(), [&](const sim::Event &event) {
        return std::holds_alternative<sim::Target>(event.what) && event.frame <= begun && begun > 0;
    });
}

sim::Vec2 toTarget(const Timeline &run)
{
    return run.now().outside.target - run.now().at(lead);
}

bool hasArrived(const Timeline &run)
{
    return sim::length(toTarget(run)) < 1.0 && isStill(run);
}

/// Whether the lead goes away from its target at 3 px/frame or more.
bool backsUp(const Timeline &run)
{
    const sim::Vec2 v = run.now().speed(lead), way = toTarget(run);
    return wasSent(run) && v.x * way.x + v.y * way.y <= -3.0 * std::max(1.0, sim::length(way));
}

double spine(const Timeline &run)
{
    return distance(run, "lead", "tail");
}

double width(const Timeline &run)
{
    return distance(run, "side0", "side1");
}

/// Whether some tentacle's point moves at least `speed` px/frame.
bool tentacleWhips(const Timeline &run, double speed)
{
    const auto &v = run.now().velocity;
    const Eigen::Index count = v.rows() - firstOfTentacles;
    return count > 0 && v.bottomRows(count).matrix().rowwise().norm().maxCoeff() >= speed;
}

}

std::vector<Try> motorTries()
{
    return {
        {Text::tr("Click at least 150 px away, and wait until it has arrived."),
         [](const Timeline &run) {
             const sim::Vec2 start = run.track().shown().scene.start.at(lead);
             return wasSent(run) && sim::length(run.now().at(lead) - start) >= 140.0 && hasArrived(run);
         }},
        {Text::tr("Set **keep** to 1 and click somewhere else. After 100 frames it still swings."),
         [](const Timeline &run) {
             return isSetTo(run, "keep", 1.0) && wasSent(run) && framesWithoutHand(run) >= 100 &&
                    !isStill(run) && run.at().phase == 0;
         }},
        {Text::tr("Take the lead in your hand and throw it. It comes back."),
         [](const Timeline &run) { return wasThrown(run, "lead") && hasArrived(run); }},
    };
}

std::vector<Try> orientationTries()
{
    return {
        {Text::tr("Send it to places so that it turns round: the tail at least 30 px to the right of the "
                  "lead."),
         [](const Timeline &run) {
             return wasSent(run) && placeOf(run, "tail").x - placeOf(run, "lead").x >= 30.0;
         }},
        {Text::tr("Pull it at least 100 px away by its tail, let go, and wait until it is back."),
         [](const Timeline &run) {
             const std::optional<Carry> carry = lastLetGo(run, "tail");
             return carry && carry->reach() >= 100.0 && hasArrived(run);
         }},
        {Text::tr("Stop inside a frame when the lead has moved, and the tail is 5 px too far away."),
         [](const Timeline &run) {
             return hasMoved(run) && spine(run) >= run.values()["rest_length"] + 5.0;
         }},
    };
}

std::vector<Try> anticipationTries()
{
    return {
        {Text::tr("Click far away, and stop inside a frame right after the shift."),
         [](const Timeline &run) {
             const sim::Phase *last = lastPhase(run);
             return last && last->kind == sim::Kind::driver && backsUp(run);
         }},
        {Text::tr("Set **anticipation** to 0.6 and click far away. It winds up like a spring."),
         [](const Timeline &run) { return isSetTo(run, "anticipation", 0.6) && backsUp(run); }},
        {Text::tr("Go back in time to before a click, change **anticipation**, and compare with the ghost."),
         [](const Timeline &run) { return comparesWithGhost(run, "anticipation"); }},
    };
}

std::vector<Try> squashStretchTries()
{
    return {
        {Text::tr("Send it so far that its spine gets 55 px long."),
         [](const Timeline &run) { return wasSent(run) && spine(run) >= 55.0; }},
        {Text::tr("Send it where it looks, so that it is squashed to 32 px before it starts."),
         [](const Timeline &run) { return wasSent(run) && spine(run) <= 32.0; }},
        {Text::tr("Go back in time, set **soft** to 1, and compare with the ghost."),
         [](const Timeline &run) { return comparesWithGhost(run, "soft"); }},
    };
}

std::vector<Try> volumeTries()
{
    return {
        {Text::tr("Squash it until it is 40 px wide."),
         [](const Timeline &run) { return wasSent(run) && width(run) >= 40.0; }},
        {Text::tr("Stretch it until it is only 22 px wide."),
         [](const Timeline &run) { return wasSent(run) && width(run) <= 22.0; }},
        {Text::tr("Pull one side at least 40 px out. The other side makes up for it: the area stays."),
         [](const Timeline &run) {
             const std::vector<Carry> all = carries(run);
             const bool holds = heldBody(run).starts_with("side") && all.back().reach() >= 40.0;
             return holds && std::abs(sim::areaOf(run.now(), corners) / restArea(run.values()) - 1.0) < 1e-6;
         }},
    };
}

std::vector<Try> tentaclesTries()
{
    return {
        {Text::tr("Set **tentacles** to 8, send it somewhere, and wait until it has arrived."),
         [](const Timeline &run) {
             return isSetTo(run, "tentacles", 8.0) && wasSent(run) && sim::length(toTarget(run)) < 2.0 &&
                    sim::length(run.now().speed(lead)) < 0.1;
         }},
        {Text::tr("Set **water** to 0.98 and send it to and fro until a tentacle whips at 40 px per frame."),
         [](const Timeline &run) {
             return isSetTo(run, "water", 0.98) && wasSent(run) && tentacleWhips(run, 40.0);
         }},
        {Text::tr("Go back in time, change **water**, and compare with the ghost."),
         [](const Timeline &run) { return comparesWithGhost(run, "water"); }},
    };
}

}

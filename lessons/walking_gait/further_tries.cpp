#include "tries.h"

#include "lessons/api/checks.h"
#include "lessons/api/creature.h"
#include "picture.h"

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

bool standsOnAFoot(const Timeline &run)
{
    const sim::Scene &scene = run.track().shown().scene;
    for (int i = 0; i < run.now().points(); ++i) {
        const bool foot = !isBody(scene.names[static_cast<std::size_t>(i)]);
        if (foot && stands(scene, run.now(), run.values(), i))
            return true;
    }
    return false;
}

/// Whether a foot that is on the ground goes up from it at 1 px/frame or more: it has just bounced.
bool justBounced(const Timeline &run)
{
    const sim::State &now = run.now();
    for (int i = 0; i + 1 < now.points(); ++i) {
        if (stands(run.track().shown().scene, now, run.values(), i) && now.velocity(i, 1) <= -1.0)
            return true;
    }
    return false;
}

/// Whether some point touches a side wall.
bool touchesAWall(const Timeline &run)
{
    const sim::State &now = run.now();
    const Eigen::ArrayXd half = halfWidths(run.track().shown().scene);
    for (int i = 0; i < now.points(); ++i) {
        const bool right = now.position(i, 0) + half[i] >= run.values()["right"];
        const bool left = now.position(i, 0) - half[i] <= run.values()["left"];
        if (now.feels(i) && (left || right))
            return true;
    }
    return false;
}

/// Whether an event of type `What` that `fits` was applied up to the cursor.
template <class What, class Fits>
bool happened(const Timeline &run, Fits &&fits)
{
    const std::vector<sim::Event> &input = run.script().input;
    return std::any_of(input.begin(), input.end(), [&](const sim::Event &event) {
        const auto *what = std::get_if<What>(&event.what);
        return what && event.frame <= run.at().frame && fits(*what);
    });
}

bool pressed(const Timeline &run, bool sim::Keys::*key)
{
    return happened<sim::Key>(run, [&](const sim::Key &one) { return one.key == key && one.down; });
}

bool pointed(const Timeline &run)
{
    return happened<sim::Pointer>(run, [](const sim::Pointer &pointer) { return pointer.down; });
}

double clockSpeedOf(const Timeline &run)
{
    return run.now().gaitSpeed[0];
}

/// How near the nearest other body is to the one called `name`, px.
double nearestBody(const Timeline &run, const std::string &name)
{
    double least = INFINITY;
    for (const std::string &other : run.track().shown().scene.names) {
        if (isBody(other) && other != name)
            least = std::min(least, distance(run, name, other));
    }
    return least;
}

/// Whether a hand holds a body, has carried it 40 px or more, and another body is close enough to be pushed.
bool draggedIntoAnother(const Timeline &run)
{
    const std::string held = heldBody(run);
    return isBody(held) && carries(run).back().reach() >= 40.0 &&
           nearestBody(run, held) < run.values()["distance"];
}

/// Whether only one of two bodies feels their push, right now.
bool onePushed(const Timeline &run)
{
    return isSetTo(run, "felt_by", 1.0) && framesSinceSet(run, "felt_by") >= 10 &&
           nearestBody(run, "creature0.body") < run.values()["distance"];
}

}

std::vector<Try> groundTries()
{
    return {
        {Text::tr("Set **speed** to −0.05 and let the creature walk off to the left."),
         [](const Timeline &run) { return isSetTo(run, "speed", -0.05) && placeOf(run, "body").x < 170.0; }},
        {Text::tr("Set **traction** to none for 150 frames: ice. It treads on the spot."),
         [](const Timeline &run) {
             return isSetTo(run, "traction", 1.0) && framesSinceSet(run, "traction") >= 150 &&
                    std::abs(momentum(run).x) < 0.1;
         }},
        {Text::tr("Set **bounce** to 0.8 and stop just when a foot bounces."),
         [](const Timeline &run) { return run.values()["bounce"] >= 0.5 && justBounced(run); }},
        {Text::tr("Lift the body at least 100 px and let go. It lands on its feet and walks on."),
         [](const Timeline &run) {
             const std::optional<Carry> carry = lastLetGo(run, "body");
             return carry && carry->reach() >= 100.0 && framesWithoutHand(run) >= 60 && standsOnAFoot(run);
         }},
    };
}

std::vector<Try> moreFeetTries()
{
    return {
        {Text::tr("Set **feet** to 12 and watch for 200 frames. How much does the body go up and down?"),
         [](const Timeline &run) {
             return isSetTo(run, "feet", 12.0) && framesSinceSet(run, "feet") >= 200;
         }},
        {Text::tr("Set **spread** to 0 for 200 frames. All feet step together: does it get anywhere?"),
         [](const Timeline &run) {
             return isSetTo(run, "spread", 0.0) && framesSinceSet(run, "spread") >= 200;
         }},
        {Text::tr("Set **speed** to 0.3 and stop when no foot touches the ground."),
         [](const Timeline &run) {
             return run.values()["speed"] >= 0.2 && framesSinceSet(run, "speed") >= 60 && !standsOnAFoot(run);
         }},
    };
}

std::vector<Try> steeringTries()
{
    return {
        {Text::tr(
             "Hold the **←** key until the creature walks to the left, and let it walk 100 px that way."),
         [](const Timeline &run) {
             return pressed(run, &sim::Keys::left) && clockSpeedOf(run) < 0.0 &&
                    placeOf(run, "body").x < 170.0;
         }},
        {Text::tr(
             "Make it as fast as it can with the pointer: hold the button at least 200 px away from it."),
         [](const Timeline &run) {
             return pointed(run) && run.values()["top"] > 0.0 &&
                    std::abs(clockSpeedOf(run)) >= run.values()["top"];
         }},
        {Text::tr("Make it stand: bring the clock to within 0.005 rad/frame of 0."),
         [](const Timeline &run) {
             const bool steered =
                 pointed(run) || pressed(run, &sim::Keys::left) || pressed(run, &sim::Keys::right);
             return steered && std::abs(clockSpeedOf(run)) <= 0.005;
         }},
    };
}

std::vector<Try> wallsTries()
{
    return {
        {Text::tr("Set **at wall** to *walk on* and let it walk against a wall for 200 frames."),
         [](const Timeline &run) {
             return isSetTo(run, "at_wall", 1.0) && framesSinceSet(run, "at_wall") >= 200 &&
                    touchesAWall(run);
         }},
        {Text::tr("Put the walls 150 px apart or closer, and see it turn to the left."),
         [](const Timeline &run) {
             return run.values()["right"] - run.values()["left"] <= 150.0 && clockSpeedOf(run) < 0.0;
         }},
        {Text::tr("Throw the creature into a wall."),
         [](const Timeline &run) {
             return wasThrown(run) && framesWithoutHand(run) <= 40 && touchesAWall(run);
         }},
    };
}

std::vector<Try> companyTries()
{
    return {
        {Text::tr("Take one creature by its body and drag it into another. Both feel the push; the one in "
                  "your hand cannot move."),
         draggedIntoAnother},
        {Text::tr("Set **felt by** to one, and look at the sum of the pushes while two bodies touch."),
         onePushed},
        {Text::tr("Set **creatures** to 5 and watch the crowd for 300 frames."),
         [](const Timeline &run) {
             return isSetTo(run, "creatures", 5.0) && framesSinceSet(run, "creatures") >= 300;
         }},
    };
}

}

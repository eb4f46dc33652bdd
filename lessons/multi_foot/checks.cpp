#include "checks.h"

#include "lessons/api/checks/hand.h"
#include "lessons/api/checks/run_queries.h"
#include "sim/run/timeline.h"

#include <QCoreApplication>

using namespace lessons;
using sim::Timeline;

namespace multi_foot {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(MultiFoot)
};

bool isFoot(const std::string &name)
{
    return name.starts_with("foot");
}

Conditions footPulledAndStill()
{
    return {{[](const Timeline &run) {
                const std::optional<Carry> carry = lastLetGo(run);
                return carry && isFoot(carry->body);
            }},
            carriedFar(75.0),
            allStill()};
}

/// The creature has left by itself: a throw would have ended long ago.
Condition flewOff()
{
    return {[](const Timeline &run) { return !onStage(middle(run)) && sim::length(momentum(run)) >= 2.0; },
            Text::tr("let time run (**Space**) until it has left the stage.")};
}

/// The numbers outgrew what a computer can hold, or are on their way there.
bool exploded(const Timeline &run)
{
    return run.stop() || run.now().position.abs().maxCoeff() > 1e6;
}

}

std::vector<Try> twoFeetTries()
{
    return {
        {Text::tr("Pull a foot at least 75 px out, let go, and wait until all is still."),
         footPulledAndStill()},
        {Text::tr("Carry the body at least 100 px. Both feet follow."),
         {tookLast("body"), carriedFar(100.0)}},
        Try{Text::tr("Set **damping** to 0.9 and hands off. How long does it take to fly away?"),
            {isSet("damp", 0.9), handsOff(60), flewOff()}}
            .answered(Text::tr("It has left the stage of 540 × 400 px after about 225 frames, 7.5 seconds. "
                               "Its springs make more momentum than damping takes.")),
    };
}

std::vector<Try> anyNumberTries()
{
    return {
        {Text::tr("Pull one foot at least 75 px out, let go, and wait until all is still."),
         footPulledAndStill()},
        Try{Text::tr("Set **feet** to 12 and give it 200 frames. Does it calm down?"),
            {isSet("feet", 12.0),
             keptFor("feet", 200),
             {[](const Timeline &run) { return (run.now().velocity.abs() <= 0.1).all(); },
              Text::tr("press **Home**, and set **feet** to 12 there: the creature was out of shape.")}}}
            .answered(
                Text::tr("Yes. After 50 frames nothing moves faster than a tenth of a pixel per frame.")),
        {Text::tr("Go back in time, change **damping**, and compare with the ghost."),
         {ghostDiffers("damp"), besideGhost()}},
    };
}

std::vector<Try> grownFeetTries()
{
    return {
        {Text::tr(
             "Set **feet** to 16, choose the method **Semi-implicit Euler**, and wait until all is still."),
         {isSet("feet", 16.0),
          byMethod("semi_implicit_euler", Text::tr("choose the method **Semi-implicit Euler**.")),
          allStill()}},
        {Text::tr("Set **feet** to 60 and play until it explodes."),
         {isSet("feet", 60.0), {exploded, Text::tr("let time run (**Space**), with steps of 1 frame.")}}},
        {Text::tr("Keep the 60 feet, choose a **step** of 1/2 frame, and wait until all is still."),
         {{[](const Timeline &run) { return !run.script().step.adaptive() && run.script().step.h == 0.5; }},
          isSet("feet", 60.0, Text::tr("set **feet** to 60.")),
          allStill()}},
    };
}

}

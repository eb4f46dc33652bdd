#include "tries.h"

#include "lessons/api/checks.h"

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

bool footPulledAndStill(const Timeline &run)
{
    const std::optional<Carry> carry = lastLetGo(run);
    return carry && isFoot(carry->body) && carry->reach() >= 100.0 && isStill(run);
}

/// The creature left by itself: a throw would have ended long ago.
bool flewOff(const Timeline &run)
{
    return framesWithoutHand(run) >= 60 && !onStage(middle(run)) && sim::length(momentum(run)) >= 2.0;
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
        {Text::tr("Pull a foot at least 100 px out, let go, and wait until all is still."),
         footPulledAndStill},
        {Text::tr("Carry the body at least 200 px. Both feet follow."),
         [](const Timeline &run) {
             const std::vector<Carry> all = carries(run);
             return !all.empty() && all.back().body == "body" && all.back().reach() >= 200.0;
         }},
        {Text::tr("Set **damping** to 0.9 and hands off. How long does it stay in the picture?"),
         [](const Timeline &run) { return isSetTo(run, "damp", 0.9) && flewOff(run); }},
    };
}

std::vector<Try> anyNumberTries()
{
    return {
        {Text::tr("Pull one foot at least 100 px out, let go, and wait until all is still."),
         footPulledAndStill},
        {Text::tr("Set **feet** to 12 and give it 200 frames. Does it calm down?"),
         [](const Timeline &run) {
             return isSetTo(run, "feet", 12.0) && framesSinceSet(run, "feet") >= 200 && run.at().phase == 0;
         }},
        {Text::tr("Go back in time, change **damping**, and compare with the ghost."),
         [](const Timeline &run) { return comparesWithGhost(run, "damp"); }},
    };
}

std::vector<Try> grownFeetTries()
{
    return {
        {Text::tr(
             "Set **feet** to 16, choose the method **Semi-implicit Euler**, and wait until all is still."),
         [](const Timeline &run) {
             return isSetTo(run, "feet", 16.0) && usesMethod(run, "semi_implicit_euler") && isStill(run);
         }},
        {Text::tr("Set **feet** to 60 and play until it explodes."),
         [](const Timeline &run) { return isSetTo(run, "feet", 60.0) && exploded(run); }},
        {Text::tr("Keep the 60 feet, choose a **step** of 1/2 frame, and wait until all is still."),
         [](const Timeline &run) {
             return isSetTo(run, "feet", 60.0) && run.script().step.h <= 0.5 && isStill(run);
         }},
    };
}

}

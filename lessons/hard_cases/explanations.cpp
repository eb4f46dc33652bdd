#include "explanations.h"
#include "lessons/hard_cases/text.h"

#include <QCoreApplication>

using lessons::Explanation;

namespace hard_cases {

Explanation limitExplanation()
{
    return {
        .learnt =
            Text::tr("A step that is too long for a spring throws it out: without damping from k h² = 4 on."),
        .terms =
            {
                {Text::tr("Stability limit"), Text::tr("the limit"),
                 Text::tr("The longest step with which a method still holds a scene. Past it, each swing is "
                          "wider than the one before.")},
                {Text::tr("Gauge"), Text::tr("gauge"),
                 Text::tr("The small bar at the lower right: it shows how near the step is to its stability "
                          "limit. A click shows the reasons.")},
                {Text::tr("Implicit method"), Text::tr("implicit midpoint|solves for it"),
                 Text::tr(
                     "A method that asks for the pull at a place that it does not know yet, and finds the "
                     "place that fits. It costs more, and has no stability limit.")},
            },
        .whys =
            {
                {Text::tr("Why 4?"),
                 Text::tr(
                     "Let the foot be at x with the velocity v. A step of h makes\n\n"
                     "`v → v − h k x`\n\n"
                     "`x → x + h v`\n\n"
                     "Now ask which swing comes back just as wide, on the other side: from x to −x, and v to "
                     "−v. For v that needs\n\n"
                     "`h k x = 2 v`\n\n"
                     "and for x, with the new velocity −v,\n\n"
                     "`h v = 2 x`\n\n"
                     "Put one into the other:\n\n"
                     "`k h² = 4`\n\n"
                     "With less, a swing stays as wide as it is. With more, it grows.")},
            },
    };
}

Explanation runawayExplanation()
{
    return {
        .learnt =
            Text::tr("Pulls that are taken at different moments do not cancel, so the pair pushes itself."),
    };
}

Explanation manyFeetExplanation()
{
    return {
        .learnt = Text::tr("Sixty soft springs on one body make one that is stiff."),
        .terms =
            {
                {Text::tr("Backward Euler"), Text::tr("Backward Euler"),
                 Text::tr("A method that looks for the place from which its own pulls lead back to where it "
                          "came from. It holds at any stiffness, and slows what swings.")},
            },
    };
}

Explanation onePlaceExplanation()
{
    return {
        .learnt = Text::tr(
            "Two points in one place have no direction between them, so a rule has to give them one."),
        .terms =
            {
                {Text::tr("Coincident points"), Text::tr("one place"),
                 Text::tr(
                     "Two points at exactly the same place. Nothing tells in which direction one lies from "
                     "the other.")},
                {Text::tr("Golden angle"), Text::tr("golden angle"),
                 Text::tr(
                     "137.5°. Turned by it again and again, directions never fall on one another and spread "
                     "evenly. Sunflowers set their seeds like that.")},
            },
        .whys =
            {
                {Text::tr("Why has one place no direction?"),
                 Text::tr(
                     "The direction from a to b is the way from one to the other, divided by its length:\n\n"
                     "`d / |d|`\n\n"
                     "In one place d is (0, 0) and its length is 0. Nothing can be divided by 0, and every "
                     "direction would be as good.\n\n"
                     "So a rule has to choose, and three things matter: the **same** choice each time, "
                     "**opposite** ones for the two ends, and **different** ones for different pairs, or all "
                     "would go the same way and stay together.\n\n"
                     "`angle = number × 137.5°`\n\n"
                     "does that: the golden angle never fits into a turn.")},
            },
    };
}

Explanation stiffExplanation()
{
    return {
        .learnt = Text::tr("What is stiff and should be calm needs either tiny steps or an implicit method."),
        .terms =
            {
                {Text::tr("Stiff"), Text::tr("is stiff|too stiff|stiff legs|stiff and calm"),
                 Text::tr(
                     "Held so hard that it swings many times in a frame. Nobody sees those swings, but a "
                     "method has to cope with them.")},
            },
    };
}

Explanation contradictionExplanation()
{
    return {
        .learnt = Text::tr(
            "Where rules contradict, springs pull for ever, and sticks come to rest with a lie shared "
            "among them."),
    };
}

Explanation longRunExplanation()
{
    return {
        .learnt = Text::tr(
            "What an error adds up to over thousands of frames counts for more than how small it is."),
    };
}

Explanation tortureExplanation()
{
    return {
        .learnt = Text::tr("What a method can hold follows from its rule, and can be said before the run."),
        .terms =
            {
                {Text::tr("Claim"), Text::tr("claims|claim"),
                 Text::tr("What a method says it can hold, worked out from its rule before the run.")},
            },
    };
}

}

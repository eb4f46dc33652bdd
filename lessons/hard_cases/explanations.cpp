#include "explanations.h"

#include <QCoreApplication>

using lessons::Teaching;

namespace hard_cases {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(HardCases)
};

Teaching limit()
{
    return {
        "limit",
        Text::tr("A step that is too long for a spring throws it out: without damping from k h² = 4 on."),
        {
            Text::tr("Above the picture, press **Step** and choose **1/2 frame**. Press **Space** and wait "
                     "four seconds."),
            Text::tr("Press **Home**, type 3.9 into the field beside **k**, press **Space**, and wait four "
                     "seconds."),
            Text::tr("Press **Home**, type 0.9 into the field beside **Damping**, press **Space**, and "
                     "wait."),
        },
        {
            {Text::tr("Stability limit"), Text::tr("the limit"),
             Text::tr("The longest step with which a method still holds a scene. Past it, each swing is "
                      "wider than the one before.")},
            {Text::tr("Gauge"), Text::tr("gauge"),
             Text::tr("The small bar at the lower right: it shows how near the step is to its stability "
                      "limit. A click shows the reasons.")},
            {Text::tr("Implicit method"), Text::tr("implicit midpoint|solves for it"),
             Text::tr("A method that asks for the pull at a place that it does not know yet, and finds the "
                      "place that fits. It costs more, and has no stability limit.")},
        },
        {{Text::tr("Why 4?"),
          Text::tr("Let the foot be at x with the velocity v. A step of h makes\n\n"
                   "`v → v − h k x`\n\n"
                   "`x → x + h v`\n\n"
                   "Now ask which swing comes back just as wide, on the other side: from x to −x, and v to "
                   "−v. For v that needs\n\n"
                   "`h k x = 2 v`\n\n"
                   "and for x, with the new velocity −v,\n\n"
                   "`h v = 2 x`\n\n"
                   "Put one into the other:\n\n"
                   "`k h² = 4`\n\n"
                   "With less, a swing stays as wide as it is. With more, it grows.")}}};
}

Teaching runaway()
{
    return {"runaway",
            Text::tr("Pulls that are taken at different moments do not cancel, so the pair pushes itself."),
            {
                Text::tr("Above the picture, press **Method** and choose **Semi-implicit Euler**. Press "
                         "**Space** and wait seven seconds."),
                Text::tr("Choose **Published** as method and **1 frame** as step. Press **Home**, type 0.2 "
                         "beside **k**, press **Space**, and wait."),
                Text::tr("Choose **Published** as method and **1/4 frame** as step. Press **Space** and "
                         "wait."),
            },
            {},
            {}};
}

Teaching manyFeet()
{
    return {
        "many_feet",
        Text::tr("Sixty soft springs on one body make one that is stiff."),
        {
            Text::tr("Press **Home**, type 38 into the field beside **Feet**, press **Space**, and wait."),
            Text::tr("Above the picture, press **Step** and choose **1/2 frame**. Press **Space** and "
                     "wait."),
            Text::tr("Press **Home**, type 0.1 into the field beside **k**, press **Space**, and wait."),
        },
        {{Text::tr("Backward Euler"), Text::tr("Backward Euler"),
          Text::tr("A method that looks for the place from which its own pulls lead back to where it "
                   "came from. It holds at any stiffness, and slows what swings.")}},
        {}};
}

Teaching onePlace()
{
    return {
        "one_place",
        Text::tr("Two points in one place have no direction between them, so a rule has to give them one."),
        {
            Text::tr("Above the picture, press **Method** and choose **Semi-implicit Euler**. Press "
                     "**Space** and wait two seconds."),
            Text::tr("Choose **Published** as method, press **Space**, and wait two seconds. Take a foot, "
                     "carry it up, let go, and wait."),
            Text::tr("Choose **Semi-implicit Euler** as method and play two seconds. Type 0 beside "
                     "**Radius** and wait two seconds. Then type 50, and wait again."),
        },
        {{Text::tr("Coincident points"), Text::tr("one place"),
          Text::tr("Two points at exactly the same place. Nothing tells in which direction one lies from "
                   "the other.")},
         {Text::tr("Golden angle"), Text::tr("golden angle"),
          Text::tr("137.5°. Turned by it again and again, directions never fall on one another and spread "
                   "evenly. Sunflowers set their seeds like that.")}},
        {{Text::tr("Why has one place no direction?"),
          Text::tr("The direction from a to b is the way from one to the other, divided by its length:\n\n"
                   "`d / |d|`\n\n"
                   "In one place d is (0, 0) and its length is 0. Nothing can be divided by 0, and every "
                   "direction would be as good.\n\n"
                   "So a rule has to choose, and three things matter: the **same** choice each time, "
                   "**opposite** ones for the two ends, and **different** ones for different pairs, or all "
                   "would go the same way and stay together.\n\n"
                   "`angle = number × 137.5°`\n\n"
                   "does that: the golden angle never fits into a turn.")}}};
}

Teaching stiff()
{
    return {
        "stiff",
        Text::tr("What is stiff and should be calm needs either tiny steps or an implicit method."),
        {
            Text::tr("Above the picture, press **Step** and choose **1/64 frame**. Press **Space** and "
                     "wait."),
            Text::tr("Choose **Backward Euler** as method. Press **Home**, type 1000000 beside **k**, and "
                     "press **Space**."),
            Text::tr("Choose **Backward Euler** as method. Press **Home**, type 0.2 beside **k** and 1 "
                     "beside **Damping**, press **Space**, and wait."),
        },
        {{Text::tr("Stiff"), Text::tr("is stiff|too stiff|stiff legs|stiff and calm"),
          Text::tr("Held so hard that it swings many times in a frame. Nobody sees those swings, but a "
                   "method has to cope with them.")}},
        {}};
}

Teaching contradiction()
{
    return {
        "contradiction",
        Text::tr("Where rules contradict, springs pull for ever, and sticks come to rest with a lie shared "
                 "among them."),
        {
            Text::tr("Press **Home**, type 1 into the field beside **k**, press **Space**, and wait."),
            Text::tr("Choose **sticks** beside **Made of**, press **Space**, and wait."),
            Text::tr("Two sticks of 20 px reach 40 px at most. Choose **sticks** beside **Made of**, type 30 "
                     "beside **Longest**, press **Space**, and wait."),
        },
        {},
        {}};
}

Teaching longRun()
{
    return {
        "long_run",
        Text::tr("What an error adds up to over thousands of frames counts for more than how small it is."),
        {
            Text::tr("Press **Ctrl+G**, type 5000, and press **Enter**."),
            Text::tr("Above the picture, press **Step** and choose **1/2 frame**. Press **Ctrl+G**, type "
                     "5000, and press **Enter**."),
            Text::tr("Choose **Velocity Verlet** as method and **1 frame** as step. Press **Ctrl+G**, type "
                     "20000, and press **Enter**."),
        },
        {},
        {}};
}

Teaching torture()
{
    return {
        "torture",
        Text::tr("What a method can hold follows from its rule, and can be said before the run."),
        {
            Text::tr("Choose **nearly rigid** beside **Case**, and **Backward Euler** as method above the "
                     "picture. Press **Space** and wait."),
            Text::tr("Choose **torn away** beside **Case**, and **Semi-implicit Euler** or **Backward "
                     "Euler** as method. Press **Space** and wait."),
            Text::tr("Choose **Semi-implicit Euler** as method, and a case with stiff springs. Press "
                     "**Space** and wait until the run stops by itself."),
        },
        {{Text::tr("Claim"), Text::tr("claims|claim"),
          Text::tr("What a method says it can hold, worked out from its rule before the run.")}},
        {}};
}

}

std::vector<Teaching> teaching()
{
    return {limit(), runaway(), manyFeet(), onePlace(), stiff(), contradiction(), longRun(), torture()};
}

}

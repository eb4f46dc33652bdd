#include "code_tasks.h"

#include "lessons/rigid_constraint/text.h"

using namespace lessons;

namespace rigid_constraint {

std::vector<CodeTask> pairCodeTasks()
{
    return {
        {
            .id = "error",
            .title = Text::tr("the error of a stick"),
            .text = Text::tr("Write the **error** of the stick: by how much it is longer than it should be."),
            .comment = Text::tr("double error: how much too long the stick is."),
            .hints =
                {
                    Text::tr("`d` leads from one end to the other, so its length is that of the stick now."),
                    Text::tr(
                        "`length(d)` returns the length of a vector, and `stick.length` is the right one."),
                    Text::tr("`double error = length(d) - …;`"),
                },
            .nearMisses =
                {
                    {"double error = stick.length - length(d);",
                     Text::tr("The sign is wrong: a stick that is too long gets longer still. The error is "
                              "what there is, minus what there should be.")},
                    {"double error = length(d);",
                     Text::tr("This is the whole length, so the two ends meet. Subtract the right length.")},
                },
        },
    };
}

std::vector<CodeTask> sharedErrorCodeTasks()
{
    return {
        {
            .id = "parts",
            .title = Text::tr("a shared error"),
            .text = Text::tr("Share the **error** between the two ends: `a` takes the part `share_of_a` of "
                             "it, and `b` the rest. At 0.5 each takes half."),
            .comment = Text::tr("double part_of_a and part_of_b: the error, shared."),
            .hints =
                {
                    Text::tr("Together the two parts have to be the whole error."),
                    Text::tr("If `a` takes a share of 0.3, what is left for `b` is 1 - 0.3."),
                    Text::tr("`double part_of_a = error * …;` and `double part_of_b = error * (1 - …);`"),
                },
            .nearMisses =
                {
                    {"double part_of_a = error;\ndouble part_of_b = error;",
                     Text::tr("Both ends take the whole error, so the stick is as much too short as it was "
                              "too long.")},
                    {"double part_of_a = error / 2;\ndouble part_of_b = error / 2;",
                     Text::tr("Both take half, whatever the shares are. Use `share_of_a`.")},
                    {"double part_of_a = error * share_of_a;\ndouble part_of_b = error * share_of_a;",
                     Text::tr(
                         "The two parts are equal. They add up to the whole error only at a share of 0.5.")},
                    {"double part_of_a = error * (1 - share_of_a);\ndouble part_of_b = error * share_of_a;",
                     Text::tr("The two shares are swapped.")},
                },
        },
    };
}

std::vector<CodeTask> listCodeTasks()
{
    return {
        {
            .id = "loop",
            .title = Text::tr("one stick after the other"),
            .text = Text::tr(
                "Write the **loop** that gives every stick its length back, in the order of the list."),
            .comment = Text::tr("Enforce every stick."),
            .hints =
                {
                    Text::tr("There are `sticks.count` sticks, from the number 0 on."),
                    Text::tr("`enforce(stick)` gives one stick its length back."),
                    Text::tr("`for (int i = 0; i < …; i++)`, and in it `enforce(sticks[…]);`"),
                },
            .nearMisses =
                {
                    {"for (int i = 1; i < sticks.count; i++)\n    enforce(sticks[i]);",
                     Text::tr("The loop leaves out the first stick. It has the number 0.")},
                    {"for (int i = 0; i < sticks.count - 1; i++)\n    enforce(sticks[i]);",
                     Text::tr("The loop leaves out the last stick.")},
                    {"for (int i = sticks.count - 1; i >= 0; i--)\n    enforce(sticks[i]);",
                     Text::tr("The loop begins with the last stick. Each stick changes the ones before it, "
                              "so the order matters.")},
                },
        },
        {
            .id = "frame",
            .title = Text::tr("the whole frame"),
            .text = Text::tr(
                "**From the empty page:** write the whole frame of the figure of sticks. The pointer carries "
                "the first point, your hand can hold any point, and each stick gets its length back."),
            .comment =
                Text::tr("Write the whole frame. The names: points[i] (with position, held), points.count, "
                         "sticks[i] (with a, b, length, share), sticks.count, hand, pointer, pointer_known."),
            .hints =
                {
                    Text::tr("First the points: one that is held goes to `hand`. The first point goes to "
                             "`pointer` if `pointer_known` and it is not held. Then each stick, in order."),
                    Text::tr(
                        "A stick: its error is its length now minus `stick.length`. `stick.a` takes the part "
                        "`stick.share`, and `stick.b` the rest. If one end is held, the other takes all."),
                    Text::tr("With `Vec2 out = direction(stick.b, stick.a);`: `stick.a.position -= error * "
                             "share * out;` and `stick.b.position += error * (1 - share) * out;`"),
                },
            .nearMisses =
                {
                    {"double part_of_a = error;\ndouble part_of_b = error;",
                     Text::tr("The rest is right, but both ends take the whole error."), "parts"},
                    {"for (int i = 1; i < sticks.count; i++)\n    enforce(sticks[i]);",
                     Text::tr("The rest is right, but the first stick is left out. It has the number 0."),
                     "loop"},
                    {"for (int i = sticks.count - 1; i >= 0; i--)\n    enforce(sticks[i]);",
                     Text::tr("The rest is right, but the sticks come in the wrong order."), "loop"},
                },
        },
    };
}

std::vector<CodeTask> verletCodeTasks()
{
    return {
        {
            .id = "move",
            .title = Text::tr("Verlet’s new place"),
            .text = Text::tr("Write the **new place** of a point that falls: gravity adds to its velocity, "
                             "damping takes its share of both, and then it moves."),
            .comment = Text::tr("The point falls, is damped, and moves."),
            .hints =
                {
                    Text::tr("Gravity adds `gravity` to the velocity in y."),
                    Text::tr("Damping comes after gravity, so it takes its share of the sum."),
                    Text::tr("`point.velocity = damp * (point.velocity + Vec2(0, …));` and then the move."),
                },
            .nearMisses =
                {
                    {"point.velocity = damp * point.velocity + Vec2(0, gravity);\npoint.position += "
                     "point.velocity;",
                     Text::tr(
                         "Damping takes its share before gravity. It should take its share of the sum.")},
                    {"point.velocity = damp * point.velocity;\npoint.position += point.velocity;",
                     Text::tr("Nothing falls: gravity is missing.")},
                    {"point.velocity = damp * (point.velocity + Vec2(gravity, 0));\npoint.position += "
                     "point.velocity;",
                     Text::tr("This gravity pulls to the right. Down is y, the second number.")},
                    {"point.position += point.velocity;\npoint.velocity = damp * (point.velocity + Vec2(0, "
                     "gravity));",
                     Text::tr("The point moves by the velocity of the last frame. Move it last.")},
                },
        },
        {
            .id = "came",
            .title = Text::tr("the velocity after the sticks"),
            .text = Text::tr("Sticks and walls have moved the points. Write the **velocity** of each: how "
                             "far it came in this frame."),
            .comment = Text::tr("The velocity of each point: how far it came."),
            .hints =
                {
                    Text::tr("`before` is where a point was when the frame began."),
                    Text::tr("How far a point came is its position now minus the one before."),
                    Text::tr("In a loop: `points[i].velocity = points[i].position - …;`"),
                },
            .nearMisses =
                {
                    {"for (int i = 0; i < points.count; i++)\n    points[i].velocity = points[i].before - "
                     "points[i].position;",
                     Text::tr("The velocity points backwards: it leads from now to before.")},
                    {"for (int i = 0; i < points.count; i++)\n    points[i].velocity += points[i].position - "
                     "points[i].before;",
                     Text::tr("With `+=` each velocity counts twice. Set it with `=`.")},
                },
        },
    };
}

}

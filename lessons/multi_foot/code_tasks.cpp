#include "code_tasks.h"

#include "lessons/multi_foot/text.h"

using namespace lessons;

namespace multi_foot {

std::vector<CodeTask> twoFeetCodeTasks()
{
    return {{
        .id = "both",
        .title = Text::tr("two pulls"),
        .text = Text::tr("Write the **two pulls on the body**, one from each foot. They add up."),
        .comment = Text::tr("Both feet pull the body."),
        .hints =
            {
                Text::tr("`pull(me, anchor)` returns the pull on `me`. It is added to the velocity of `me`."),
                Text::tr("The feet are `feet[0]` and `feet[1]`. Here the body is the one that is pulled."),
                Text::tr("`body.velocity += pull(body, …);` twice."),
            },
        .nearMisses =
            {
                {"body.velocity += pull(body, feet[0]);",
                 Text::tr("Only one foot pulls the body. The other one, `feet[1]`, is missing.")},
                {"body.velocity += pull(body, feet[1]);",
                 Text::tr("Only one foot pulls the body. The other one, `feet[0]`, is missing.")},
                {"body.velocity = pull(body, feet[0]) + pull(body, feet[1]);",
                 Text::tr("The two pulls add up, but `=` forgets the velocity that the body had.")},
                {"body.velocity += pull(feet[0], body);\nbody.velocity += pull(feet[1], body);",
                 Text::tr(
                     "These are the pulls on the feet. The first name in the brackets is the one that is "
                     "pulled.")},
            },
    }};
}

std::vector<CodeTask> anyNumberCodeTasks()
{
    return {
        {
            .id = "loop",
            .title = Text::tr("a loop over the feet"),
            .text =
                Text::tr("Write the **loop** in which every foot pulls the body, however many there are."),
            .comment = Text::tr("Every foot pulls the body."),
            .hints =
                {
                    Text::tr("There are `feet.count` feet. Their numbers begin with 0."),
                    Text::tr("A loop that counts: `for (int i = 0; i < …; i++)`. Inside it, `feet[i]` is one "
                             "foot."),
                    Text::tr("In the loop: `body.velocity += pull(body, feet[i]);`"),
                },
            .nearMisses =
                {
                    {"for (int i = 1; i < feet.count; i++)\n    body.velocity += pull(body, feet[i]);",
                     Text::tr("The loop leaves out the first foot. It has the number 0.")},
                    {"for (int i = 0; i < feet.count - 1; i++)\n    body.velocity += pull(body, feet[i]);",
                     Text::tr("The loop leaves out the last foot.")},
                    {"for (int i = 0; i < feet.count; i++)\n    body.velocity = pull(body, feet[i]);",
                     Text::tr("With `=` each pull replaces the one before. They should add up.")},
                    {"for (int i = 0; i < feet.count; i++)\n    body.velocity += pull(feet[i], body);",
                     Text::tr(
                         "These are the pulls on the feet. The first name in the brackets is the one that is "
                         "pulled.")},
                    {"for (int i = 0; i < feet.count; i++)\n    body.velocity += pull(body, feet[0]);",
                     Text::tr("The same foot pulls each time. Use `feet[i]`.")},
                },
        },
        {
            .id = "follow",
            .title = Text::tr("a body in your hand"),
            .text = Text::tr(
                "Write the function **follow** for a body that is held: it goes where your hand is, and "
                "can be thrown."),
            .comment = Text::tr("me is held by the hand."),
            .hints =
                {
                    Text::tr(
                        "The velocity is how far the hand moved in this frame: from where `me` still is to "
                        "`hand`."),
                    Text::tr("Set the velocity before the position changes."),
                    Text::tr("`me.velocity = hand - …;` and then `me.position = …;`"),
                },
            .nearMisses =
                {
                    {"me.position = hand;\nme.velocity = hand - me.position;",
                     Text::tr("`me` has already moved when you take the difference, so its velocity is 0 and "
                              "it cannot "
                              "be thrown. Swap the two lines.")},
                    {"me.position = hand;",
                     Text::tr("`me` follows the hand, but keeps the velocity from before. Your throw has no "
                              "effect.")},
                    {"me.velocity = hand - me.position;\nme.position += me.velocity * damp;",
                     Text::tr("`me` lags behind the hand. While it is held, nothing damps it.")},
                },
        },
    };
}

std::vector<CodeTask> grownFeetCodeTasks()
{
    return {{
        .id = "frame",
        .title = Text::tr("the whole frame"),
        .text = Text::tr(
            "**From the empty page:** write the whole frame of a body with any number of feet. The hand "
            "comes first, then each foot, and the body last."),
        .comment =
            Text::tr("Write the whole frame. The names: body, feet[i] (each with position, velocity and "
                     "held), feet.count, hand, k, damp, radius. Functions of your own stand above frame."),
        .hints =
            {
                Text::tr("Three functions help: `pull(me, anchor)` returns the pull on `me`, `follow(me)` is "
                         "for a body "
                         "that is held, and `move(me)` damps and moves."),
                Text::tr("The order: if the body is held, it follows. Then a loop: each foot follows if it "
                         "is held; "
                         "if not, it is pulled by the body and moves. Then the body, if it is not held: all "
                         "pulls, "
                         "and one move."),
                Text::tr(
                    "`Vec2 pull(Body me, Body anchor)` returns `k * (target - me.position)`. Its target is "
                    "`anchor.position + radius * Vec2(cos(angle), sin(angle))`, with the angle of "
                    "`me.position - anchor.position`."),
            },
        .nearMisses =
            {
                {"Vec2 from = anchor.position - me.position;\ndouble angle = atan2(from.y, from.x);\n"
                 "Vec2 target = anchor.position + radius * Vec2(cos(angle), sin(angle));\n"
                 "return k * (target - me.position);",
                 Text::tr("The rest is right, but each target is on the far side of the body that pulls."),
                 "pull"},
                {"return k * (anchor.position - me.position);",
                 Text::tr(
                     "The rest is right, but the springs pull the bodies onto each other. They should stay "
                     "`radius` px apart."),
                 "pull"},
                {"Vec2 from = me.position - anchor.position;\ndouble angle = atan2(from.y, from.x);\n"
                 "Vec2 target = anchor.position + radius * Vec2(cos(angle), sin(angle));\n"
                 "return k * (me.position - target);",
                 Text::tr("The rest is right, but every pull points away from its target."), "pull"},
            },
    }};
}

}

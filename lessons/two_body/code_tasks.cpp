#include "code_tasks.h"

#include "lessons/two_body/text.h"

using namespace lessons;

namespace two_body {

std::vector<CodeTask> mutualCodeTasks()
{
    return {
        {
            .id = "opposite",
            .title = Text::tr("the opposite pull"),
            .text =
                Text::tr("Write the **opposite pull**: the spring also pulls the body, to its place at the "
                         "distance **radius** from the foot."),
            .comment = Text::tr("The spring pulls the body, too."),
            .hints =
                {
                    Text::tr("It is the line of the foot, with the two bodies swapped."),
                    Text::tr("`nearest(body, foot)` is the place at the right distance from the foot that is "
                             "nearest to the body."),
                    Text::tr("`body.velocity += k * (nearest(…, …) - body.position);`"),
                },
            .nearMisses =
                {
                    {"body.velocity -= k * (nearest(body, foot) - body.position);",
                     Text::tr(
                         "The pull points away from the body’s place. A pull leads from where a body is to "
                         "where it should be, and is added.")},
                    {"body.velocity += k * (nearest(foot, body) - foot.position);",
                     Text::tr("This is the pull on the foot. The body would go the same way as the foot, and "
                              "they would never meet.")},
                    {"body.velocity += k * (nearest(foot, body) - body.position);",
                     Text::tr("`nearest(foot, body)` is the place of the foot. Swap the two bodies.")},
                    {"body.velocity += k * (foot.position - body.position);",
                     Text::tr("This pulls the body onto the foot. It should stay `radius` px away.")},
                },
        },
        {
            .id = "nearest",
            .title = Text::tr("the nearest place"),
            .text = Text::tr(
                "Write the function **nearest**: it returns the place at the distance **radius** from "
                "`anchor` that is nearest to `me`."),
            .comment = Text::tr("Return the place on the ring around anchor."),
            .hints =
                {
                    Text::tr("The place is in the direction of `me`, seen from `anchor`."),
                    Text::tr("The angle of a vector is `atan2(y, x)`, and `Vec2(cos(angle), sin(angle))` is "
                             "a step "
                             "of 1 px in its direction."),
                    Text::tr("`Vec2 from = me.position - anchor.position;`\n\n`double angle = …;`\n\n`return "
                             "anchor.position + …;`"),
                },
            .nearMisses =
                {
                    {"Vec2 from = anchor.position - me.position;\ndouble angle = atan2(from.y, from.x);\n"
                     "return anchor.position + radius * Vec2(cos(angle), sin(angle));",
                     Text::tr(
                         "The place is on the far side of `anchor`. The direction has to lead from `anchor` "
                         "to `me`.")},
                    {"Vec2 from = me.position - anchor.position;\ndouble angle = atan2(from.y, from.x);\n"
                     "return me.position + radius * Vec2(cos(angle), sin(angle));",
                     Text::tr("The place is `radius` px from `me`. Start at `anchor`.")},
                    {"return anchor.position;",
                     Text::tr("The place is on `anchor` itself. It should be `radius` px away.")},
                },
        },
    };
}

std::vector<CodeTask> legLineCodeTasks()
{
    return {{
        .id = "frame",
        .title = Text::tr("the whole frame"),
        .text = Text::tr(
            "**From the empty page:** write the whole frame. Hold and throw both bodies. The foot is "
            "pulled and moves first, and then the body, which sees the foot where it already is."),
        .comment =
            Text::tr("Write the whole frame. The names: body, foot (each with position, velocity and held), "
                     "hand, k, damp, radius. A function nearest(me, anchor) can find the place on a ring."),
        .hints =
            {
                Text::tr("Begin with the hand: a held body goes to the hand, and its velocity is how far "
                         "the hand "
                         "moved. Do this for both bodies first."),
                Text::tr("Then the foot, if it is not held: pull, damping, move. Then the same for the body, "
                         "if it "
                         "is not held."),
                Text::tr(
                    "`Vec2 nearest(Body me, Body anchor)` above `frame` returns the target. The pull is "
                    "`k * (nearest(foot, body) - foot.position)`, and for the body the other way round."),
            },
        .nearMisses =
            {
                {"foot.position = hand;",
                 Text::tr("The rest is right, but the foot cannot be thrown: while you hold it, its velocity "
                          "has to be "
                          "how far the hand moved."),
                 "hand"},
                {"foot.position += foot.velocity;\nfoot.velocity *= damp;",
                 Text::tr("The rest is right, but the foot moves before damping takes its share."), "foot"},
                {"body.velocity -= k * (nearest(body, foot) - body.position);",
                 Text::tr("The rest is right, but the pull on the body points away from its place."), "body"},
            },
    }};
}

}

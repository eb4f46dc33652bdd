#include "code_tasks.h"

#include "lessons/single_spring/text.h"

using namespace lessons;

namespace single_spring {

std::vector<CodeTask> dragCodeTasks()
{
    return {{
        .id = "throw",
        .title = Text::tr("the throw"),
        .text = Text::tr("Write what the foot does **while you hold it**: it goes where your hand is. Its "
                         "velocity is how far the hand moved in this frame."),
        .comment = Text::tr("The foot is held: set its velocity and its position."),
        .hints =
            {
                Text::tr("The foot is still where the hand was in the last frame. Now the hand is at "
                         "`hand`. The velocity is the difference."),
                Text::tr("Two lines: first the velocity, then the position. After the move the difference "
                         "would be 0."),
                Text::tr("`foot.velocity = hand - …;` and then `foot.position = …;`"),
            },
        .nearMisses =
            {
                {"foot.position = hand;\nfoot.velocity = hand - foot.position;",
                 Text::tr("The foot has no velocity when you let go, so you cannot throw it. Take the "
                          "difference before the foot moves.")},
                {"foot.velocity = foot.position - hand;\nfoot.position = hand;",
                 Text::tr("The velocity points backwards: from the hand to where the foot was. It flies away "
                          "from your throw.")},
                {"foot.velocity += hand - foot.position;\nfoot.position = hand;",
                 Text::tr("With `+=` the velocity grows in each frame that you hold the foot. Set it with "
                          "`=`.")},
            },
    }};
}

std::vector<CodeTask> fixedCentreCodeTasks()
{
    return {{
        .id = "pull",
        .title = Text::tr("the pull of the spring"),
        .text =
            Text::tr("Write the **pull of the spring**: add **k** times the missing distance to the foot’s "
                     "velocity."),
        .comment = Text::tr("The spring pulls the foot towards the centre."),
        .hints =
            {
                Text::tr("The missing distance is a vector that points from the foot to the centre."),
                Text::tr("A difference of two places points from the second to the first: `a - b` leads from "
                         "b to a."),
                Text::tr("`foot.velocity += k * (… - …);` with `centre` and `foot.position`."),
            },
        .nearMisses =
            {
                {"foot.velocity += k * (foot.position - centre);",
                 Text::tr("The pull points away from the centre. Swap the two places of the difference.")},
                {"foot.velocity = k * (centre - foot.position);",
                 Text::tr(
                     "With `=` the foot forgets the velocity that it had, so it never swings. The pull is "
                     "added with `+=`.")},
                {"foot.velocity += centre - foot.position;",
                 Text::tr("The direction is right, but the pull is the whole distance. Multiply it by `k`.")},
                {"foot.position += k * (centre - foot.position);",
                 Text::tr(
                     "This moves the foot by the pull. A pull changes the velocity, and the velocity moves "
                     "the foot.")},
            },
    }};
}

std::vector<CodeTask> movingBodyCodeTasks()
{
    return {{
        .id = "move",
        .title = Text::tr("damping and the move"),
        .text =
            Text::tr("The spring has pulled. Write the **end of the frame**: damping takes its share of the "
                     "velocity, and then the foot moves."),
        .comment = Text::tr("Damping, and then the move."),
        .hints =
            {
                Text::tr("After damping, the velocity is `damp` times what it was."),
                Text::tr("A velocity is the distance for one frame, so the move adds the velocity to the "
                         "position."),
                Text::tr("`foot.velocity *= …;` and then `foot.position += …;`"),
            },
        .nearMisses =
            {
                {"foot.position += foot.velocity;\nfoot.velocity *= damp;",
                 Text::tr("The foot moves before damping takes its share. It should move by the damped "
                          "velocity: swap the two lines.")},
                {"foot.position += foot.velocity;",
                 Text::tr("The foot moves, but nothing takes speed away. Damping is missing.")},
                {"foot.velocity *= 1 - damp;\nfoot.position += foot.velocity;",
                 Text::tr("`damp` is the share that the foot keeps, not the share that it loses.")},
                {"foot.position += foot.velocity * damp;",
                 Text::tr("The foot moves by the damped velocity, but keeps the undamped one for the next "
                          "frame. Change `foot.velocity` itself.")},
            },
    }};
}

std::vector<CodeTask> offsetCodeTasks()
{
    return {{
        .id = "target",
        .title = Text::tr("the target with an offset"),
        .text =
            Text::tr("Write the **target** of the spring: the place **offset** px to the right of the body."),
        .comment = Text::tr("Vec2 target: the place where the spring ends."),
        .hints =
            {
                Text::tr("Begin with the position of the body. Right means a larger x. y stays."),
                Text::tr("`Vec2 target = …;` makes a variable. You can change its `x` afterwards."),
                Text::tr("`Vec2 target = body.position;` and then `target.x += …;`"),
            },
        .nearMisses =
            {
                {"Vec2 target = body.position;\ntarget.x -= offset;",
                 Text::tr("The target is on the left of the body. x grows to the right.")},
                {"Vec2 target = body.position;\ntarget.y += offset;",
                 Text::tr("The target is below the body: y points down. Change its x.")},
                {"Vec2 target = body.position;",
                 Text::tr("The target is on the body itself. Add the offset.")},
                {"Vec2 target = foot.position;\ntarget.x += offset;",
                 Text::tr(
                     "The target moves along with the foot, so the foot never gets there. Begin with the "
                     "position of the body.")},
            },
    }};
}

std::vector<CodeTask> radialCodeTasks()
{
    return {
        {
            .id = "target",
            .title = Text::tr("the target in any direction"),
            .text = Text::tr(
                "Write the **target in any direction**: the place at the distance **radius** from the "
                "body, in the direction in which the foot is."),
            .comment = Text::tr("Vec2 target: the nearest place on the ring."),
            .hints =
                {
                    Text::tr(
                        "First find the direction: the vector from the body to the foot. `atan2` makes an "
                        "angle of its y and its x."),
                    Text::tr(
                        "`Vec2(cos(angle), sin(angle))` is a step of 1 px at that angle. Make it `radius` "
                        "times as long, and start at the body."),
                    Text::tr("`Vec2 from = foot.position - body.position;`\n\n`double angle = atan2(from.y, "
                             "from.x);`\n\n`Vec2 target = body.position + radius * …;`"),
                },
            .nearMisses =
                {
                    {"Vec2 from = body.position - foot.position;\ndouble angle = atan2(from.y, from.x);\n"
                     "Vec2 target = body.position + radius * Vec2(cos(angle), sin(angle));",
                     Text::tr(
                         "The target is on the other side of the body. The direction has to lead from the "
                         "body to the foot.")},
                    {"Vec2 from = foot.position - body.position;\ndouble angle = atan2(from.x, from.y);\n"
                     "Vec2 target = body.position + radius * Vec2(cos(angle), sin(angle));",
                     Text::tr("x and y are swapped: `atan2` takes y first, and `cos` belongs to x.")},
                    {"Vec2 from = foot.position - body.position;\ndouble angle = atan2(from.y, from.x);\n"
                     "Vec2 target = radius * Vec2(cos(angle), sin(angle));",
                     Text::tr(
                         "The ring is around the top left corner of the picture. Add the position of the "
                         "body.")},
                    {"Vec2 target = body.position;",
                     Text::tr("The target is on the body itself. It should be `radius` px away from it.")},
                },
        },
        {
            .id = "frame",
            .title = Text::tr("the whole frame"),
            .text = Text::tr(
                "**From the empty page:** write the whole frame. You can carry the body. You can carry and "
                "throw the foot, and its spring ends on the ring around the body."),
            .comment = Text::tr("Write the whole frame. The names: body, foot (each with position, velocity "
                                "and held), hand, k, damp, radius."),
            .hints =
                {
                    Text::tr(
                        "Begin with the hand: `if (body.held)` the body goes to the hand. `if "
                        "(foot.held)` the foot does too, and its velocity is how far the hand moved. What "
                        "comes then happens only if the foot is not held."),
                    Text::tr("In `else`: find the target on the ring, add the pull to the velocity, damp the "
                             "velocity, and move the foot."),
                    Text::tr(
                        "The target: `body.position + radius * Vec2(cos(angle), sin(angle))`, with the angle "
                        "of `foot.position - body.position`. The pull: `k * (target - foot.position)`."),
                },
            .nearMisses =
                {
                    {"foot.position = hand;",
                     Text::tr("The rest is right, but the foot cannot be thrown: while you hold it, its "
                              "velocity has to "
                              "be how far the hand moved."),
                     "hand"},
                    {"Vec2 from = body.position - foot.position;\ndouble angle = atan2(from.y, from.x);\n"
                     "Vec2 target = body.position + radius * Vec2(cos(angle), sin(angle));",
                     Text::tr("The rest is right, but the target is on the other side of the body."),
                     "target"},
                    {"Vec2 target = body.position;",
                     Text::tr("The rest is right, but the target is on the body itself. It should be "
                              "`radius` px away "
                              "from it."),
                     "target"},
                },
        },
    };
}

}

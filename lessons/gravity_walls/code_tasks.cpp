#include "code_tasks.h"

#include "lessons/gravity_walls/text.h"

using namespace lessons;

namespace gravity_walls {

std::vector<CodeTask> wallsCodeTasks()
{
    return {
        {
            .id = "wall",
            .title = Text::tr("the bounce at a wall"),
            .text = Text::tr("Write the **bounce at the right wall**: if the edge of the disc is past the "
                             "wall, put the disc back, and turn its velocity round."),
            .comment = Text::tr("If the disc is past the right wall: put it back, and let it bounce."),
            .hints =
                {
                    Text::tr("The disc touches the wall when its middle is `me.radius` away from `right`."),
                    Text::tr("In the `if` are two lines: one sets `me.position.x`, the other turns "
                             "`me.velocity.x` round and keeps the share `bounce` of it."),
                    Text::tr("`if (me.position.x > right - …)`, and in it `me.position.x = …;` and "
                             "`me.velocity.x *= -…;`"),
                },
            .nearMisses =
                {
                    {"if (me.position.x > right)\n{\n    me.position.x = right;\n    me.velocity.x *= "
                     "-bounce;\n}",
                     Text::tr("Half of the disc is inside the wall: the middle of the disc bounces, not its "
                              "edge. Use `me.radius`.")},
                    {"if (me.position.x > right - me.radius)\n{\n    me.position.x = right - me.radius;\n    "
                     "me.velocity.x *= bounce;\n}",
                     Text::tr("The velocity still points into the wall. A minus turns it round.")},
                    {"if (me.position.x > right - me.radius)\n    me.velocity.x *= -bounce;",
                     Text::tr(
                         "The velocity turns round, but the disc is still past the wall. Put it back, too.")},
                    {"if (me.position.x > right - me.radius)\n    me.position.x = right - me.radius;",
                     Text::tr("The disc is put back, but its velocity still points into the wall.")},
                    {"if (me.position.x > right - me.radius)\n{\n    me.position.x = right - me.radius;\n    "
                     "me.velocity *= -bounce;\n}",
                     Text::tr(
                         "The whole velocity turns round. Only the part across the wall does, which is x.")},
                },
        },
        {
            .id = "floor",
            .title = Text::tr("the bounce on the floor"),
            .text = Text::tr("Write the **bounce on the floor**, for a disc whose edge is below `floor`."),
            .comment = Text::tr("If the disc is below the floor: put it back, and let it bounce."),
            .hints =
                {
                    Text::tr("It is the bounce at the wall, with y in place of x. y points down."),
                    Text::tr("The disc touches the floor when its middle is `me.radius` above `floor`: at "
                             "`floor - me.radius`."),
                    Text::tr("`if (me.position.y > …)`, and in it `me.position.y = …;` and `me.velocity.y *= "
                             "-…;`"),
                },
            .nearMisses =
                {
                    {"if (me.position.y > floor)\n{\n    me.position.y = floor;\n    me.velocity.y *= "
                     "-bounce;\n}",
                     Text::tr("Half of the disc is below the floor. Use `me.radius`.")},
                    {"if (me.position.y > floor - me.radius)\n    me.velocity.y *= -bounce;",
                     Text::tr("The velocity turns round, but the disc is still below the floor. Put it back, "
                              "too.")},
                    {"if (me.position.y > floor - me.radius)\n    me.position.y = floor - me.radius;",
                     Text::tr("The disc is put back, but its velocity still points down.")},
                    {"if (me.position.y < floor - me.radius)\n{\n    me.position.y = floor - me.radius;\n    "
                     "me.velocity.y *= -bounce;\n}",
                     Text::tr("This happens above the floor. y points down, so what is below the floor has "
                              "the larger y.")},
                },
        },
    };
}

std::vector<CodeTask> gravityCodeTasks()
{
    return {
        {
            .id = "gravity",
            .title = Text::tr("gravity"),
            .text = Text::tr("Write the line for **gravity**: in each frame it adds the same velocity to "
                             "every body, downwards."),
            .comment = Text::tr("Gravity pulls me down."),
            .hints =
                {
                    Text::tr("Gravity is one more pull, so it changes the velocity."),
                    Text::tr("It pulls down only, and y points down."),
                    Text::tr("`me.velocity.y += …;`"),
                },
            .nearMisses =
                {
                    {"me.velocity.y -= gravity;",
                     Text::tr("The bodies fall upwards. y points down, so a pull down is added to y.")},
                    {"me.position.y += gravity;",
                     Text::tr("The bodies sink at the same speed for ever. Gravity changes the velocity, and "
                              "what falls gets faster.")},
                    {"me.velocity.x += gravity;", Text::tr("This gravity pulls to the right. Down is y.")},
                    {"me.velocity.y = gravity;",
                     Text::tr("With `=` the body forgets how fast it fell already.")},
                },
        },
        {
            .id = "frame",
            .title = Text::tr("the whole frame"),
            .text = Text::tr("**From the empty page:** write the whole frame of a body with feet in a room, "
                             "with springs, gravity, damping and three walls."),
            .comment = Text::tr(
                "Write the whole frame. The names: body, feet[i] (each with position, velocity, radius, "
                "held), feet.count, hand, k, damp, radius, gravity, bounce, left, right, floor."),
            .hints =
                {
                    Text::tr("The frame is that of lesson 3: the body follows if it is held, then each foot, "
                             "then the body. New is only how a body moves."),
                    Text::tr("To move: add gravity, damp, move. Then three walls: the right one, the left "
                             "one and the floor. There is no ceiling."),
                    Text::tr("A wall: `if (me.position.x > right - me.radius)`, then `me.position.x = right "
                             "- me.radius;` and `me.velocity.x *= -bounce;`"),
                },
            .nearMisses =
                {
                    {"", Text::tr("The rest is right, but gravity is missing."), "gravity"},
                    {"me.velocity.y -= gravity;", Text::tr("The rest is right, but the bodies fall upwards."),
                     "gravity"},
                    {"return k * (me.position - target);",
                     Text::tr("The rest is right, but every pull points away from its target."), "pull"},
                },
        },
    };
}

}

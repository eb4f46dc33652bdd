#include "code_tasks.h"

#include "lessons/walking_gait/text.h"

using namespace lessons;

namespace walking_gait {

std::vector<CodeTask> bonesCodeTasks()
{
    return {
        {
            .id = "target",
            .title = Text::tr("where a foot belongs"),
            .text = Text::tr("Write where the foot belongs: **leg** px from the body, in the direction that "
                             "`angle` tells. At the angle 0 it is on the left."),
            .comment = Text::tr("Vec2 target: where the foot belongs."),
            .hints =
                {
                    Text::tr("`Vec2(cos(angle), sin(angle))` is a step of 1 px at that angle. At 0 it leads "
                             "to the right."),
                    Text::tr("A minus makes it lead the other way."),
                    Text::tr("`Vec2 target = body.position - …;`"),
                },
            .nearMisses =
                {
                    {"Vec2 target = body.position + leg * Vec2(cos(angle), sin(angle));",
                     Text::tr(
                         "The feet are swapped: at the angle 0 the foot belongs on the left. Subtract.")},
                    {"Vec2 target = body.position - Vec2(cos(angle), sin(angle));",
                     Text::tr("The foot is only 1 px away from the body. Multiply by `leg`.")},
                    {"Vec2 target = body.position - leg * Vec2(sin(angle), cos(angle));",
                     Text::tr("`cos` and `sin` are swapped: `cos` belongs to x.")},
                },
        },
    };
}

std::vector<CodeTask> swingCodeTasks()
{
    return {
        {
            .id = "target",
            .title = Text::tr("the target of a swinging foot"),
            .text = Text::tr("Write the **target of a swinging foot**: as before, but the clock `gait` turns "
                             "the angle, and the place is **drop** px lower."),
            .comment = Text::tr("Vec2 target: the place goes round the body, drop px below it."),
            .hints =
                {
                    Text::tr("The clock is an angle, too. Add it to the angle of the bone."),
                    Text::tr("Down is a larger y: change `target.y` in the end."),
                    Text::tr("`Vec2 target = body.position - leg * Vec2(cos(angle + …), sin(…));` and "
                             "`target.y += …;`"),
                },
            .nearMisses =
                {
                    {"double turned = angle - gait;\nVec2 target = body.position - leg * Vec2(cos(turned), "
                     "sin(turned));\ntarget.y += drop;",
                     Text::tr("The feet go round backwards. Add the clock to the angle.")},
                    {"double turned = angle;\nVec2 target = body.position - leg * Vec2(cos(turned), "
                     "sin(turned));\ntarget.y += drop;",
                     Text::tr("The feet stand still: the clock `gait` is missing.")},
                    {"double turned = angle + gait;\nVec2 target = body.position - leg * Vec2(cos(turned), "
                     "sin(turned));",
                     Text::tr("The feet go round the body itself. They belong `drop` px lower.")},
                    {"double turned = angle + gait;\nVec2 target = body.position - leg * Vec2(cos(turned), "
                     "sin(turned));\ntarget.y -= drop;",
                     Text::tr("The feet go round above the body. y points down.")},
                },
        },
    };
}

std::vector<CodeTask> bodyPulledCodeTasks()
{
    return {
        {
            .id = "forces",
            .title = Text::tr("force and opposite force"),
            .text = Text::tr("Write the **two sides of a force**: the foot feels `force`, and the body feels "
                             "the opposite. What your hand holds feels nothing."),
            .comment = Text::tr("The foot feels the force, the body the opposite one."),
            .hints =
                {
                    Text::tr("A force changes the velocity of what feels it."),
                    Text::tr("The opposite of a vector has a minus. Each line needs an `if`: what is held "
                             "keeps its velocity."),
                    Text::tr("`if (!foot.held) foot.velocity += …;` and for the body `-=`."),
                },
            .nearMisses =
                {
                    {"if (!foot.held)\n    foot.velocity += force;\nif (!body.held)\n    body.velocity += "
                     "force;",
                     Text::tr("The body feels the same force as the foot, so both go the same way. It has to "
                              "feel the opposite.")},
                    {"if (!foot.held)\n    foot.velocity += force;",
                     Text::tr("The body feels nothing, so it hangs in the air like a handle.")},
                    {"foot.velocity += force;\nbody.velocity -= force;",
                     Text::tr("The force also acts on what your hand holds. Its velocity has to stay that of "
                              "your hand.")},
                    {"if (!foot.held)\n    foot.velocity -= force;\nif (!body.held)\n    body.velocity += "
                     "force;",
                     Text::tr("Both forces are turned round: the foot flees from its target.")},
                },
        },
    };
}

std::vector<CodeTask> groundCodeTasks()
{
    return {
        {
            .id = "ground",
            .title = Text::tr("feet on the ground"),
            .text = Text::tr("Write how the **ground holds a foot** (not the body): put it back, let it "
                             "bounce, and with full traction (`traction == 0`) it does not slide."),
            .comment = Text::tr("If a foot is below the ground: put it back, let it bounce, and hold it."),
            .hints =
                {
                    Text::tr("A point is a foot if `me != body`. It is below the ground if its y is larger "
                             "than `ground`."),
                    Text::tr("After the bounce, its velocity in y is `-bounce` times what it was."),
                    Text::tr(
                        "`if (me.position.y > ground && me != body)`, and in it: set `me.position.y`, then "
                        "`me.velocity.y *= -bounce;`, then `if (traction == 0) me.velocity.x = 0;`"),
                },
            .nearMisses =
                {
                    {"if (me.position.y > ground && me != body)\n{\n    me.position.y = ground;\n    "
                     "me.velocity.y *= -bounce;\n}",
                     Text::tr("The feet slide on the ground as on ice, so the body does not get on. With "
                              "full traction their velocity in x is 0.")},
                    {"if (me.position.y > ground && me != body)\n    me.position.y = ground;",
                     Text::tr("The feet are put back, but they keep their velocity: they slide, and each "
                              "pull starts from a fall.")},
                    {"if (me.position.y > ground && me != body)\n{\n    me.velocity.y *= -bounce;\n    if "
                     "(traction == 0)\n        me.velocity.x = 0;\n}",
                     Text::tr("The feet are held, but below the ground. Put them back.")},
                    {"if (me.position.y < ground && me != body)\n{\n    me.position.y = ground;\n    "
                     "me.velocity.y *= -bounce;\n    if (traction == 0)\n        me.velocity.x = 0;\n}",
                     Text::tr("The feet stick to the ground from the start: this holds what is above it. y "
                              "points down.")},
                },
        },
        {
            .id = "frame",
            .title = Text::tr("the whole frame"),
            .text = Text::tr("**From the empty page:** write the whole frame of a creature that walks: two "
                             "feet, a clock, forces on both sides, gravity, and the ground."),
            .comment = Text::tr(
                "Write the whole frame. The names: body, feet[0], feet[1] (each with position, velocity and "
                "held), hand, gait, speed, leg, drop, k, damp, gravity, ground, bounce, traction (0: full)."),
            .hints =
                {
                    Text::tr("The order of a frame: what is held follows the hand. Then both feet pull. Then "
                             "all three move, the feet first. In the end the clock goes on by `speed`."),
                    Text::tr("The foot 0 has the angle 0, and the foot 1 the angle `pi`. The target is "
                             "`body.position - leg * Vec2(cos(angle + gait), sin(angle + gait))`, `drop` px "
                             "lower. The body feels the opposite force."),
                    Text::tr("To move: gravity, damping, the move, and then the ground. The ground holds "
                             "feet only: `me != body`."),
                },
            .nearMisses =
                {
                    {"", Text::tr("The rest is right, but the clock stands still, so no foot ever moves on."),
                     "clock"},
                    {"gait -= speed;", Text::tr("The rest is right, but the clock runs backwards."), "clock"},
                    {"if (me.position.y > ground && me != body)\n{\n    me.position.y = ground;\n    "
                     "me.velocity.y *= -bounce;\n}",
                     Text::tr("The rest is right, but the feet slide on the ground as on ice."), "ground"},
                },
        },
    };
}

}

#include "code_tasks.h"

#include "lessons/codeling/text.h"

using namespace lessons;

namespace codeling {

std::vector<CodeTask> motorCodeTasks()
{
    return {
        {
            .id = "pull",
            .title = Text::tr("the pull to the target"),
            .text = Text::tr("Write the **pull of the motor**: a spring to the target. Times **dt** twice, "
                             "the tutorial’s time of a frame, it becomes a velocity per frame."),
            .comment = Text::tr("Vec2 pull: the spring to the target."),
            .hints =
                {
                    Text::tr("The missing distance leads from `lead.position` to `target`."),
                    Text::tr("A spring pulls `k` times the missing distance. Multiply by `dt` twice."),
                    Text::tr("`Vec2 pull = k * dt * dt * (… - …);`"),
                },
            .nearMisses =
                {
                    {"Vec2 pull = k * dt * dt * (lead.position - target);",
                     Text::tr(
                         "The pull points away from the target. Swap the two places of the difference.")},
                    {"Vec2 pull = k * dt * (target - lead.position);",
                     Text::tr("The pull is too strong by far: `dt` belongs there twice.")},
                    {"Vec2 pull = k * (target - lead.position);",
                     Text::tr("The pull is too strong by far: `dt` is missing, twice.")},
                },
        },
    };
}

std::vector<CodeTask> orientationCodeTasks()
{
    return {
        {
            .id = "tail",
            .title = Text::tr("a tail that follows"),
            .text = Text::tr("Write **which end gives way**: the tail takes the whole `correction`. But if "
                             "your hand holds the tail, the lead takes it."),
            .comment = Text::tr("Move the tail, or the lead if the tail is held."),
            .hints =
                {
                    Text::tr("`correction` points from the lead to the tail, and is as long as the error."),
                    Text::tr("The tail comes closer with a minus. The lead would come closer with a plus."),
                    Text::tr("`if (tail.held) lead.position += …; else tail.position -= …;`"),
                },
            .nearMisses =
                {
                    {"tail.position -= correction;", Text::tr("While you hold the tail it slips out of your "
                                                              "hand. Then the lead has to give way.")},
                    {"if (tail.held)\n    lead.position -= correction;\nelse\n    tail.position += "
                     "correction;",
                     Text::tr("The correction points the wrong way: the two get apart. The tail needs a "
                              "minus, and the lead a plus.")},
                    {"lead.position += correction;",
                     Text::tr(
                         "The lead gives way, so it drags on the tail. It should be the tail that follows.")},
                    {"if (!tail.held)\n    tail.position -= correction;",
                     Text::tr("While you hold the tail, nothing gives way, and the stick stretches.")},
                },
        },
    };
}

std::vector<CodeTask> anticipationCodeTasks()
{
    return {
        {
            .id = "shift",
            .title = Text::tr("anticipation"),
            .text = Text::tr("Write the **anticipation**: before it goes to a new target, the lead backs up "
                             "by the part **anticipation** of the distance. The shift is a push, too."),
            .comment = Text::tr("The lead backs up: shift its position, and add the shift to its velocity."),
            .hints =
                {
                    Text::tr("Away from the target: from the target to where the lead is."),
                    Text::tr("The shift is `anticipation` times that vector. It is added twice: to the "
                             "position and to the velocity."),
                    Text::tr(
                        "`Vec2 shift = anticipation * (lead.position - …);`, and two lines with `+= shift`."),
                },
            .nearMisses =
                {
                    {"Vec2 shift = anticipation * (new_targets[i] - lead.position);\nlead.position += "
                     "shift;\nlead.velocity += shift;",
                     Text::tr("The lead jumps towards the target. To back up, it has to go the other way.")},
                    {"Vec2 shift = anticipation * (lead.position - new_targets[i]);\nlead.position += shift;",
                     Text::tr("The lead backs up, but the shift gives it no velocity. Add the shift to the "
                              "velocity, too.")},
                    {"Vec2 shift = anticipation * (lead.position - new_targets[i]);\nlead.velocity += shift;",
                     Text::tr("The lead gets a push, but does not jump back. Add the shift to the position, "
                              "too.")},
                    {"Vec2 shift = lead.position - new_targets[i];\nlead.position += shift;\nlead.velocity "
                     "+= shift;",
                     Text::tr("The lead backs up by the whole distance. Multiply by `anticipation`.")},
                },
        },
        {
            .id = "frame",
            .title = Text::tr("the whole frame"),
            .text =
                Text::tr("**From the empty page:** write the whole frame of a swimmer: it backs up before a "
                         "new target, a spring pulls the lead, and the tail follows on a stick."),
            .comment = Text::tr(
                "Write the whole frame. The names: lead, tail (each with position, velocity, held), target, "
                "new_targets[i], new_targets.count, anticipation, k, keep, dt, rest_length, hand."),
            .hints =
                {
                    Text::tr("First the anticipation, for each new target, if the lead is not held. Then the "
                             "lead: in your hand, or damped (`keep`), pulled and moved. Then the tail."),
                    Text::tr("The lead: `lead.velocity *= keep;`, then the pull `k * dt * dt * (target - "
                             "lead.position)`, then the move."),
                    Text::tr("The tail: in your hand it goes to `hand`. The error of the stick is the "
                             "distance minus `rest_length`. Move the tail by it towards the lead. If the "
                             "tail is held, move the lead instead."),
                },
            .nearMisses =
                {
                    {"Vec2 shift = anticipation * (new_targets[i] - lead.position);\nlead.position += "
                     "shift;\nlead.velocity += shift;",
                     Text::tr(
                         "The rest is right, but the lead jumps towards a new target. It should back up."),
                     "shift"},
                    {"Vec2 shift = anticipation * (lead.position - new_targets[i]);\nlead.position += shift;",
                     Text::tr("The rest is right, but backing up gives the lead no velocity. The shift is a "
                              "push, too."),
                     "shift"},
                    {"tail.position -= correction;",
                     Text::tr("The rest is right, but while you hold the tail, the lead has to give way."),
                     "tail"},
                },
        },
    };
}

std::vector<CodeTask> volumeCodeTasks()
{
    return {
        {
            .id = "width",
            .title = Text::tr("the width that keeps the area"),
            .text = Text::tr("Write the **width** that keeps the area: **rest_length** times 30 at rest. "
                             "Count a spine of less than 10 px as 10 px long."),
            .comment = Text::tr("double wanted: the width that keeps the area."),
            .hints =
                {
                    Text::tr("The area is the length times the width, so the width is the area divided by "
                             "the length."),
                    Text::tr("The length is the distance of `lead` and `tail`. `max(…, 10)` is never less "
                             "than 10."),
                    Text::tr("`double wanted = rest_length * 30 / max(length(… - …), 10);`"),
                },
            .nearMisses =
                {
                    {"double wanted = 30;", Text::tr("The width stays 30 px, so a short swimmer has a "
                                                     "smaller area. Half as long has to be twice as wide.")},
                    {"double wanted = 30 * max(length(lead.position - tail.position), 10) / rest_length;",
                     Text::tr("It gets wider as it gets longer. Divide by the length.")},
                    {"double wanted = 30 / max(length(lead.position - tail.position), 10);",
                     Text::tr("This is far too narrow: the area is `rest_length` times 30.")},
                },
        },
    };
}

}

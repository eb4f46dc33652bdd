#include "explanations.h"
#include "lessons/accuracy/text.h"

#include <QCoreApplication>

using lessons::Explanation;

namespace accuracy {

Explanation bigStepExplanation()
{
    return {
        .learnt =
            Text::tr("A computed motion goes straight on within a step, so small steps follow a bend more "
                     "closely, and cost more."),
        .terms =
            {
                {Text::tr("Step"), Text::tr("small steps|smaller steps|once a step|each step|steps of"),
                 Text::tr(
                     "How far in time a method goes at once, in frames. A step of half a frame means two "
                     "of them in each frame.")},
                {Text::tr("Exact motion"), Text::tr("exact motion"),
                 Text::tr("What really would happen, without any steps: the dashed ring shows it.")},
            },
    };
}

Explanation energyExplanation()
{
    return {
        .learnt = Text::tr(
            "A method can make energy from nothing; one that moves by the new velocity does not, in the "
            "long run."),
        .terms =
            {
                {Text::tr("Energy"), Text::tr("energy"),
                 Text::tr("What a stretched spring holds, and what moves holds: half of the square of its "
                          "velocity. One turns into the other. Without damping the sum stays.")},
                {Text::tr("Energy drift"), Text::tr("drift"),
                 Text::tr("Energy that a method adds or loses by itself. The real motion has none.")},
                {Text::tr("Explicit Euler"), Text::tr("Explicit Euler"),
                 Text::tr("The simplest method: everything moves by its old velocity, and is pulled from its "
                          "old place. It gains energy in every swing.")},
                {Text::tr("Velocity Verlet"), Text::tr("Velocity Verlet"),
                 Text::tr("A method of order 2: half of the pull, then the move, then half of the new pull. "
                          "Its steps can be taken back exactly.")},
            },
        .whys =
            {
                {Text::tr("Why does Explicit Euler gain k h² in each step?"),
                 Text::tr(
                     "The energy of one spring is half of\n\n"
                     "`E = v² + k x²`\n\n"
                     "Explicit Euler makes, with a step h,\n\n"
                     "`x → x + h v`\n\n"
                     "`v → v − h k x`\n\n"
                     "Put that into E. The parts with x × v cancel, and what is left is\n\n"
                     "`v² + k x² + h² k (v² + k x²)`\n\n"
                     "So E becomes E × (1 + k h²), wherever the foot is. At k = 0.02 and h = 1: 2 % more in "
                     "each step.")},
            },
    };
}

Explanation halveExplanation()
{
    return {
        .learnt = Text::tr("The order of a method says what halving the step is worth."),
        .terms =
            {
                {Text::tr("Order"), Text::tr("order 1|order 2|order 4|a higher order|every order"),
                 Text::tr(
                     "What halving the step is worth: half of the error for order 1, a quarter for order 2, "
                     "a sixteenth for order 4.")},
                {Text::tr("Runge–Kutta 4"), Text::tr("Runge–Kutta 4"),
                 Text::tr("A method of order 4. It asks for the forces four times in each step, and takes a "
                          "mean of what it hears.")},
            },
        .whys =
            {
                {Text::tr("Why a half, a quarter, a sixteenth?"),
                 Text::tr(
                     "Within a step the real motion bends, and a method bends only a little with it. What it "
                     "misses in one step of length h grows like\n\n"
                     "`h × h` for order 1,\n\n"
                     "`h × h × h` for order 2,\n\n"
                     "and so on: one more h than its order. But a stretch of time needs 1/h steps, and their "
                     "errors add up:\n\n"
                     "`h² × (1/h) = h`\n\n"
                     "One h is used up. So with order p the error over the whole stretch goes like\n\n"
                     "`h^p`\n\n"
                     "and half of h leaves 1/2, 1/4, 1/16 of it for p = 1, 2, 4.")},
            },
    };
}

Explanation adaptExplanation()
{
    return {
        .learnt = Text::tr(
            "A method that compares two answers can choose its own steps: long where little happens, "
            "short where much does."),
        .terms =
            {
                {Text::tr("Tolerance"), Text::tr("tolerance"),
                 Text::tr("The error that a method may make in one of its own steps, in pixels.")},
                {Text::tr("Dormand–Prince"), Text::tr("Dormand–Prince"),
                 Text::tr(
                     "A method that computes each step twice, with order 5 and order 4, and takes shorter "
                     "steps where the two differ too much.")},
            },
    };
}

Explanation bounceExplanation()
{
    return {
        .learnt = Text::tr(
            "A bounce in the middle of a step spoils every order, unless the method looks for the very "
            "moment."),
        .terms =
            {
                {Text::tr("Event finding"), Text::tr("event finding"),
                 Text::tr(
                     "To look back along a step for the moment at which something touched, and to end the "
                     "step there.")},
            },
    };
}

Explanation budgetExplanation()
{
    return {
        .learnt =
            Text::tr("No method is best: it depends on how far off it may be, and on what it may cost."),
    };
}

Explanation crowdExplanation()
{
    return {
        .learnt =
            Text::tr("Twice as many are twice the work, and an effect that is not there costs nothing."),
        .terms =
            {
                {Text::tr("Effect"), Text::tr("effect|effects"),
                 Text::tr(
                     "One thing that acts in a scene: springs, gravity, damping, walls. Only those that a "
                     "scene lists cost time.")},
            },
    };
}

}

#include "explanations.h"

#include <QCoreApplication>

using lessons::Teaching;

namespace accuracy {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Accuracy)
};

Teaching bigStep()
{
    return {
        "big_step",
        Text::tr("A computed motion goes straight on within a step, so small steps follow a bend more "
                 "closely, and cost more."),
        {
            Text::tr(
                "Above the picture, press **Step** and choose **1/8 frame**. Click the number beside "
                "**Frame**, type 100, and press **Enter**. How far off it is stands above the parameters."),
            Text::tr("Choose **2 frames** as step above the picture, press **Space**, and wait."),
            Text::tr("Above the picture, press **Step**, type 5 into the field **Other**, and press "
                     "**Enter**. Then press **Space**."),
            Text::tr("Choose **1 frame** as step. Press **Home**, type 0.02 beside **k**, press **Space**, "
                     "and wait four seconds."),
        },
        {
            {Text::tr("Step"), Text::tr("small steps|smaller steps|once a step|each step|steps of"),
             Text::tr("How far in time a method goes at once, in frames. A step of half a frame means two "
                      "of them in each frame.")},
            {Text::tr("Exact motion"), Text::tr("exact motion"),
             Text::tr("What really would happen, without any steps: the dashed ring shows it.")},
        },
        {}};
}

Teaching energy()
{
    return {
        "energy",
        Text::tr("A method can make energy from nothing; one that moves by the new velocity does not, in the "
                 "long run."),
        {
            Text::tr("Above the picture, press **Method** and choose **Explicit Euler**. Press **Space** "
                     "and watch the drift above the parameters."),
            Text::tr("Choose **Explicit Euler** as method and **1/8 frame** as step. Press **Space** and "
                     "wait."),
            Text::tr("Choose **Velocity Verlet** as method and **1 frame** as step. Press **Space**, and "
                     "stop after frame 200."),
        },
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
        {{Text::tr("Why does Explicit Euler gain k h² in each step?"),
          Text::tr("The energy of one spring is half of\n\n"
                   "`E = v² + k x²`\n\n"
                   "Explicit Euler makes, with a step h,\n\n"
                   "`x → x + h v`\n\n"
                   "`v → v − h k x`\n\n"
                   "Put that into E. The parts with x × v cancel, and what is left is\n\n"
                   "`v² + k x² + h² k (v² + k x²)`\n\n"
                   "So E becomes E × (1 + k h²), wherever the foot is. At k = 0.02 and h = 1: 2 % more in "
                   "each step.")}}};
}

Teaching halve()
{
    return {
        "halve",
        Text::tr("The order of a method says what halving the step is worth."),
        {
            Text::tr("Choose **1/8 frame** as step, type 60 into the frame counter, and read how far off it "
                     "is. Do the same with **1/16 frame**."),
            Text::tr("Choose **Midpoint** as method, then **1/8** and **1/16 frame** as step, and go to "
                     "frame 60 each time."),
            Text::tr("Choose **Runge–Kutta 4** as method, then **1/8** and **1/16 frame** as step, and go to "
                     "frame 60 each time."),
            Text::tr("Runge–Kutta 4 computes four times in a step. In steps of 1/4 frame that is 16 in a "
                     "frame. Go to frame 60."),
        },
        {
            {Text::tr("Order"), Text::tr("order 1|order 2|order 4|a higher order|every order"),
             Text::tr("What halving the step is worth: half of the error for order 1, a quarter for order 2, "
                      "a sixteenth for order 4.")},
            {Text::tr("Runge–Kutta 4"), Text::tr("Runge–Kutta 4"),
             Text::tr("A method of order 4. It asks for the forces four times in each step, and takes a "
                      "mean of what it hears.")},
        },
        {{Text::tr("Why a half, a quarter, a sixteenth?"),
          Text::tr("Within a step the real motion bends, and a method bends only a little with it. What it "
                   "misses in one step of length h grows like\n\n"
                   "`h × h` for order 1,\n\n"
                   "`h × h × h` for order 2,\n\n"
                   "and so on: one more h than its order. But a stretch of time needs 1/h steps, and their "
                   "errors add up:\n\n"
                   "`h² × (1/h) = h`\n\n"
                   "One h is used up. So with order p the error over the whole stretch goes like\n\n"
                   "`h^p`\n\n"
                   "and half of h leaves 1/2, 1/4, 1/16 of it for p = 1, 2, 4.")}}};
}

Teaching adapt()
{
    return {
        "adapt",
        Text::tr("A method that compares two answers can choose its own steps: long where little happens, "
                 "short where much does."),
        {
            Text::tr(
                "Above the picture, press **Tolerance** and choose **0.1 px**. Then type 150 into the frame "
                "counter."),
            Text::tr("Press **Tolerance** and choose **0.001 px**, then press **Home**. Take the foot and "
                     "throw it "
                     "so that it just passes the dot in the middle."),
            Text::tr("Choose **Runge–Kutta 4** as method and **1/4 frame** as step, type 150 into the frame "
                     "counter, and read how far off it is."),
        },
        {
            {Text::tr("Tolerance"), Text::tr("tolerance"),
             Text::tr("The error that a method may make in one of its own steps, in pixels.")},
            {Text::tr("Dormand–Prince"), Text::tr("Dormand–Prince"),
             Text::tr("A method that computes each step twice, with order 5 and order 4, and takes shorter "
                      "steps where the two differ too much.")},
        },
        {}};
}

Teaching bounce()
{
    return {
        "bounce",
        Text::tr("A bounce in the middle of a step spoils every order, unless the method looks for the very "
                 "moment."),
        {
            Text::tr("Choose **1/8 frame** as step, type 200 into the frame counter, and read how far off it "
                     "is."),
            Text::tr("Choose **Dormand–Prince 5(4)** as method, and type 200 into the frame counter."),
            Text::tr("Keep Dormand–Prince. Press **Home**, type 0.5 beside **Bounce**, press **Space**, and "
                     "wait."),
        },
        {{Text::tr("Event finding"), Text::tr("event finding"),
          Text::tr("To look back along a step for the moment at which something touched, and to end the "
                   "step there.")}},
        {}};
}

Teaching budget()
{
    return {
        "budget",
        Text::tr("No method is best: it depends on how far off it may be, and on what it may cost."),
        {
            Text::tr("Choose **1/16 frame** as step, and play to frame 200."),
            Text::tr("Try **Velocity Verlet** with steps of 1/2 frame, or **Runge–Kutta 4** with steps of "
                     "1 frame. Play past frame 200 and let it play on for a moment."),
            Text::tr("Try **Runge–Kutta 4** with steps of 1/2 frame. Play past frame 200 and let it play on "
                     "for a moment."),
        },
        {},
        {}};
}

Teaching crowd()
{
    return {
        "crowd",
        Text::tr("Twice as many are twice the work, and an effect that is not there costs nothing."),
        {
            Text::tr("Type 10000 into the field beside **Creatures**, press **Space**, and wait a moment. "
                     "Then type 20000, and wait again. The panel Effects (**Ctrl+4**) tells how long a frame "
                     "takes."),
            Text::tr("Type 0 into the field beside **Bounce**, press **Space**, and wait. Fewer creatures "
                     "are sooner done."),
            Text::tr("Type 0 into the field beside **Gravity**, press **Space**, and wait two seconds."),
        },
        {{Text::tr("Effect"), Text::tr("effect|effects"),
          Text::tr("One thing that acts in a scene: springs, gravity, damping, walls. Only those that a "
                   "scene lists cost time.")}},
        {}};
}

}

std::vector<Teaching> teaching()
{
    return {bigStep(), energy(), halve(), adapt(), bounce(), budget(), crowd()};
}

}

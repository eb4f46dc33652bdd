#include "steps.h"

#include "checks.h"
#include "explanations.h"
#include "lessons/accuracy/text.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "scenes.h"
#include "sim/run/script/script.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "view.h"

#include <QCoreApplication>

using namespace lessons;

namespace accuracy {

namespace {

/// Returns a step with the settings that all steps of this lesson share. It shows the exact motion in the
/// scene and measures the error.
Step newStep(const char *id, const QString &title, const Exact &exact)
{
    Step step = lessons::makeStep("accuracy", id, title);
    step.view = [](const sim::Scene &scene, const sim::Values &) { return creatureViewWithLegs(scene); };
    step.runOverlays = [exact](const sim::Script &script, const sim::State &state, std::int64_t frame) {
        const sim::Scene scene = script.build(script.values);
        return exactOverlays(*exact, creatureView(scene), script, state, frame);
    };
    step.measures = {errorMeasure(exact)};
    step.method = "semi_implicit_euler";
    return step;
}

Parameter creatures()
{
    Parameter parameter = {
        .id = "creatures",
        .name = Text::tr("Creatures"),
        .help = Text::tr("How many creatures there are."),
        .defaultValue = 200.0,
        .min = 1.0,
        .max = 100'000.0,
        .sliderMin = 1.0,
        .sliderMax = 100'000.0,
        .decimals = 0,
        .isInteger = true,
    };
    parameter.scale = Scale::logarithmic;
    return parameter;
}

Exact newExact()
{
    return std::make_shared<ExactRun>();
}

}

Step bigStep()
{
    const Exact exact = newExact();
    Step step = newStep("big_step", Text::tr("Big step, small step"), exact);
    step.addParameters({stiffness(0.2), damping(1.0)});
    step.narration = Text::tr(
        "A real spring pulls **all the time**. A computed one asks for its pull once a **step**, and goes "
        "straight on until the next. Here a step is one frame.\n\n"
        "Without damping the exact motion is known: a cosine that swings once in 14.05 frames. The dashed "
        "ring "
        "is there. The foot is not: each step turns a bend into a straight line, so it swings a little too "
        "fast, and after 100 frames it is 66 px off.\n\n"
        "More, smaller steps follow the bend more closely, and each one is **work**: the pull has to be "
        "computed anew. You choose the step above the scene.");
    step.explanation = bigStepExplanation();
    step.tries = bigStepTries(exact);
    step.scene = big_step::setUp;
    step.overlays = turningPoints;
    step.measures.push_back(forceEvaluationsMeasure());
    return step;
}

Step energyStep()
{
    const Exact exact = newExact();
    Step step = newStep("energy", Text::tr("Energy that grows"), exact);
    step.addParameters({stiffness(0.02), damping(1.0)});
    step.narration = Text::tr(
        "Motion has energy, and so has a stretched spring. Without damping **their sum never changes**. "
        "**Drift** is what the method adds to it.\n\n"
        "**Explicit Euler** moves by the old velocity, and pulls by the old place. Each step multiplies the "
        "energy by exactly 1 + k h², whatever the motion: at k = 0.02 and h = 1 by 1.02. That doubles it "
        "every "
        "35 frames. A smaller step only takes longer.\n\n"
        "**Semi-implicit Euler** moves by the new velocity. One line in another place, the same work: now "
        "the "
        "energy swings 7 % round the true one, for ever, and never runs away. **Verlet** methods swing only "
        "half a percent.");
    step.explanation = energyExplanation();
    step.tries = energyTries(exact);
    step.scene = energy::setUp;
    step.overlays = turningPoints;
    step.measures.insert(step.measures.begin(), driftMeasure(exact));
    return step;
}

Step halveStep()
{
    const Exact exact = newExact();
    Step step = newStep("halve", Text::tr("Halve the step"), exact);
    step.addParameters({stiffness(0.2), damping(0.97), radius()});
    step.narration = Text::tr(
        "Half the step is twice the work. What do you get for it?\n\n"
        "A method of **order 1** gets half the error. **Order 2**: a quarter. **Order 4**: a sixteenth. "
        "The order says nothing about one step alone; it says what halving is worth.\n\n"
        "Runge–Kutta 4 asks for the forces four times a step, Semi-implicit Euler once. Yet with 8 "
        "computations a frame the one is 0.13 px off at frame 60, and the other 0.44 px. With 64, it "
        "is 0.00003 px against 0.05.\n\n"
        "Steps must be small enough first: at 2 frames both are far off.\n\n"
        "The **Accuracy** plot (Measure, at the top) shows a method as a ladder: three of them, or all by "
        "**Show all methods**. Steeper is a higher order.");
    step.explanation = halveExplanation();
    step.tries = halveTries(exact, step.defaultValues());
    step.scene = halve::setUp;
    step.measures.push_back(forceEvaluationsMeasure());
    return step;
}

Step adaptStep()
{
    const Exact exact = newExact();
    Step step = newStep("adapt", Text::tr("Steps that adapt"), exact);
    step.addParameters({stiffness(0.02), damping(1.0), radius()});
    step.narration = Text::tr(
        "This foot falls past the middle, closely. Far out little happens, and a step could be long. At the "
        "middle its spring turns round in less than a frame: only there are small steps needed.\n\n"
        "**Dormand–Prince** chooses. It computes each step twice at once, with order 5 and order 4. If the "
        "two "
        "differ by more than the **tolerance**, the step was too long, and it tries a shorter one.\n\n"
        "Watch **its step**: almost 4 frames far out, less than half a frame in the middle. The tolerance is "
        "for one step; errors add up on the way, so after 150 frames more than 0.001 px is missing.");
    step.method = "dormand_prince";
    step.explanation = adaptExplanation();
    step.tries = adaptTries(exact, step.defaultValues());
    step.scene = adapt::setUp;
    step.overlays = turningRings;
    step.view = smallBodyView;
    step.measures.push_back(stepMeasure());
    step.measures.push_back(forceEvaluationsMeasure());
    return step;
}

Step bounceStep()
{
    const Exact exact = newExact();
    Step step = newStep("bounce", Text::tr("A bounce"), exact);
    step.addParameters({lessons::gravity(), lessons::bounce(), damping(1.0)});
    step.addParameters(room());
    step.narration = Text::tr(
        "Between two bounces a ball flies a parabola, and Runge–Kutta 4 computes that **without any error**. "
        "But it is first at the floor after 30.66 frames, in the middle of a step. The step ends in the "
        "floor, "
        "and only then the ball is put back. That mistake is as big as a step is long: **at a bounce every "
        "order is 1**.\n\n"
        "Dormand–Prince looks back along its step, finds the moment of the touch, ends the step there, turns "
        "the velocity round, and goes on. This is called **event finding**.\n\n"
        "With a bounce of 0.5 each flight takes half as long as the one before. Infinitely many fit into 92 "
        "frames. So a ball that hardly leaves the floor is put to rest.");
    step.method = "rk4";
    step.explanation = bounceExplanation();
    step.tries = bounceTries(exact, step.defaultValues());
    step.scene = accuracy::bounce::setUp;
    step.view = ballInRoomView;
    step.runOverlays = [exact](const sim::Script &script, const sim::State &state, std::int64_t frame) {
        return exactOverlays(*exact, ballView(script.values), script, state, frame);
    };
    step.measures.push_back(driftMeasure(exact));
    step.measures.push_back(forceEvaluationsMeasure());
    return step;
}

Step budgetStep()
{
    const Exact exact = newExact();
    Step step = newStep("budget", Text::tr("The budget"), exact);
    step.addParameters({stiffness(0.1), damping(0.97), radius()});
    step.narration = Text::tr(
        "No method is best. The question is: **how far off may it be, and what may it cost?** A game that "
        "moves 10 000 creatures 60 times a second has 1.7 µs for each, and more to do.\n\n"
        "Here you may be 1 px off, and spend **half a microsecond** a frame. The way you start with is "
        "cheap, "
        "and 15 px off. Small steps of it are exact, and dear. Which method, with which step?\n\n"
        "When you come to frame 200 the program compares your run with the exact one, and times it on this "
        "machine, several times over. Nothing else may be changed. On a busy machine it may need another "
        "try, "
        "so let it play on.\n\n"
        "**Measure** (at the top), then **Show all methods**: click a mark to use it.");
    step.explanation = budgetExplanation();
    step.tries = budgetTries(step.defaultValues());
    step.scene = budget::setUp;
    step.measures.push_back(forceEvaluationsMeasure());
    return step;
}

Step crowdStep()
{
    Step step = lessons::makeStep("accuracy", "crowd", Text::tr("A crowd"));
    step.addParameters(
        {creatures(), lessons::gravity(), lessons::bounce(), stiffness(0.2), damping(0.85), radius()});
    step.narration = Text::tr(
        "**Twice as many creatures are twice the work.** They do not feel each other, so each is the same "
        "again: "
        "6 points, and 10 pulls in every step. Such a cost is called **linear**. It is the best that one can "
        "hope for: were everybody to feel everybody, twice as many would be four times the work.\n\n"
        "At 30 frames a second there are 33 ms for each frame. Where that is not enough, the run plays "
        "slower, and "
        "stays the same run.\n\n"
        "Each **effect** in the list has its price, and one that is not in it costs nothing. Neither does "
        "one "
        "that can change nothing, as a gravity of 0: it is left out.\n\n"
        "**Equal things lie side by side** in memory: all bodies, all first feet, all second feet. So the "
        "processor works on several creatures at once.");
    step.method = "semi_implicit_euler";
    step.explanation = crowdExplanation();
    step.tries = crowdTries();
    step.scene = crowd::setUp;
    step.view = crowdView;
    return step;
}

}

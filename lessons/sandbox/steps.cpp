#include "steps.h"

#include "lessons/api/parameters.h"
#include "scenes.h"
#include "sim/effects/all_effects.h"
#include "sim/run/script/script.h"
#include "view.h"

#include <QCoreApplication>

using namespace lessons;

namespace sandbox {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Sandbox)
};

Example example(const char *file, const QString &title, const QString &help)
{
    return {
        .title = title,
        .help = help,
        .file = QStringLiteral(":/examples/sandbox/%1.json").arg(QLatin1String(file)),
    };
}

/// Returns the experiments that are installed with the program.
std::vector<Example> examples()
{
    return {
        example("chain", Text::tr("Chain"),
                Text::tr("Seven sticks on a nail. Pull the end aside and let go.")),
        example("bridge", Text::tr("Bridge"),
                Text::tr("A truss between two nails, with a load on a spring. Make the load heavier.")),
        example("jelly", Text::tr("Jelly"), Text::tr("A grid of springs. Throw it into a corner.")),
        example("walker", Text::tr("Walker"),
                Text::tr("Four feet in two gait groups, which turns round at the walls.")),
        example("cradle", Text::tr("Cradle"),
                Text::tr("Five balls side by side: what comes in on the left goes out on the right.")),
        example("wheel", Text::tr("Wheel"),
                Text::tr("A rim of sticks with springs for spokes, on a floor that holds.")),
        example("cloth", Text::tr("Cloth"), Text::tr("A net of springs on three nails, in a little wind.")),
        example("tree", Text::tr("Tree"), Text::tr("A trunk of braced springs whose leaves catch the wind.")),
        example("ragdoll", Text::tr("Ragdoll"), Text::tr("Fourteen sticks that fall. Lift it by a hand.")),
        example("trampoline", Text::tr("Trampoline"),
                Text::tr("A heavy ball on a net of springs, and bodies that push each other away.")),
        example("charges", Text::tr("Crystal"),
                Text::tr("Positive and negative charges find each other and form a crystal. Give one the "
                         "other sign.")),
        example("magnets", Text::tr("Magnets"),
                Text::tr("Seven magnets find each other. Pull one away and let go.")),
        example("wind_profile", Text::tr("Wind profile"),
                Text::tr("The wind is slow near the ground and fast high up. Change how fast it grows with "
                         "the height.")),
        example("hard_spring", Text::tr("Hardening spring"),
                Text::tr("The right spring hardens when it stretches, so it swings faster. Pull both down "
                         "equally far.")),
        example("planet", Text::tr("Planet"),
                Text::tr("A planet on a circle and a comet on an ellipse. Write another power of the "
                         "distance than 3.")),
        example("pumped_swing", Text::tr("Pumped swing"),
                Text::tr("A motor pushes a swing in its own rhythm. Change the rhythm a little: the swing "
                         "stays low.")),
        example(
            "air_drag", Text::tr("Drag of the air"),
            Text::tr("The drag grows with the square of the speed: fast swings end soon, slow ones go on.")),
        example("flock", Text::tr("Flock"),
                Text::tr("Twenty dots that watch their neighbours. Remove one of the three habits.")),
        example("whirlpool", Text::tr("Whirlpool"),
                Text::tr("Water carries bodies round its middle. Let the water turn the other way.")),
        example("leash", Text::tr("Leash"),
                Text::tr("A leash pulls only when it is tight. Make it longer, or tie a third dog to it.")),
        example("hover", Text::tr("Hovering platform"),
                Text::tr("A platform compares its place with its goal, and follows your pointer. Change how "
                         "hard it corrects.")),
    };
}

}

Step buildStep()
{
    Step step = lessons::makeStep("sandbox", "build");
    step.readTexts({});
    step.parameters = parametersOf(sim::allEffects());
    step.scene = build::setUp;
    step.view = sandboxView;
    step.method = "semi_implicit_euler";
    step.points = PointSource::scene;
    // Only a rule reads input besides dragging.
    step.interactions = {Interaction::drag, Interaction::pointer, Interaction::target, Interaction::keys};
    step.prepareScript = [](sim::Script &script) {
        if (!script.values.blueprint)
            script.values.blueprint = defaultBlueprint();
    };
    for (const sim::EffectDescription *effect : sim::allEffects()) {
        if (effect->make)
            step.availableEffects.push_back(effect);
    }
    step.examples = examples();
    return step;
}

}

#include "steps.h"

#include "examples.h"
#include "looks.h"
#include "parameters.h"
#include "plan.h"
#include "scenes.h"

#include <QCoreApplication>

using namespace lessons;

namespace sandbox {

namespace {

struct Text
{
    Q_DECLARE_TR_FUNCTIONS(Sandbox)
};

/// A scene with everything that can be chosen, for its effects.
std::vector<sim::EffectPtr> catalogueOf(const Step &step)
{
    sim::Blueprint all = *firstPlan();
    all.springs.clear();
    all.feet = {{1, 0, 0.0, 0}};
    all.gaits = {{}};
    const std::vector<std::string> ids = {"gravity", "damping", "walls", "ramp",      "room",
                                          "ground",  "breeze",  "push",  "turn_round"};
    all.effects = ids;
    sim::Values values = step.presets();
    values.blueprint = std::make_shared<const sim::Blueprint>(std::move(all));
    std::vector<sim::EffectPtr> effects = step.scene(values).effects;
    std::erase_if(effects, [&](const sim::EffectPtr &one) {
        return std::find(ids.begin(), ids.end(), one->id()) == ids.end();
    });
    return effects;
}

}

Step buildStep()
{
    Step step = lessons::stepCalled("sandbox", "build", Text::tr("Build your own"));
    step.narration = Text::tr(
        "Here you build the scene. Choose a tool, then click in the picture: **points** are bodies with a "
        "mass "
        "and a size, a **nail** holds one where it is. **Springs** and **sticks** go from one point to "
        "another. "
        "A **foot** hangs on a body at an angle of its own, and feet of one group swing to one clock.\n\n"
        "What acts on the whole scene, as gravity or wind, you choose below. Building happens at the start "
        "of the "
        "run: play to see what your scene does, and come back to go on building.");
    step.parameters = sceneParameters();
    step.scene = build::setUp;
    step.look = builtLook;
    step.method = "semi_implicit_euler";
    step.points = PointsFrom::scene;
    step.opening = [](sim::Script &script) {
        if (!script.values.blueprint)
            script.values.blueprint = firstPlan();
    };
    step.catalogue = catalogueOf(step);
    step.examples = ownExamples();
    return step;
}

}

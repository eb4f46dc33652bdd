#include "steps.h"

#include "examples.h"
#include "lessons/api/parameters.h"
#include "plan.h"
#include "scenes.h"
#include "sim/effects/catalogue.h"
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
    step.parameters = settingsOf(sim::catalogue());
    step.scene = build::setUp;
    step.look = builtLook;
    step.method = "semi_implicit_euler";
    step.points = PointsFrom::scene;
    step.opening = [](sim::Script &script) {
        if (!script.values.blueprint)
            script.values.blueprint = firstPlan();
    };
    for (const sim::Description *one : sim::catalogue()) {
        if (one->make)
            step.catalogue.push_back(one);
    }
    step.examples = ownExamples();
    return step;
}

}

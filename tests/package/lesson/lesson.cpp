// A lesson that is built outside Springstep, with an effect of its own.

#include "lessons/api/lesson.h"
#include "lessons/api/view/view.h"
#include "scenes.h"
#include "sim/scene/scene.h"

#include <QObject>

namespace {

lessons::Step circleStep()
{
    lessons::Step step = lessons::makeStep("orbit", "circle");
    step.parameters = {{
        .id = "strength",
        .name = "Strength",
        .unit = "px³/frame²",
        .help = "How hard the planet pulls. The moon starts fast enough for a circle.",
        .defaultValue = 1184.0, // a turn takes 240 frames
        .min = 0.0,
        .max = 1e6,
        .sliderMax = 5000.0,
        .decimals = 0,
    }};
    step.readTexts({
        {.id = "turn", .conditions = {lessons::idleFor(240)}},
        {.id = "stronger",
         .conditions = {lessons::parameterSetTo("strength", 4737.0), lessons::idleFor(120)}},
    });
    step.scene = setUp;
    step.view = [](const sim::Scene &, const sim::Values &) {
        lessons::View view;
        view.bodies.resize(1);
        return view;
    };
    step.overlays = [](const sim::Scene &, const sim::State &, const sim::Values &) {
        return std::vector<lessons::Overlay>{{.shape = lessons::Overlay::Shape::cross, .a = planet}};
    };
    step.method = "velocity_verlet";
    return step;
}

}

class Orbit : public QObject, public lessons::Lesson
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID SpringstepLesson_iid FILE "lesson.json")
    Q_INTERFACES(lessons::Lesson)

public:
    std::vector<lessons::Step> steps() const override { return {circleStep()}; }
};

#include "lesson.moc"

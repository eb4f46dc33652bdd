#include "tests/app/support/two_lessons.h"

#include "sim/run/timeline.h"
#include "sim/scene/values.h"

#include "lessons/api/creature.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/point_spring.h"

using namespace app;

namespace tests {

namespace {

lessons::Step springStep(const QString &id, const QString &title, const QString &tryText = {})
{
    lessons::Step step;
    step.id = id;
    step.title = title;
    step.narration = "A **spring** pulls the foot to the cross.\n\nTwice as far, twice the pull.";
    step.parameters = {lessons::stiffness(), lessons::damping()};
    step.scene = [](const sim::Values &values) {
        sim::Scene scene = scenes::pair();
        scene.start.place(0, {300, 210});
        scenes::add<sim::PointSpring>(scene, 0, sim::Vec2{270, 200}, values["k"]);
        scenes::add<sim::Damping>(scene, values["damp"]);
        return scene;
    };
    step.view = [](const sim::Scene &scene, const sim::Values &) { return lessons::creatureView(scene); };
    const auto done = [](const sim::Timeline &timeline) { return timeline.cursor().frame >= 5; };
    if (!tryText.isEmpty())
        step.tries = {{tryText, done}};
    return step;
}

/// A step with more parameters than are always shown, one of them a choice, one a count.
lessons::Step manyParameters()
{
    lessons::Step step = springStep("many", "Many parameters");
    step.parameters.push_back(
        {"formula", "Formula", {}, {}, "Which one.", 0, 0, 1, 0, 1, 0, {"corrected", "printed"}});
    step.parameters.push_back(lessons::feet(5));
    step.parameters.push_back(lessons::offset());
    step.parameters.push_back(lessons::radius());
    return step;
}

}

LessonLibrary twoLessons()
{
    LessonLibrary library;
    library.lessons.push_back({"one",
                               1,
                               "Lesson one",
                               "The first.",
                               {springStep("first", "The first step", "Wait **five** frames."),
                                springStep("second", "The second step")}});
    library.lessons.push_back({"two", 2, "Lesson two", "The second.", {manyParameters()}});
    return library;
}

lessons::Step puppetOf(lessons::Step step)
{
    step.id = "puppet";
    step.method = "semi_implicit_euler";
    step.scene = [build = step.scene](const sim::Values &values) {
        sim::Scene scene = build(values);
        for (sim::Group &group : scene.groups)
            group.motion = sim::Motion::prescribed;
        return scene;
    };
    return step;
}

}

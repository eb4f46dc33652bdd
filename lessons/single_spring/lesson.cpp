#include "lessons/api/lesson.h"
#include "lessons/api/creature.h"
#include "lessons/api/parameters.h"
#include "sim/effects/damping.h"
#include "sim/effects/point_spring.h"

#include <QCoreApplication>
#include <QObject>

using namespace lessons;

namespace {

//! [fixed_centre]
sim::Scene fixedCentre(const sim::Values &values)
{
    sim::Scene scene = creature(1);
    scene.effects = {std::make_shared<sim::PointSpring>(0, sim::Vec2{270, 200}, values["k"]),
                     std::make_shared<sim::Damping>(values["damp"])};
    return scene;
}
//! [fixed_centre]

}

class SingleSpring : public QObject, public Lesson
{
    Q_OBJECT
    Q_PLUGIN_METADATA(IID SpringstepLesson_iid FILE "lesson.json")
    Q_INTERFACES(lessons::Lesson)

public:
    std::vector<Step> steps() const override
    {
        Step step;
        step.id = "fixed_centre";
        step.title = tr("A fixed centre");
        step.parameters = {stiffness(), damping()};
        step.scene = fixedCentre;
        step.setUp = {"lessons/single_spring/lesson.cpp", "fixed_centre"};
        step.look = [](const sim::Scene &scene, const sim::Values &) { return creatureLook(scene); };
        return {step};
    }
};

#include "lesson.moc"

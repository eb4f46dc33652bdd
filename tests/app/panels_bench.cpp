#include "panels_bench.h"

#include "lessons/api/creature.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/springs/point_spring.h"

#include <QApplication>
#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QTest>

namespace app {

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

void prepareProgram()
{
    QStandardPaths::setTestModeEnabled(true);
    static const QTemporaryDir settings; // the test mode leaves QSettings where they are
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    QCoreApplication::setOrganizationName("springstep-tests");
    QCoreApplication::setApplicationName(QCoreApplication::applicationFilePath().section('/', -1));
    Theme(Scheme::light).apply(*qApp);
}

void forgetProgress()
{
    QSettings().clear();
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

void show(QWidget &widget, const QSize &size)
{
    widget.resize(size);
    widget.show();
    QVERIFY(QTest::qWaitForWindowActive(&widget));
}

ParameterRow *rowOf(const ParameterPanel &panel, const QString &id)
{
    for (ParameterRow *row : panel.findChildren<ParameterRow *>()) {
        if (row->parameter().id == id)
            return row;
    }
    return nullptr;
}

void type(QWidget &box, const QString &text, Qt::Key end)
{
    QTest::mouseClick(&box, Qt::LeftButton);
    QTest::keyClick(&box, Qt::Key_A, Qt::ControlModifier);
    QTest::keyClicks(&box, text);
    QTest::keyClick(&box, end);
}

}

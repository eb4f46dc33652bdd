#include "tests/app/time_bench.h"

#include "lessons/api/creature.h"
#include "lessons/api/parameters.h"
#include "lessons/api/view/creature_view.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/radial_spring.h"

#include <QSettings>
#include <QStandardPaths>
#include <QTemporaryDir>
#include <QVBoxLayout>

using namespace app;

namespace {

lessons::Step stepCalled(const QString &id, const QString &method)
{
    lessons::Step step;
    step.id = id;
    step.title = id;
    step.method = method;
    step.parameters = {lessons::stiffness(), lessons::damping(), lessons::gravity()};
    step.parameters[0].max = 1e300; // enough to end a run
    step.scene = [](const sim::Values &values) {
        sim::Scene scene = scenes::pair();
        scenes::placeFeet(scene, {{330, 230}});
        scenes::add<sim::RadialSpring>(scene, scenes::legs(1), values["k"], 50.0);
        scenes::add<sim::Gravity>(scene, values["gravity"]);
        scenes::add<sim::Damping>(scene, values["damp"]);
        return scene;
    };
    step.view = [](const sim::Scene &scene, const sim::Values &) { return lessons::creatureView(scene); };
    return step;
}

const LessonLibrary &library()
{
    static const LessonLibrary one = [] {
        LessonEntry entry;
        entry.id = "lesson";
        entry.steps = {stepCalled("grouped", "published"), stepCalled("at_once", "semi_implicit_euler")};
        LessonLibrary made;
        made.lessons.push_back(std::move(entry));
        return made;
    }();
    return one;
}

}

TimeBench::TimeBench(const QString &step, int width)
    : session(library()), bar(new TransportBar(session, theme, &window)),
      strip(new TimelineStrip(session, theme, &window))
{
    session.openStep("lesson", step);
    QVBoxLayout *layout = new QVBoxLayout(&window);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(bar);
    layout->addWidget(strip);
    window.resize(width, 150);
    window.show();
    window.activateWindow();
    QVERIFY(QTest::qWaitForWindowActive(&window));
}

bool TimeBench::arrive() const
{
    return QTest::qWaitFor([this] { return !session.goingTo(); }, 20000);
}

void TimeBench::goTo(std::int64_t frame, int phase)
{
    session.goTo({frame, 0});
    QVERIFY(arrive());
    if (phase > 0)
        session.goTo({frame, phase});
    QCOMPARE(at(), (sim::Cursor{frame, phase}));
}

bool TimeBench::isStraightRun() const
{
    sim::Timeline straight(session.timeline().script());
    straight.seek(at());
    return sim::sameBits(straight.state(), session.timeline().state());
}

int runTimeSuite(QObject &suite, int count, char **arguments)
{
    QStandardPaths::setTestModeEnabled(true);
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    return QTest::qExec(&suite, count, arguments);
}

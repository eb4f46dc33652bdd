#include "tests/app/time/time_support.h"

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

TimeFixture::TimeFixture(const QString &step, int width)
    : session(library()), bar(new TransportBar(session, run, theme, &window)),
      strip(new TimelineStrip(session, theme, &window))
{
    session.openStep("lesson", step);
    window.addAction(run.goToFrame);
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

bool TimeFixture::arrive() const
{
    return QTest::qWaitFor([this] { return !session.playback().goal(); }, 20000);
}

void TimeFixture::goTo(std::int64_t frame, int phase)
{
    session.playback().goTo({frame, 0});
    QVERIFY(arrive());
    if (phase > 0)
        session.playback().goTo({frame, phase});
    QCOMPARE(at(), (sim::Cursor{frame, phase}));
}

bool TimeFixture::isStraightRun() const
{
    sim::Timeline straight(session.timeline().script());
    straight.seek(at());
    return sim::sameBits(straight.state(), session.timeline().state());
}

// A study beside the window: when it runs, when it stops, what it keeps.

#include "measure_bench.h"
#include "sim/methods/methods.h"

#include <QtTest>

using namespace app;
using measure_bench::Puppet;
using Stage = AccuracyStudy::Stage;

namespace {

struct Watched
{
    Puppet puppet;
    World world;
    AccuracyStudy study{world.session, puppet.function()};

    Watched() { study.setWatched(true); }
    bool ends()
    {
        return QTest::qWaitFor([this] { return study.stage() == Stage::done; }, 20'000);
    }
};

}

class AccuracyStudyTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }
    void nothingRunsUntilSomebodyWatches();
    void anotherSceneDropsTheResultAndMeasuresAgainWhenItSettles();
    void anotherStepOfTheLessonDropsTheResult();
    void anotherMethodKeepsTheResult();
    void aStepThatIsNoRungIsMeasured();
    void lookingAwayStopsTheStudy();
    void closingWaitsForTheThread();
    void whatASceneIsRefusedForIsSaid();
    void reportsComeAtMostTenTimesASecond();
    void methodsKeepTheirKindOfStep();
};

void AccuracyStudyTest::nothingRunsUntilSomebodyWatches()
{
    Puppet puppet;
    World world;
    AccuracyStudy study(world.session, puppet.function());
    world.session.setParameter("k", 0.3);
    QTest::qWait(2 * AccuracyStudy::settleMilliseconds);
    QCOMPARE(puppet.begun.load(), 0);
    QCOMPARE(study.stage(), Stage::none);
}

void AccuracyStudyTest::anotherSceneDropsTheResultAndMeasuresAgainWhenItSettles()
{
    Watched watched;
    QVERIFY(watched.ends());
    QVERIFY(watched.study.accuracy());
    watched.world.session.setParameter("k", 0.3);
    QVERIFY(!watched.study.accuracy());
    watched.world.session.setParameter("k", 0.31);
    watched.world.session.setParameter("k", 0.32);
    QVERIFY(watched.study.isDue());
    QVERIFY(watched.ends());
    QVERIFY(watched.study.accuracy());
    QCOMPARE(watched.puppet.begun.load(), 2); // three changes, one study
}

void AccuracyStudyTest::anotherStepOfTheLessonDropsTheResult()
{
    Watched watched;
    QVERIFY(watched.ends());
    watched.world.session.openStep("one", "second"); // the same scene, but another step
    QVERIFY(!watched.study.accuracy());
}

void AccuracyStudyTest::anotherMethodKeepsTheResult()
{
    Watched watched;
    QVERIFY(watched.ends());
    const sim::Accuracy *before = watched.study.accuracy();
    watched.world.session.use(sim::findMethod("semi_implicit_euler"), sim::StepSize::ofLength(0.5));
    QCOMPARE(watched.study.accuracy(), before);
    QVERIFY(!watched.study.isDue());
    QCOMPARE(watched.study.inUse()->setup.step, sim::StepSize::ofLength(0.5));
}

void AccuracyStudyTest::aStepThatIsNoRungIsMeasured()
{
    Watched watched;
    QVERIFY(watched.ends());
    watched.world.session.setStepSize(1.0 / 3.0);
    QVERIFY(!watched.study.inUse());
    QVERIFY(watched.study.accuracy());
    QTRY_COMPARE(watched.puppet.begun.load(), 2);
}

void AccuracyStudyTest::lookingAwayStopsTheStudy()
{
    Watched watched;
    watched.puppet.held = true;
    QTRY_COMPARE(watched.puppet.begun.load(), 1);
    watched.study.setWatched(false);
    QTRY_COMPARE(watched.puppet.begun.load() - watched.puppet.stopped.load(), 0);
    watched.puppet.held = false;
    watched.study.setWatched(true);
    QVERIFY(watched.ends());
}

void AccuracyStudyTest::closingWaitsForTheThread()
{
    Puppet puppet;
    World world;
    {
        AccuracyStudy study(world.session, puppet.function());
        puppet.held = true;
        study.setWatched(true);
        QTRY_COMPARE(puppet.begun.load(), 1);
    }
    QCOMPARE(puppet.stopped.load(), 1);
}

void AccuracyStudyTest::whatASceneIsRefusedForIsSaid()
{
    World world;
    AccuracyStudy study(
        world.session,
        [](const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &) -> sim::Accuracy {
            throw sim::Error("nothing-moves", {});
        });
    study.setWatched(true);
    QTRY_COMPARE(study.stage(), Stage::refused);
    QVERIFY(study.refusal().startsWith("Nothing in this scene can move"));
    QVERIFY(!study.accuracy());
}

void AccuracyStudyTest::reportsComeAtMostTenTimesASecond()
{
    Watched watched;
    watched.puppet.held = true;
    QTRY_VERIFY(watched.study.accuracy());
    int reports = 0;
    connect(&watched.study, &AccuracyStudy::changed, this, [&] { ++reports; });
    QTest::qWait(1000); // the puppet reports a thousand times
    QVERIFY2(reports <= 12, qPrintable(QString::number(reports)));
    watched.puppet.held = false;
    QVERIFY(watched.ends());
}

void AccuracyStudyTest::methodsKeepTheirKindOfStep()
{
    World world;
    Session &session = world.session;
    const auto step = [&] { return session.timeline().script().step; };
    session.setMethod("semi_implicit_euler");
    session.setStepSize(0.25);
    session.setMethod("dormand_prince");
    QCOMPARE(session.timeline().script().method->id(), "dormand_prince");
    QCOMPARE(step(), sim::StepSize::withTolerance(1e-3));
    session.setTolerance(1e-6);
    session.setMethod("rk4");
    QCOMPARE(step(), sim::StepSize::ofLength(0.25));
    session.setMethod("dop853");
    QCOMPARE(step(), sim::StepSize::withTolerance(1e-6));
}

QTEST_MAIN(AccuracyStudyTest)
#include "tst_accuracy_study.moc"

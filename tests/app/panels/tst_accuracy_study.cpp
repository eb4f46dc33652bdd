// The accuracy study in the background: its start, its cancellation, and the results that it keeps.

#include "sim/methods/methods.h"
#include "tests/app/panels/accuracy_support.h"
#include "tests/suite.h"

#include <QtTest>

using namespace app;
using namespace tests;
using accuracy_support::Puppet;
using Stage = AccuracyStudy::Stage;

namespace {

struct ActiveStudy
{
    Puppet puppet;
    SessionFixture world;
    AccuracyStudy study{world.session.run(), world.session.editor(), puppet.function()};

    ActiveStudy() { study.setActive(true); }
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
    void inactiveStudyDoesNotRun();
    void anotherSceneDropsTheResultAndMeasuresAgainWhenItSettles();
    void anotherStepOfTheLessonDropsTheResult();
    void anotherMethodKeepsTheResult();
    void stepOutsideTheRefinementLevelsIsMeasured();
    void deactivatingCancelsTheStudy();
    void closingWaitsForTheThread();
    void aRefusedSceneHasItsReason();
    void reportsComeAtMostTenTimesASecond();
    void methodsKeepTheirKindOfStep();
};

void AccuracyStudyTest::inactiveStudyDoesNotRun()
{
    Puppet puppet;
    SessionFixture world;
    AccuracyStudy study(world.session.run(), world.session.editor(), puppet.function());
    world.session.editor().setParameter("k", 0.3);
    settle();
    QVERIFY(!study.isDue());
    QCOMPARE(puppet.begun.load(), 0);
    QCOMPARE(study.stage(), Stage::none);
}

void AccuracyStudyTest::anotherSceneDropsTheResultAndMeasuresAgainWhenItSettles()
{
    ActiveStudy active;
    QVERIFY(active.ends());
    QVERIFY(active.study.accuracy());
    active.world.session.editor().setParameter("k", 0.3);
    QVERIFY(!active.study.accuracy());
    active.world.session.editor().setParameter("k", 0.31);
    active.world.session.editor().setParameter("k", 0.32);
    QVERIFY(active.study.isDue());
    QVERIFY(active.ends());
    QVERIFY(active.study.accuracy());
    QCOMPARE(active.puppet.begun.load(), 2); // three changes, one study
}

void AccuracyStudyTest::anotherStepOfTheLessonDropsTheResult()
{
    ActiveStudy active;
    QVERIFY(active.ends());
    active.world.session.openStep("one", "second"); // the same scene, but another step
    QVERIFY(!active.study.accuracy());
}

void AccuracyStudyTest::anotherMethodKeepsTheResult()
{
    ActiveStudy active;
    QVERIFY(active.ends());
    const sim::Accuracy *before = active.study.accuracy();
    active.world.session.editor().use(sim::findMethod("semi_implicit_euler"), sim::StepSize::ofLength(0.5));
    QCOMPARE(active.study.accuracy(), before);
    QVERIFY(!active.study.isDue());
    QCOMPARE(active.study.inUse()->setup.step, sim::StepSize::ofLength(0.5));
}

void AccuracyStudyTest::stepOutsideTheRefinementLevelsIsMeasured()
{
    ActiveStudy active;
    QVERIFY(active.ends());
    active.world.session.editor().setStepSize(1.0 / 3.0);
    QVERIFY(!active.study.inUse());
    QVERIFY(active.study.accuracy());
    QTRY_COMPARE(active.puppet.begun.load(), 2);
}

void AccuracyStudyTest::deactivatingCancelsTheStudy()
{
    ActiveStudy active;
    active.puppet.held = true;
    QTRY_COMPARE(active.puppet.begun.load(), 1);
    active.study.setActive(false);
    QTRY_COMPARE(active.puppet.begun.load() - active.puppet.stopped.load(), 0);
    active.puppet.held = false;
    active.study.setActive(true);
    QVERIFY(active.ends());
}

void AccuracyStudyTest::closingWaitsForTheThread()
{
    Puppet puppet;
    SessionFixture world;
    {
        AccuracyStudy study(world.session.run(), world.session.editor(), puppet.function());
        puppet.held = true;
        study.setActive(true);
        QTRY_COMPARE(puppet.begun.load(), 1);
    }
    QCOMPARE(puppet.stopped.load(), 1);
}

void AccuracyStudyTest::aRefusedSceneHasItsReason()
{
    SessionFixture world;
    AccuracyStudy study(
        world.session.run(), world.session.editor(),
        [](const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &) -> sim::Accuracy {
            throw sim::Error("nothing-moves", {});
        });
    study.setActive(true);
    QTRY_COMPARE(study.stage(), Stage::refused);
    QVERIFY(study.error().startsWith("Nothing in this scene can move"));
    QVERIFY(!study.accuracy());
}

void AccuracyStudyTest::reportsComeAtMostTenTimesASecond()
{
    ActiveStudy active;
    active.puppet.held = true;
    QTRY_VERIFY(active.study.accuracy());
    const QSignalSpy reports(&active.study, &AccuracyStudy::changed);
    QElapsedTimer clock;
    clock.start();
    QTRY_VERIFY(reports.size() >= 10); // of the thousand that the puppet makes in a second
    QVERIFY2(clock.elapsed() >= 9 * AccuracyStudy::reportMilliseconds,
             qPrintable(QString::number(clock.elapsed())));
    active.puppet.held = false;
    QVERIFY(active.ends());
}

void AccuracyStudyTest::methodsKeepTheirKindOfStep()
{
    SessionFixture world;
    Session &session = world.session;
    const auto step = [&] { return session.timeline().script().step; };
    session.editor().setMethod("semi_implicit_euler");
    session.editor().setStepSize(0.25);
    session.editor().setMethod("dormand_prince");
    QCOMPARE(session.timeline().script().method->id(), "dormand_prince");
    QCOMPARE(step(), sim::StepSize::withTolerance(1e-3));
    session.editor().setTolerance(1e-6);
    session.editor().setMethod("rk4");
    QCOMPARE(step(), sim::StepSize::ofLength(0.25));
    session.editor().setMethod("dop853");
    QCOMPARE(step(), sim::StepSize::withTolerance(1e-6));
}

SUITE(tst_accuracy_study, AccuracyStudyTest)
#include "tst_accuracy_study.moc"

// Playing when everything has come to rest: time waits, and goes on when something is touched.

#include "tests/app/time_bench.h"

#include "lessons/api/checks/run_queries.h"

#include <QSignalSpy>
#include <QTest>

using namespace app;

namespace {

/// A creature that hangs in the air, long after it has settled.
struct Settled : TimeBench
{
    explicit Settled(std::int64_t frame = 2000)
    {
        session.setParameter("gravity", 0.0);
        session.setParameter("damp", 0.7);
        session.setSpeed(4.0);
        goTo(frame);
    }
    /// Whether the state is, bit for bit, that of a run that computes every frame.
    bool isAwakeRun() const
    {
        sim::Track awake(session.timeline().script(), 0, sim::Sleeping::never);
        awake.seek(at());
        return sim::sameBits(awake.state(), session.timeline().state());
    }
};

/// Counts what the application does by itself.
struct Counter : QObject
{
    int timers = 0;
    int paints = 0;
    Counter() { qApp->installEventFilter(this); }
    ~Counter() override { qApp->removeEventFilter(this); }
    bool eventFilter(QObject *, QEvent *event) override
    {
        timers += event->type() == QEvent::Timer;
        paints += event->type() == QEvent::Paint;
        return false;
    }
};

}

class TestRest : public QObject
{
    Q_OBJECT

private slots:
    void whatRestsWaits()
    {
        Settled bench;
        bench.session.play();
        QTRY_VERIFY(bench.session.isResting());
        QVERIFY(bench.session.isPlaying());
        const std::int64_t frame = bench.at().frame;
        bool isQuiet = false;
        for (int i = 0; i < 30 && !isQuiet; ++i) { // what the window began comes to an end first
            Counter counter;
            QTest::qWait(1000);
            isQuiet = counter.timers + counter.paints == 0;
        }
        QVERIFY(isQuiet);
        QCOMPARE(bench.at().frame, frame);
        QVERIFY(bench.isAwakeRun());
    }

    void whatStillMovesPlaysOn()
    {
        Settled bench(0);
        bench.session.play();
        QTRY_VERIFY(bench.at().frame > 20);
        QVERIFY(!bench.session.isResting());
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.isResting(), 60'000); // until it has settled
        QVERIFY(bench.isAwakeRun());
    }

    void aTouchWakesIt()
    {
        Settled bench;
        bench.session.play();
        QTRY_VERIFY(bench.session.isResting());
        const std::int64_t frame = bench.at().frame;
        bench.session.grab("foot");
        QVERIFY(!bench.session.isResting());
        bench.session.moveHand({400.0, 120.0});
        QTRY_VERIFY(bench.at().frame > frame + 5);
        bench.session.letGo();
        QTRY_VERIFY(bench.at().frame > frame + 20);
        QVERIFY(bench.session.timeline().state().positionOf(0).x != 0.0);
        QVERIFY(bench.isAwakeRun());
        QTRY_VERIFY_WITH_TIMEOUT(bench.session.isResting(), 60'000);
        QVERIFY(bench.isAwakeRun());
    }

    void aParameterWakesIt()
    {
        Settled bench;
        bench.session.play();
        QTRY_VERIFY(bench.session.isResting());
        const std::int64_t frame = bench.at().frame;
        bench.session.setParameter("gravity", 0.5);
        QTRY_VERIFY(bench.at().frame > frame + 20);
        QVERIFY(!bench.session.isResting());
        QVERIFY(bench.isAwakeRun());
    }

    void itCanBeStoppedAndSteppedAsAlways()
    {
        Settled bench;
        bench.session.play();
        QTRY_VERIFY(bench.session.isResting());
        bench.session.togglePlaying();
        QVERIFY(!bench.session.isPlaying());
        QVERIFY(!bench.session.isResting());
        const std::int64_t frame = bench.at().frame;
        bench.session.frameForward();
        QCOMPARE(bench.at(), (sim::Cursor{frame + 1, 0}));
        bench.session.phaseForward();
        QCOMPARE(bench.at(), (sim::Cursor{frame + 1, 1}));
        bench.session.frameBack();
        bench.session.frameBack();
        QCOMPARE(bench.at(), (sim::Cursor{frame, 0}));
        QVERIFY(bench.isAwakeRun());
        bench.session.goTo({frame + 1'000'000, 0}); // it is there at once
        QCOMPARE(bench.at().frame, frame + 1'000'000);
    }

    void aReplayOfThePastGoesOnToItsEnd()
    {
        Settled bench(2000);
        bench.session.goTo({2100, 0});
        bench.session.goTo({2030, 0});
        QVERIFY(bench.arrive());
        bench.session.play();
        QTRY_VERIFY(bench.session.isResting());
        QVERIFY(bench.at().frame >= 2100);
    }

    void goingBackWhileItWaitsPlaysFromThere()
    {
        Settled bench;
        bench.session.play();
        QTRY_VERIFY(bench.session.isResting());
        bench.session.goTo({0, 0});
        QVERIFY(!bench.session.isResting());
        QTRY_VERIFY(bench.at().frame > 5);
    }

    void anOldRunThatStillMovesIsPlayedOn()
    {
        Settled bench;
        bench.session.goTo({0, 0});
        QVERIFY(bench.arrive());
        bench.session.setParameter("damp", 0.99); // this one takes long
        bench.goTo(1500);
        bench.session.goTo({10, 0});
        bench.session.setParameter("damp", 0.7); // and now it is the old run
        bench.goTo(700);
        QVERIFY(!bench.session.timeline().comparison()->isFinished());
        bench.session.play();
        QTRY_VERIFY(bench.at().frame > 720);
        QVERIFY(!bench.session.isResting());
    }

    void aThingToTryThatTakesTimeGetsIt()
    {
        // Done when nothing was touched for 150 frames after the last change: long after everything rests.
        lessons::Step step = Settled().session.step();
        step.id = "waits";
        step.tries = {
            {"Wait.",
             [](const sim::Timeline &run) { return lessons::framesSinceSet(run, "gravity") >= 150; },
             {}}};
        LessonLibrary library;
        library.lessons.emplace_back();
        library.lessons.front().id = "patience";
        library.lessons.front().steps = {step};
        Session session(library);
        session.setSpeed(4.0);
        session.setParameter("gravity", 0.0);
        session.setParameter("damp", 0.7);
        session.goTo({2000, 0});
        QTRY_VERIFY(!session.goingTo());
        session.setParameter("gravity", 0.1);
        session.setParameter("gravity", 0.0);
        session.progress().forgetAll();
        session.play();
        QTRY_VERIFY_WITH_TIMEOUT(session.isResting(), 60'000);
        QVERIFY(session.progress().isDone("patience", "waits", 0));
        QVERIFY(session.timeline().cursor().frame >= 2150);
    }
};

SPRINGSTEP_TIME_MAIN(TestRest)
#include "tst_rest.moc"

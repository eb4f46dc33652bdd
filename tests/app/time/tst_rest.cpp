// Playing a run at rest: the playback waits, and continues after user input.

#include "tests/app/support/waiting.h"
#include "tests/app/time/time_support.h"
#include "tests/suite.h"

#include "lessons/api/checks/run_queries.h"

#include <QSignalSpy>
#include <QTest>

using namespace app;
using namespace tests;

namespace {

/// A creature that hangs in the air, long after it has settled.
struct Settled : TimeFixture
{
    explicit Settled(std::int64_t frame = 2000)
    {
        session.editor().setParameter("gravity", 0.0);
        session.editor().setParameter("damp", 0.7);
        session.playback().setSpeed(4.0);
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

}

class TestRest : public QObject
{
    Q_OBJECT

private slots:
    void aRestingRunWaits()
    {
        Settled fixture;
        fixture.session.playback().play();
        QTRY_VERIFY(fixture.session.playback().isWaiting());
        QVERIFY(fixture.session.playback().isPlaying());
        const std::int64_t frame = fixture.at().frame;
        QVERIFY(Activity().comesToRest());
        QCOMPARE(fixture.at().frame, frame);
        QVERIFY(fixture.isAwakeRun());
    }

    void aMovingRunPlaysOn()
    {
        Settled fixture(0);
        fixture.session.playback().play();
        QTRY_VERIFY(fixture.at().frame > 20);
        QVERIFY(!fixture.session.playback().isWaiting());
        QTRY_VERIFY_WITH_TIMEOUT(fixture.session.playback().isWaiting(), 60'000); // until it has settled
        QVERIFY(fixture.isAwakeRun());
    }

    void grabbingABodyWakesTheRun()
    {
        Settled fixture;
        fixture.session.playback().play();
        QTRY_VERIFY(fixture.session.playback().isWaiting());
        const std::int64_t frame = fixture.at().frame;
        fixture.session.input().grab("foot");
        QVERIFY(!fixture.session.playback().isWaiting());
        fixture.session.input().moveTo({400.0, 120.0});
        QTRY_VERIFY(fixture.at().frame > frame + 5);
        fixture.session.input().release();
        QTRY_VERIFY(fixture.at().frame > frame + 20);
        QVERIFY(fixture.session.timeline().state().positionOf(0).x != 0.0);
        QVERIFY(fixture.isAwakeRun());
        QTRY_VERIFY_WITH_TIMEOUT(fixture.session.playback().isWaiting(), 60'000);
        QVERIFY(fixture.isAwakeRun());
    }

    void changingAParameterWakesTheRun()
    {
        Settled fixture;
        fixture.session.playback().play();
        QTRY_VERIFY(fixture.session.playback().isWaiting());
        const std::int64_t frame = fixture.at().frame;
        fixture.session.editor().setParameter("gravity", 0.5);
        QTRY_VERIFY(fixture.at().frame > frame + 20);
        QVERIFY(!fixture.session.playback().isWaiting());
        QVERIFY(fixture.isAwakeRun());
    }

    void waitingRunCanBePausedAndStepped()
    {
        Settled fixture;
        fixture.session.playback().play();
        QTRY_VERIFY(fixture.session.playback().isWaiting());
        fixture.session.playback().togglePlaying();
        QVERIFY(!fixture.session.playback().isPlaying());
        QVERIFY(!fixture.session.playback().isWaiting());
        const std::int64_t frame = fixture.at().frame;
        fixture.session.playback().frameForward();
        QCOMPARE(fixture.at(), (sim::Cursor{frame + 1, 0}));
        fixture.session.playback().phaseForward();
        QCOMPARE(fixture.at(), (sim::Cursor{frame + 1, 1}));
        fixture.session.playback().frameBack();
        fixture.session.playback().frameBack();
        QCOMPARE(fixture.at(), (sim::Cursor{frame, 0}));
        QVERIFY(fixture.isAwakeRun());
        fixture.session.playback().goTo({frame + 1'000'000, 0}); // it is there at once
        QCOMPARE(fixture.at().frame, frame + 1'000'000);
    }

    void aReplayOfThePastGoesOnToItsEnd()
    {
        Settled fixture(2000);
        fixture.session.playback().goTo({2100, 0});
        fixture.session.playback().goTo({2030, 0});
        QVERIFY(fixture.arrive());
        fixture.session.playback().play();
        QTRY_VERIFY(fixture.session.playback().isWaiting());
        QVERIFY(fixture.at().frame >= 2100);
    }

    void goingBackWhileItWaitsPlaysFromThere()
    {
        Settled fixture;
        fixture.session.playback().play();
        QTRY_VERIFY(fixture.session.playback().isWaiting());
        fixture.session.playback().goTo({0, 0});
        QVERIFY(!fixture.session.playback().isWaiting());
        QTRY_VERIFY(fixture.at().frame > 5);
    }

    void anOldRunThatStillMovesIsPlayedOn()
    {
        Settled fixture;
        fixture.session.playback().goTo({0, 0});
        QVERIFY(fixture.arrive());
        fixture.session.editor().setParameter("damp", 0.99); // this one takes long
        fixture.goTo(1500);
        fixture.session.playback().goTo({10, 0});
        fixture.session.editor().setParameter("damp", 0.7); // and now it is the old run
        fixture.goTo(700);
        QVERIFY(!fixture.session.timeline().comparison()->isFinished());
        fixture.session.playback().play();
        QTRY_VERIFY(fixture.at().frame > 720);
        QVERIFY(!fixture.session.playback().isWaiting());
    }

    void aThingToTryThatTakesTimeGetsIt()
    {
        // The thing to try needs 150 frames without input after the last change, long after the run is at rest.
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
        session.playback().setSpeed(4.0);
        session.editor().setParameter("gravity", 0.0);
        session.editor().setParameter("damp", 0.7);
        session.playback().goTo({2000, 0});
        QTRY_VERIFY(!session.playback().goal());
        session.editor().setParameter("gravity", 0.1);
        session.editor().setParameter("gravity", 0.0);
        session.progress().forgetLesson("patience");
        session.playback().play();
        QTRY_VERIFY_WITH_TIMEOUT(session.playback().isWaiting(), 60'000);
        QVERIFY(session.progress().isDone("patience", "waits", 0));
        QVERIFY(session.timeline().cursor().frame >= 2150);
    }
};

SUITE(tst_rest, TestRest)
#include "tst_rest.moc"

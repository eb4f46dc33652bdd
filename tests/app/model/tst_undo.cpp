// Undo and redo of a learner's edits always give the same bits.

#include "app/model/session/session.h"
#include "tests/app/model/effects_support.h"
#include "tests/suite.h"

#include <QtTest>

#include <random>

using namespace app;

namespace {

struct LegsWorld
{
    LegsWorld() { session.openStep("legs", "tied"); }

    LessonLibrary library = effects_support::legLibrary();
    Session session{library};
};

}

class UndoTest : public QObject
{
    Q_OBJECT

private slots:
    void editsWithoutAChangeAreNotOnTheUndoStack()
    {
        LegsWorld world;
        Session &session = world.session;
        session.editor().setParameter("k", session.editor().parameter("k"));
        session.editor().setEffect("body_spring", true);
        session.editor().setEffect("no_such_effect", false);
        session.editor().resetParameters();
        session.editor().setMethod("published");
        QCOMPARE(session.editor().undoStack().count(), 0);
        session.editor().undo(); // nothing to undo: nothing happens
        session.editor().redo();
        QVERIFY(session.timeline().script().effectsOff.empty());
    }

    void startingAfreshCanBeUndone()
    {
        LegsWorld world;
        Session &session = world.session;
        session.editor().setParameter("k", 0.5);
        session.playback().goTo({20, 0});
        const sim::State before = session.timeline().state();
        session.editor().startAfresh();
        QCOMPARE(session.editor().parameter("k"), 0.2);
        session.editor().undo();
        QCOMPARE(session.editor().parameter("k"), 0.5);
        session.playback().goTo({20, 0});
        QVERIFY(sim::sameBits(session.timeline().state(), before));
    }

    void restartingIsFreshWithTheParametersAsTheyAre()
    {
        LegsWorld world;
        Session &session = world.session;
        session.playback().goTo({10, 0});
        session.editor().setParameter("k", 0.5);
        session.input().grab("foot");
        session.input().moveTo({310, 220});
        session.playback().frameForward();
        session.input().release();
        session.playback().goTo({30, 0});
        const sim::State before = session.timeline().state();
        QVERIFY(session.editor().hasInput());
        session.editor().restart();
        QCOMPARE(session.timeline().cursor(), sim::Cursor{});
        QVERIFY(!session.playback().isPlaying());
        QVERIFY(!session.editor().hasInput());
        QVERIFY(!session.timeline().comparison());
        QCOMPARE(session.comparisons().branches().all().size(), std::size_t(1)); // the run as it was
        QCOMPARE(session.editor().parameter("k"), 0.5);
        sim::Script fresh = session.step().script();
        fresh.values.set("k", 0.5);
        sim::Timeline expected(fresh);
        expected.seek({30, 0});
        session.playback().goTo({30, 0});
        QVERIFY(sim::sameBits(session.timeline().state(), expected.state()));
        session.editor().undo();
        session.playback().goTo({30, 0});
        QVERIFY(sim::sameBits(session.timeline().state(), before));
    }

    void restartingAnUnchangedRunOnlyGoesToTheStart()
    {
        LegsWorld world;
        Session &session = world.session;
        session.playback().goTo({20, 0});
        session.editor().restart();
        QCOMPARE(session.timeline().cursor(), sim::Cursor{});
        QCOMPARE(session.timeline().computed(), 20);
        QCOMPARE(session.editor().undoStack().count(), 0);
        QVERIFY(session.comparisons().branches().all().empty());
    }

    void repeatingReplaysTheRecordedInput()
    {
        LegsWorld world;
        Session &session = world.session;
        session.playback().goTo({4, 0});
        session.input().grab("foot");
        session.input().moveTo({310, 220});
        session.playback().frameForward();
        session.playback().frameForward();
        session.input().release();
        session.playback().goTo({15, 0});
        const sim::State before = session.timeline().state();
        QVERIFY(!session.input().recordedPointer());
        session.playback().repeat();
        QVERIFY(session.playback().isPlaying());
        QCOMPARE(session.timeline().cursor(), sim::Cursor{});
        QVERIFY(session.editor().hasInput());
        session.playback().pause();
        session.playback().goTo({5, 0}); // the recorded pointer is shown
        QVERIFY(session.input().recordedPointer());
        QVERIFY(*session.input().recordedPointer() == (sim::Vec2{310, 220}));
        session.playback().goTo({15, 0});
        QVERIFY(!session.input().recordedPointer());
        QVERIFY(sim::sameBits(session.timeline().state(), before));
    }

    void undoReleasesTheHeldBody()
    {
        LegsWorld world;
        Session &session = world.session;
        session.playback().goTo({5, 0});
        const sim::State before = session.timeline().state();
        session.input().grab("foot");
        session.input().moveTo({100, 100});
        session.editor().undo();
        QVERIFY(!session.input().isHolding());
        QCOMPARE(session.timeline().state().hold.point, -1);
        QVERIFY(sim::sameBits(session.timeline().state(), before));
        QVERIFY(session.timeline().script().input.empty());
    }

    void anUndoneRunStaysAsAGhost()
    {
        LegsWorld world;
        Session &session = world.session;
        session.playback().goTo({20, 0});
        session.editor().setEffect("body_spring", false);
        QCOMPARE(session.comparisons().comparisonName(), "before: Spring on");
        session.editor().undo();
        QCOMPARE(session.comparisons().comparisonName(), "undone: Spring off");
        session.editor().redo();
        QCOMPARE(session.comparisons().comparisonName(), "before: Spring on");
    }

    void aGestureIsOneEntry()
    {
        LegsWorld world;
        Session &session = world.session;
        session.playback().goTo({10, 0});
        for (const double k : {0.21, 0.22, 0.23})
            session.editor().setParameter("k", k);
        session.editor().endGesture();
        QCOMPARE(session.editor().undoStack().count(), 1);
        session.editor().setParameter("k", 0.3);
        QCOMPARE(session.editor().undoStack().count(), 2);
        session.input().grab("foot");
        session.input().moveTo({310, 220});
        session.playback().frameForward();
        session.input().moveTo({320, 230});
        session.input().release();
        QCOMPARE(session.editor().undoStack().count(), 3);
        session.input().grab("foot");
        session.input().release();
        QCOMPARE(session.editor().undoStack().count(), 4);
        session.editor().undo();
        session.editor().undo();
        session.editor().undo();
        QCOMPARE(session.editor().parameter("k"), 0.23);
        session.editor().undo();
        QCOMPARE(session.editor().parameter("k"), 0.2);
    }

    void undoingAllAndRedoingAllGivesTheSameBits()
    {
        LegsWorld world;
        Session &session = world.session;
        std::mt19937 dice(7);
        const auto pick = [&](int below) { return static_cast<int>(dice() % static_cast<unsigned>(below)); };
        const auto at = [&](std::int64_t frame) {
            session.playback().goTo({frame, 0});
            return session.timeline().state();
        };
        for (int round = 0; round < 20; ++round) {
            session.openStep("legs", "puppet");
            session.openStep("legs", "tied");
            session.editor().startAfresh();
            const sim::State start = at(30);
            const int before = session.editor().undoStack().index();
            for (int i = 0; i < 12; ++i) {
                session.playback().goTo({pick(30), 0});
                switch (pick(6)) {
                case 0:
                    session.editor().setParameter("k", 0.01 * (1 + pick(90)));
                    session.editor().endGesture();
                    break;
                case 1:
                    session.editor().setEffect("body_spring", pick(2) == 0);
                    break;
                case 2:
                    session.editor().setEffect("damping", pick(2) == 0);
                    break;
                case 3:
                    session.editor().setMethod(pick(2) == 0 ? "rk4" : "published");
                    break;
                case 4:
                    session.input().grab("foot");
                    session.input().moveTo({200.0 + pick(100), 150.0 + pick(100)});
                    session.playback().frameForward();
                    session.input().release();
                    break;
                default:
                    session.editor().resetParameters();
                }
            }
            const sim::State end = at(30);
            while (session.editor().undoStack().index() > before)
                session.editor().undo();
            QVERIFY(sim::sameBits(at(30), start));
            while (session.editor().undoStack().canRedo())
                session.editor().redo();
            QVERIFY(sim::sameBits(at(30), end));
        }
    }
};

SUITE(tst_undo, UndoTest)
#include "tst_undo.moc"

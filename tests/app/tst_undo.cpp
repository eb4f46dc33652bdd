// What a learner did to a run, undone and done again: always with the same bits.

#include "app/model/session.h"
#include "effects_bench.h"

#include <QSettings>
#include <QTemporaryDir>
#include <QtTest>

#include <random>

using namespace app;

namespace {

struct World
{
    World() { session.openStep("legs", "tied"); }

    LessonLibrary library = effects_bench::legLibrary();
    Session session{library};
};

}

class UndoTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
    }

    void whatChangedNothingIsNoEntry()
    {
        World world;
        Session &session = world.session;
        session.setParameter("k", session.parameter("k"));
        session.setEffect("body_spring", true);
        session.setEffect("no_such_effect", false);
        session.resetParameters();
        session.setMethod("published");
        QCOMPARE(session.deeds().count(), 0);
        session.undo(); // nothing to undo: nothing happens
        session.redo();
        QVERIFY(session.timeline().script().effectsOff.empty());
    }

    void startingAfreshCanBeUndone()
    {
        World world;
        Session &session = world.session;
        session.setParameter("k", 0.5);
        session.goTo({20, 0});
        const sim::State before = session.timeline().state();
        session.startAfresh();
        QCOMPARE(session.parameter("k"), 0.2);
        session.undo();
        QCOMPARE(session.parameter("k"), 0.5);
        session.goTo({20, 0});
        QVERIFY(sim::sameBits(session.timeline().state(), before));
    }

    void restartingIsFreshWithTheParametersAsTheyAre()
    {
        World world;
        Session &session = world.session;
        session.goTo({10, 0});
        session.setParameter("k", 0.5);
        session.grab("foot");
        session.moveHand({310, 220});
        session.frameForward();
        session.letGo();
        session.goTo({30, 0});
        const sim::State before = session.timeline().state();
        QVERIFY(session.hasInput());
        session.restart();
        QCOMPARE(session.timeline().cursor(), sim::Cursor{});
        QVERIFY(!session.isPlaying());
        QVERIFY(!session.hasInput());
        QVERIFY(!session.timeline().comparison());
        QCOMPARE(session.branches().all().size(), std::size_t(1)); // the run as it was
        QCOMPARE(session.parameter("k"), 0.5);
        sim::Script fresh = session.step().script();
        fresh.values.set("k", 0.5);
        sim::Timeline expected(fresh);
        expected.seek({30, 0});
        session.goTo({30, 0});
        QVERIFY(sim::sameBits(session.timeline().state(), expected.state()));
        session.undo();
        session.goTo({30, 0});
        QVERIFY(sim::sameBits(session.timeline().state(), before));
    }

    void restartingWhatNobodyTouchedIsGoingToTheStart()
    {
        World world;
        Session &session = world.session;
        session.goTo({20, 0});
        session.restart();
        QCOMPARE(session.timeline().cursor(), sim::Cursor{});
        QCOMPARE(session.timeline().computed(), 20);
        QCOMPARE(session.deeds().count(), 0);
        QVERIFY(session.branches().all().empty());
    }

    void repeatingDoesAgainWhatWasDone()
    {
        World world;
        Session &session = world.session;
        session.goTo({4, 0});
        session.grab("foot");
        session.moveHand({310, 220});
        session.frameForward();
        session.frameForward();
        session.letGo();
        session.goTo({15, 0});
        const sim::State before = session.timeline().state();
        QVERIFY(!session.recordedHand());
        session.repeat();
        QVERIFY(session.isPlaying());
        QCOMPARE(session.timeline().cursor(), sim::Cursor{});
        QVERIFY(session.hasInput());
        session.pause();
        session.goTo({5, 0}); // the hand of then is seen
        QVERIFY(session.recordedHand());
        QVERIFY(*session.recordedHand() == (sim::Vec2{310, 220}));
        session.goTo({15, 0});
        QVERIFY(!session.recordedHand());
        QVERIFY(sim::sameBits(session.timeline().state(), before));
    }

    void aBodyInTheHandIsLetGoBeforeItIsUndone()
    {
        World world;
        Session &session = world.session;
        session.goTo({5, 0});
        const sim::State before = session.timeline().state();
        session.grab("foot");
        session.moveHand({100, 100});
        session.undo();
        QVERIFY(!session.isHolding());
        QCOMPARE(session.timeline().state().hold.point, -1);
        QVERIFY(sim::sameBits(session.timeline().state(), before));
        QVERIFY(session.timeline().script().input.empty());
    }

    void whatWasUndoneStaysBesideItAsAGhost()
    {
        World world;
        Session &session = world.session;
        session.goTo({20, 0});
        session.setEffect("body_spring", false);
        QCOMPARE(session.ghostName(), "before: Spring on");
        session.undo();
        QCOMPARE(session.ghostName(), "undone: Spring off");
        session.redo();
        QCOMPARE(session.ghostName(), "before: Spring on");
    }

    void aGestureIsOneEntry()
    {
        World world;
        Session &session = world.session;
        session.goTo({10, 0});
        for (const double k : {0.21, 0.22, 0.23})
            session.setParameter("k", k);
        session.endGesture();
        QCOMPARE(session.deeds().count(), 1);
        session.setParameter("k", 0.3);
        QCOMPARE(session.deeds().count(), 2);
        session.grab("foot");
        session.moveHand({310, 220});
        session.frameForward();
        session.moveHand({320, 230});
        session.letGo();
        QCOMPARE(session.deeds().count(), 3);
        session.grab("foot");
        session.letGo();
        QCOMPARE(session.deeds().count(), 4);
        session.undo();
        session.undo();
        session.undo();
        QCOMPARE(session.parameter("k"), 0.23);
        session.undo();
        QCOMPARE(session.parameter("k"), 0.2);
    }

    void undoingAllAndRedoingAllGivesTheSameBits()
    {
        World world;
        Session &session = world.session;
        std::mt19937 dice(7);
        const auto pick = [&](int below) { return static_cast<int>(dice() % static_cast<unsigned>(below)); };
        const auto at = [&](std::int64_t frame) {
            session.goTo({frame, 0});
            return session.timeline().state();
        };
        for (int round = 0; round < 20; ++round) {
            session.openStep("legs", "puppet");
            session.openStep("legs", "tied");
            session.startAfresh();
            const sim::State start = at(30);
            const int before = session.deeds().index();
            for (int i = 0; i < 12; ++i) {
                session.goTo({pick(30), 0});
                switch (pick(6)) {
                case 0:
                    session.setParameter("k", 0.01 * (1 + pick(90)));
                    session.endGesture();
                    break;
                case 1:
                    session.setEffect("body_spring", pick(2) == 0);
                    break;
                case 2:
                    session.setEffect("damping", pick(2) == 0);
                    break;
                case 3:
                    session.setMethod(pick(2) == 0 ? "rk4" : "published");
                    break;
                case 4:
                    session.grab("foot");
                    session.moveHand({200.0 + pick(100), 150.0 + pick(100)});
                    session.frameForward();
                    session.letGo();
                    break;
                default:
                    session.resetParameters();
                }
            }
            const sim::State end = at(30);
            while (session.deeds().index() > before)
                session.undo();
            QVERIFY(sim::sameBits(at(30), start));
            while (session.deeds().canRedo())
                session.redo();
            QVERIFY(sim::sameBits(at(30), end));
        }
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(UndoTest)
#include "tst_undo.moc"

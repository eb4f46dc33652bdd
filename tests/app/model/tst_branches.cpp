// Branches: going back gives the same bits, and branches can be named, kept and deleted.

#include "tests/app/model/branches_support.h"

#include "app/model/run/same_run.h"
#include "app/model/text/difference_text.h"
#include "tests/suite.h"

#include <QSignalSpy>
#include <QtTest>

using namespace app;
using branches_support::World;

class BranchesTest : public QObject
{
    Q_OBJECT

private slots:
    void aChangeToThePastLeavesABranchThatSaysWhatDiffers()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        QCOMPARE(world.names(), QStringList{"before: gravity 0.5"});
        const Branch &branch = world.session.comparisons().branches().all().front();
        QCOMPARE(world.session.comparisons().shown(), &branch);
        QCOMPARE(branch.end, 60);
        QVERIFY(branch.script->input.empty());
        QCOMPARE(lastShared(world.session.timeline().script(), *branch.script), 30);
        QCOMPARE(branchLine(branch, world.session.timeline().script()),
                 "before: gravity 0.5, branches off at frame 30");
        world.session.editor().setMethod("rk4");
        QCOMPARE(world.names().size(), 2);
        QVERIFY(
            branchLine(world.session.comparisons().branches().all().back(), world.session.timeline().script())
                .endsWith("branches off at the start"));
    }

    void draggingAtTheEndOfTheRunLeavesNoBranch()
    {
        World world;
        world.session.playback().goTo({30, 0});
        world.session.editor().setParameter("gravity", 0.75);
        world.session.playback().goTo({40, 0});
        world.session.input().grab("foot");
        world.session.playback().frameForward();
        world.session.input().release();
        QVERIFY(world.session.comparisons().branches().isEmpty());
    }

    void aDragOfASliderIsOneBranch()
    {
        World world;
        world.session.playback().goTo({60, 0});
        for (const std::int64_t frame : {30, 0}) {
            const std::size_t before = world.session.comparisons().branches().all().size();
            world.session.playback().goTo({frame, 0});
            for (const double gravity : {0.6, 0.7, 0.8})
                world.session.editor().setParameter("gravity", gravity + 0.01 * double(frame));
            world.session.editor().endGesture();
            QCOMPARE(world.session.comparisons().branches().all().size(), before + 1);
        }
    }

    void goingBackGivesTheSameBitsAndLeavesTheOtherAsABranch_data()
    {
        QTest::addColumn<QString>("what");
        for (const char *what : {"parameter", "parameter at the start", "method", "effect", "hand", "afresh"})
            QTest::newRow(what) << what;
    }

    void goingBackGivesTheSameBitsAndLeavesTheOtherAsABranch()
    {
        QFETCH(QString, what);
        for (const bool asComparison : {true, false}) {
            World world("tied");
            Session &session = world.session;
            session.playback().goTo({7, 0});
            session.input().grab("foot");
            session.input().moveTo({330, 180});
            session.playback().goTo({12, 0});
            session.input().release();
            session.playback().goTo({60, 0});
            const sim::Script old = session.timeline().script();
            const sim::State oldState = session.timeline().state();
            session.playback().goTo({what.endsWith("start") ? 0 : 30, 0});
            if (what.startsWith("parameter"))
                session.editor().setParameter("k", 0.07);
            else if (what == "method")
                session.editor().setMethod("rk4");
            else if (what == "effect")
                session.editor().setEffect("body_spring", false);
            else if (what == "afresh")
                session.editor().startAfresh();
            else
                session.input().grab("body"), session.input().moveTo({100, 100}), session.input().release();
            const sim::Script other = session.timeline().script();
            const sim::State otherState = world.at(60);
            QVERIFY(!sim::sameBits(otherState, oldState));
            if (!asComparison)
                session.comparisons().show(0);
            for (int round = 0; round < 3; ++round) { // there and back again
                session.playback().goTo({45, 1});
                session.editor().goBackTo(world.newest());
                QCOMPARE(session.comparisons().branches().all().size(), std::size_t(1));
                QCOMPARE(session.timeline().cursor(), (sim::Cursor{45, 1}));
                const bool isOld = round % 2 == 0;
                QVERIFY(sameScript(session.timeline().script(), isOld ? old : other));
                QVERIFY(sameScript(*session.comparisons().shown()->script, isOld ? other : old));
                for (const std::int64_t frame : {60, 31, 0, 59, 75})
                    QVERIFY(sim::sameBits(world.at(frame), world.straight(frame)));
                QVERIFY(sim::sameBits(world.at(60), isOld ? oldState : otherState));
                QVERIFY(session.timeline().comparison());
                QVERIFY(
                    sim::sameBits(session.timeline().comparison()->state(), isOld ? otherState : oldState));
            }
        }
    }

    void branchIsNamedAfterTheChangeThatMadeIt()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.editor().goBackTo(world.newest());
        QCOMPARE(world.names(), QStringList{"after: gravity 0.75"});
        world.session.editor().goBackTo(world.newest());
        QCOMPARE(world.names(), QStringList{"before: gravity 0.5"});
    }

    void aNameStaysWithItsRun()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.comparisons().rename(world.newest(), "  slow   fall ");
        world.session.comparisons().keep(world.newest(), true);
        QCOMPARE(world.names(), QStringList{"slow fall"});
        QCOMPARE(world.session.comparisons().comparisonName(), "slow fall");
        world.session.editor().goBackTo(world.newest());
        world.session.editor().goBackTo(world.newest());
        QCOMPARE(world.names(), QStringList{"slow fall"});
        QVERIFY(world.session.comparisons().branches().all().back().isKept);
        world.session.editor().goBackTo(world.newest());
        world.session.playback().goTo({60, 0});
        world.session.playback().goTo({10, 0});
        world.session.editor().setParameter("gravity", 0.25);
        QVERIFY(world.names().contains("slow fall"));
        world.session.comparisons().rename(world.newest(), "   ");
        QVERIFY(world.names().contains("slow fall"));
    }

    void nameMayContainThePlaceholdersOfTranslatedTexts()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.comparisons().rename(world.newest(), "50%2");
        world.fork(60, 30, "gravity", 0.25);
        world.session.comparisons().rename(world.newest(), "50%2");
        QCOMPARE(world.names(), (QStringList{"50%2", "50%2 (2)"}));
    }

    void branchesWithEqualNamesAreDistinguished()
    {
        World world("tied");
        for (int i = 0; i < 3; ++i) {
            world.session.playback().goTo({60, 0});
            world.session.playback().goTo({30, 0});
            world.session.input().grab("foot");
            world.session.input().moveTo({100.0 + i, 100});
            world.session.input().release();
        }
        QCOMPARE(world.names(), (QStringList{"before: your hand", "before: your hand at frame 30",
                                             "before: your hand at frame 30 (2)"}));
        world.session.comparisons().rename(world.newest(), "before: your hand");
        QCOMPARE(world.names().back(), "before: your hand (2)");
    }

    void oldestBranchThatIsNotKeptIsRemoved()
    {
        World world;
        QVERIFY(Branches::mostPassing >= 6);
        for (int i = 0; i < 6; ++i)
            world.fork(60, 30, "gravity", 0.1 + 0.0625 * i);
        QCOMPARE(world.names().size(), 6);
        const QString first = world.names().at(0), second = world.names().at(1);
        world.session.comparisons().keep(world.session.comparisons().branches().all().front().id, true);
        world.fork(60, 30, "gravity", 1.0);
        QCOMPARE(world.names().size(), 7); // one kept, six that pass
        world.fork(60, 30, "gravity", 1.25);
        QCOMPARE(world.names().size(), 7);
        QVERIFY(world.names().contains(first));
        QVERIFY(!world.names().contains(second));
        world.session.editor().undo();
        QVERIFY(world.names().contains(second));
    }

    void aDeletedBranchIsGoneUntilTheDeletionIsUndone()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.fork(60, 30, "gravity", 1.0);
        const QStringList before = world.names();
        const int shown = world.newest();
        world.session.comparisons().remove(shown);
        QCOMPARE(world.names(), before.mid(0, 1));
        QVERIFY(!world.session.comparisons().shown() && !world.session.timeline().comparison());
        world.session.editor().undo();
        QCOMPARE(world.names(), before);
        QCOMPARE(world.session.comparisons().shown()->id, shown);
        QTRY_VERIFY(world.session.timeline().comparison());
        world.session.editor().redo();
        QCOMPARE(world.names(), before.mid(0, 1));
        world.session.editor().undo();
        world.session.comparisons().removeShown();
        QCOMPARE(world.names(), before.mid(0, 1));
    }

    void eachEditIsOneEntryAndUndoneByItself()
    {
        World world;
        Session &session = world.session;
        world.fork(60, 30, "gravity", 0.75);
        QCOMPARE(session.editor().undoStack().count(), 1);
        const sim::State changed = world.at(50);
        const int branch = world.newest();
        session.comparisons().keep(branch, true);
        session.comparisons().rename(branch, "mine");
        session.editor().goBackTo(branch);
        QCOMPARE(session.editor().undoStack().count(), 4);
        session.comparisons().show(0); // a change of the view, not an edit
        QCOMPARE(session.editor().undoStack().count(), 4);
        const sim::State old = world.at(50);
        QVERIFY(!sim::sameBits(old, changed));
        session.editor().undo();
        QVERIFY(sim::sameBits(world.at(50), changed));
        QVERIFY(world.names().contains("mine"));
        session.editor().undo();
        QVERIFY(!world.names().contains("mine"));
        QVERIFY(session.comparisons().branches().all().front().isKept);
        session.editor().undo();
        QVERIFY(!session.comparisons().branches().all().front().isKept);
        while (session.editor().undoStack().canRedo())
            session.editor().redo();
        QVERIFY(sim::sameBits(world.at(50), old));
        QCOMPARE(world.names(), QStringList{"after: gravity 0.75"});
    }

    void undoingLeavesWhatWasUndoneAsABranchThatDoesNotPileUp()
    {
        World world;
        for (int i = 0; i < 5; ++i)
            world.fork(60, 30, "gravity", 0.125 * (i + 5));
        world.session.playback().goTo({60, 0});
        for (int i = 4; i >= 0; --i) {
            world.session.editor().undo();
            QCOMPARE(world.names().size(), i + 1);
            QCOMPARE(world.names().last(), "undone: Change gravity");
        }
        for (int i = 1; i <= 5; ++i) {
            world.session.editor().redo();
            QCOMPARE(world.names().size(), i);
            QVERIFY(!world.names().join(' ').contains("undone"));
        }
    }

    void runEqualToTheCurrentOneMakesNoBranch()
    {
        World world;
        world.session.playback().goTo({60, 0});
        world.session.playback().goTo({0, 0});
        for (const double gravity : {0.6, 0.7, 0.5}) // away, and in the same gesture back
            world.session.editor().setParameter("gravity", gravity);
        QVERIFY(world.session.comparisons().branches().isEmpty());
        QVERIFY(!world.session.timeline().comparison());
        QCOMPARE(world.session.editor().undoStack().count(), 0);
        world.session.editor().setParameter("gravity",
                                            0.75); // and the run that was computed to frame 60 is not lost
        QCOMPARE(world.names(), QStringList{"before: gravity 0.5"});
        QVERIFY(world.session.timeline().comparison());
        QCOMPARE(world.session.comparisons().branches().all().front().end, 60);
    }

    void branchesReturnWithTheirStep()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        const QStringList names = world.names();
        world.session.openStep("legs", "tied");
        QVERIFY(world.session.comparisons().branches().isEmpty());
        world.session.openStep("fall", "fall");
        QCOMPARE(world.names(), names);
        QVERIFY(!world.session.comparisons().shown());
        world.session.comparisons().show(world.newest());
        QTRY_VERIFY(world.session.timeline().comparison());
    }

    void aSavedRunBringsItsBranchesBackBitForBit_data()
    {
        QTest::addColumn<std::int64_t>("fork");
        QTest::newRow("from the start") << std::int64_t{0};
        QTest::newRow("on the way") << std::int64_t{30};
    }
    void aSavedRunBringsItsBranchesBackBitForBit()
    {
        QFETCH(std::int64_t, fork);
        World world;
        world.fork(60, fork, "gravity", 0.75);
        sim::Track left(*world.session.comparisons().branches().all().back().script, 0);
        left.seek({60, 0});
        const sim::State old = left.state();
        const sim::State own = world.straight(60);
        world.session.comparisons().rename(world.newest(), "the light one");
        const QByteArray text = experimentText(world.session.experiment(), world.session.library());
        World later;
        later.session.open(parseExperiment(text, "x.json", later.session.library()));
        QCOMPARE(later.names(), QStringList{"the light one"});
        QVERIFY(sim::sameBits(later.straight(60), own));
        QCOMPARE(later.session.comparisons().branches().all().front().end, 60);
        later.session.playback().goTo({60, 0});
        later.session.editor().goBackTo(later.newest());
        QVERIFY(sim::sameBits(later.session.timeline().state(), old));
        QVERIFY(sim::sameBits(later.straight(60), old));
        // The name went with it, and is in the next file.
        const QByteArray again = experimentText(later.session.experiment(), later.session.library());
        QCOMPARE(parseExperiment(again, "x.json", later.session.library()).branches.own().name,
                 QString("the light one"));
    }

    void longBranchIsComputedInSlicesAndCanBeCancelled()
    {
        World world;
        Session &session = world.session;
        constexpr std::int64_t far = 400'000;
        world.fork(60, 30, "gravity", 0.75);
        const int branch = world.newest();
        session.comparisons().show(0);
        session.playback().goTo({far, 0});
        QTRY_VERIFY_WITH_TIMEOUT(!session.playback().goal(), 60'000);
        session.comparisons().show(branch);
        QVERIFY(session.comparisons().isComputing());
        QVERIFY(!session.timeline().comparison());
        QSignalSpy said(&session.changes(), &ChangeNotifier::messageRequested);
        session.cancelComputing();
        QVERIFY(!session.comparisons().isComputing() && !session.comparisons().shown());
        QVERIFY(said.back().front().toString().contains("not shown"));
        session.comparisons().show(branch);
        QTRY_VERIFY_WITH_TIMEOUT(!session.comparisons().isComputing(), 60'000);
        QCOMPARE(session.timeline().comparison()->cursor().frame, far);
        QVERIFY(session.timeline().keyframeBytes() > 0);
        QVERIFY(session.timeline().keyframeBytes() <= sim::Timeline::defaultBudget);
        sim::Track straight(*session.comparisons().shown()->script, 0);
        straight.seek({far, 0});
        QVERIFY(sim::sameBits(session.timeline().comparison()->state(), straight.state()));
    }
};

SUITE(tst_branches, BranchesTest)
#include "tst_branches.moc"

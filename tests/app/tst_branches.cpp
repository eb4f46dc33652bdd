// Runs that were left for another one: gone back to with the same bits, named, kept and deleted.

#include "branches_bench.h"

#include "app/model/difference_words.h"
#include "app/model/same_run.h"

#include <QSignalSpy>
#include <QtTest>

using namespace app;
using branches_bench::World;

class BranchesTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase()
    {
        QSettings::setDefaultFormat(QSettings::IniFormat);
        QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
    }

    void aChangeToThePastLeavesABranchThatSaysWhatDiffers()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        QCOMPARE(world.names(), QStringList{"before: gravity 0.5"});
        const Branch &branch = world.session.branches().all().front();
        QCOMPARE(world.session.beside(), &branch);
        QCOMPARE(branch.end, 60);
        QVERIFY(branch.script->input.empty());
        QCOMPARE(lastShared(world.session.timeline().script(), *branch.script), 30);
        QCOMPARE(branchLine(branch, world.session.timeline().script()),
                 "before: gravity 0.5, parts at frame 30");
        world.session.setMethod("rk4");
        QCOMPARE(world.names().size(), 2);
        QVERIFY(branchLine(world.session.branches().all().back(), world.session.timeline().script())
                    .endsWith("parts at the start"));
    }

    void whatGoesOnAtTheEndLeavesNoBranch()
    {
        World world;
        world.session.goTo({30, 0});
        world.session.setParameter("gravity", 0.75);
        world.session.goTo({40, 0});
        world.session.grab("foot");
        world.session.frameForward();
        world.session.letGo();
        QVERIFY(world.session.branches().isEmpty());
    }

    void aDragOfASliderIsOneBranch()
    {
        World world;
        world.session.goTo({60, 0});
        for (const std::int64_t frame : {30, 0}) {
            const std::size_t before = world.session.branches().all().size();
            world.session.goTo({frame, 0});
            for (const double gravity : {0.6, 0.7, 0.8})
                world.session.setParameter("gravity", gravity + 0.01 * double(frame));
            world.session.endGesture();
            QCOMPARE(world.session.branches().all().size(), before + 1);
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
        for (const bool asGhost : {true, false}) {
            World world("tied");
            Session &session = world.session;
            session.goTo({7, 0});
            session.grab("foot");
            session.moveHand({330, 180});
            session.goTo({12, 0});
            session.letGo();
            session.goTo({60, 0});
            const sim::Script old = session.timeline().script();
            const sim::State oldState = session.timeline().state();
            session.goTo({what.endsWith("start") ? 0 : 30, 0});
            if (what.startsWith("parameter"))
                session.setParameter("k", 0.07);
            else if (what == "method")
                session.setMethod("rk4");
            else if (what == "effect")
                session.setEffect("body_spring", false);
            else if (what == "afresh")
                session.startAfresh();
            else
                session.grab("body"), session.moveHand({100, 100}), session.letGo();
            const sim::Script other = session.timeline().script();
            const sim::State otherState = world.at(60);
            QVERIFY(!sim::sameBits(otherState, oldState));
            if (!asGhost)
                session.showBeside(0);
            for (int round = 0; round < 3; ++round) { // there and back again
                session.goTo({45, 1});
                session.goBackTo(world.newest());
                QCOMPARE(session.branches().all().size(), std::size_t(1));
                QCOMPARE(session.timeline().cursor(), (sim::Cursor{45, 1}));
                const bool isOld = round % 2 == 0;
                QVERIFY(sameScript(session.timeline().script(), isOld ? old : other));
                QVERIFY(sameScript(*session.beside()->script, isOld ? other : old));
                for (const std::int64_t frame : {60, 31, 0, 59, 75})
                    QVERIFY(sim::sameBits(world.at(frame), world.straight(frame)));
                QVERIFY(sim::sameBits(world.at(60), isOld ? oldState : otherState));
                QVERIFY(session.timeline().comparison());
                QVERIFY(
                    sim::sameBits(session.timeline().comparison()->state(), isOld ? otherState : oldState));
            }
        }
    }

    void theRunThatIsLeftIsCalledByWhatMadeIt()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.goBackTo(world.newest());
        QCOMPARE(world.names(), QStringList{"after: gravity 0.75"});
        world.session.goBackTo(world.newest());
        QCOMPARE(world.names(), QStringList{"before: gravity 0.5"});
    }

    void aNameStaysWithItsRun()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.renameBranch(world.newest(), "  slow   fall ");
        world.session.keepBranch(world.newest(), true);
        QCOMPARE(world.names(), QStringList{"slow fall"});
        QCOMPARE(world.session.ghostName(), "slow fall");
        world.session.goBackTo(world.newest());
        world.session.goBackTo(world.newest());
        QCOMPARE(world.names(), QStringList{"slow fall"});
        QVERIFY(world.session.branches().all().back().isKept);
        world.session.goBackTo(world.newest());
        world.session.goTo({60, 0});
        world.session.goTo({10, 0});
        world.session.setParameter("gravity", 0.25);
        QVERIFY(world.names().contains("slow fall"));
        world.session.renameBranch(world.newest(), "   ");
        QVERIFY(world.names().contains("slow fall"));
    }

    void aNameMayHaveMarksOfOurOwnTextsInIt()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.session.renameBranch(world.newest(), "50%2");
        world.fork(60, 30, "gravity", 0.25);
        world.session.renameBranch(world.newest(), "50%2");
        QCOMPARE(world.names(), (QStringList{"50%2", "50%2 (2)"}));
    }

    void twoOfOneNameAreTold()
    {
        World world("tied");
        for (int i = 0; i < 3; ++i) {
            world.session.goTo({60, 0});
            world.session.goTo({30, 0});
            world.session.grab("foot");
            world.session.moveHand({100.0 + i, 100});
            world.session.letGo();
        }
        QCOMPARE(world.names(), (QStringList{"before: your hand", "before: your hand at frame 30",
                                             "before: your hand at frame 30 (2)"}));
        world.session.renameBranch(world.newest(), "before: your hand");
        QCOMPARE(world.names().back(), "before: your hand (2)");
    }

    void theOldestGoesThatIsNotKept()
    {
        World world;
        QVERIFY(Branches::mostPassing >= 6);
        for (int i = 0; i < 6; ++i)
            world.fork(60, 30, "gravity", 0.1 + 0.0625 * i);
        QCOMPARE(world.names().size(), 6);
        const QString first = world.names().at(0), second = world.names().at(1);
        world.session.keepBranch(world.session.branches().all().front().id, true);
        world.fork(60, 30, "gravity", 1.0);
        QCOMPARE(world.names().size(), 7); // one kept, six that pass
        world.fork(60, 30, "gravity", 1.25);
        QCOMPARE(world.names().size(), 7);
        QVERIFY(world.names().contains(first));
        QVERIFY(!world.names().contains(second));
        world.session.undo();
        QVERIFY(world.names().contains(second));
    }

    void whatIsDeletedIsGoneUntilThatIsUndone()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        world.fork(60, 30, "gravity", 1.0);
        const QStringList before = world.names();
        const int shown = world.newest();
        world.session.deleteBranch(shown);
        QCOMPARE(world.names(), before.mid(0, 1));
        QVERIFY(!world.session.beside() && !world.session.timeline().comparison());
        world.session.undo();
        QCOMPARE(world.names(), before);
        QCOMPARE(world.session.beside()->id, shown);
        QVERIFY(world.session.timeline().comparison());
        world.session.redo();
        QCOMPARE(world.names(), before.mid(0, 1));
        world.session.undo();
        world.session.forgetGhost();
        QCOMPARE(world.names(), before.mid(0, 1));
    }

    void eachDeedIsOneEntryAndUndoneByItself()
    {
        World world;
        Session &session = world.session;
        world.fork(60, 30, "gravity", 0.75);
        QCOMPARE(session.deeds().count(), 1);
        const sim::State changed = world.at(50);
        const int branch = world.newest();
        session.keepBranch(branch, true);
        session.renameBranch(branch, "mine");
        session.goBackTo(branch);
        QCOMPARE(session.deeds().count(), 4);
        session.showBeside(0); // a look, no deed
        QCOMPARE(session.deeds().count(), 4);
        const sim::State old = world.at(50);
        QVERIFY(!sim::sameBits(old, changed));
        session.undo();
        QVERIFY(sim::sameBits(world.at(50), changed));
        QVERIFY(world.names().contains("mine"));
        session.undo();
        QVERIFY(!world.names().contains("mine"));
        QVERIFY(session.branches().all().front().isKept);
        session.undo();
        QVERIFY(!session.branches().all().front().isKept);
        while (session.deeds().canRedo())
            session.redo();
        QVERIFY(sim::sameBits(world.at(50), old));
        QCOMPARE(world.names(), QStringList{"after: gravity 0.75"});
    }

    void undoingLeavesWhatWasUndoneAsABranchThatDoesNotPileUp()
    {
        World world;
        for (int i = 0; i < 5; ++i)
            world.fork(60, 30, "gravity", 0.125 * (i + 5));
        world.session.goTo({60, 0});
        for (int i = 4; i >= 0; --i) {
            world.session.undo();
            QCOMPARE(world.names().size(), i + 1);
            QCOMPARE(world.names().last(), "undone: Change gravity");
        }
        for (int i = 1; i <= 5; ++i) {
            world.session.redo();
            QCOMPARE(world.names().size(), i);
            QVERIFY(!world.names().join(' ').contains("undone"));
        }
    }

    void aBranchIsNeverTheRunItself()
    {
        World world;
        world.session.goTo({60, 0});
        world.session.goTo({0, 0});
        for (const double gravity : {0.6, 0.7, 0.5}) // away, and in the same gesture back
            world.session.setParameter("gravity", gravity);
        QVERIFY(world.session.branches().isEmpty());
        QVERIFY(!world.session.timeline().comparison());
        QCOMPARE(world.session.deeds().count(), 0);
        world.session.setParameter("gravity", 0.75); // and the run that was computed to frame 60 is not lost
        QCOMPARE(world.names(), QStringList{"before: gravity 0.5"});
        QVERIFY(world.session.timeline().comparison());
        QCOMPARE(world.session.branches().all().front().end, 60);
    }

    void branchesWaitWhereTheirStepWasLeft()
    {
        World world;
        world.fork(60, 30, "gravity", 0.75);
        const QStringList names = world.names();
        world.session.openStep("legs", "tied");
        QVERIFY(world.session.branches().isEmpty());
        world.session.openStep("fall", "fall");
        QCOMPARE(world.names(), names);
        QVERIFY(!world.session.beside());
        world.session.showBeside(world.newest());
        QVERIFY(world.session.timeline().comparison());
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
        sim::Track left(*world.session.branches().all().back().script, 0);
        left.seek({60, 0});
        const sim::State old = left.state();
        const sim::State own = world.straight(60);
        world.session.renameBranch(world.newest(), "the light one");
        const QByteArray text = experimentText(world.session.experiment(), world.session.library());
        World later;
        later.session.open(parseExperiment(text, "x.json", later.session.library()));
        QCOMPARE(later.names(), QStringList{"the light one"});
        QVERIFY(sim::sameBits(later.straight(60), own));
        QCOMPARE(later.session.branches().all().front().end, 60);
        later.session.goTo({60, 0});
        later.session.goBackTo(later.newest());
        QVERIFY(sim::sameBits(later.session.timeline().state(), old));
        QVERIFY(sim::sameBits(later.straight(60), old));
        // The name went with it, and is in the next file.
        const QByteArray again = experimentText(later.session.experiment(), later.session.library());
        QCOMPARE(parseExperiment(again, "x.json", later.session.library()).branches.own().name,
                 QString("the light one"));
    }

    void aFarBranchComesInSlicesAndCanBeStopped()
    {
        World world;
        Session &session = world.session;
        constexpr std::int64_t far = 400'000;
        world.fork(60, 30, "gravity", 0.75);
        const int branch = world.newest();
        session.showBeside(0);
        session.goTo({far, 0});
        QTRY_VERIFY_WITH_TIMEOUT(!session.goingTo(), 60'000);
        session.showBeside(branch);
        QVERIFY(session.isBringing());
        QVERIFY(!session.timeline().comparison());
        QSignalSpy said(&session, &Session::said);
        session.stopGoing();
        QVERIFY(!session.isBringing() && !session.beside());
        QVERIFY(said.back().front().toString().contains("not shown"));
        session.showBeside(branch);
        QTRY_VERIFY_WITH_TIMEOUT(!session.isBringing(), 60'000);
        QCOMPARE(session.timeline().comparison()->cursor().frame, far);
        QVERIFY(session.timeline().keyframeBytes() <= sim::Timeline::defaultBudget);
        sim::Track straight(*session.beside()->script, 0);
        straight.seek({far, 0});
        QVERIFY(sim::sameBits(session.timeline().comparison()->state(), straight.state()));
    }

private:
    QTemporaryDir m_folder;
};

QTEST_MAIN(BranchesTest)
#include "tst_branches.moc"

// Autosaved scenes, and how the next start offers them after a crash.

#include "tests/app/support/window_fixture.h"

#include "app/model/files/autosave.h"
#include "app/ui/dialogs/recovery_list.h"
#include "tests/suite.h"

#include <QDir>
#include <QDirIterator>
#include <QTemporaryDir>
#include <QTreeWidget>

using namespace app;
using namespace tests;

namespace {

constexpr int soon = 50; ///< ms, in place of one and a half seconds
static_assert(Autosave::saveWithin < 2000);

QStringList scenesIn(const QString &folder)
{
    QStringList files;
    for (QDirIterator it(folder, {"*.json"}, QDir::Files, QDirIterator::Subdirectories); it.hasNext();)
        files << it.next();
    return files;
}

/// Writes the files that a killed program leaves behind.
void leave(const QString &folder, const Experiment &experiment, const LessonLibrary &library,
           const QDateTime &when = {})
{
    const QString own = folder + "/of-another-program";
    QVERIFY(QDir().mkpath(own));
    const QString path = own + '/' + experiment.lesson + '.' + experiment.step + ".json";
    writeExperiment(path, experiment, library);
    QFile file(path);
    if (when.isValid())
        QVERIFY(file.open(QFile::ReadWrite) && file.setFileTime(when, QFileDevice::FileModificationTime));
    QFile lock(own + "/lock");
    QVERIFY(lock.open(QFile::WriteOnly));
    lock.write("999999999\nspringstep\n\n"); // no program has this number
}

/// Counts how often a timer of `soon` ms runs out.
struct TickCounter : QObject
{
    TickCounter() { qApp->installEventFilter(this); }
    bool eventFilter(QObject *watched, QEvent *event) override
    {
        const auto *timer = qobject_cast<const QTimer *>(watched);
        count += event->type() == QEvent::Timer && timer && timer->interval() == soon;
        return false;
    }

    int count = 0;
};

/// Leaves changed scenes of three steps behind: the first an hour old, the second two hours, the third three.
void leaveThree(const QString &folder)
{
    WindowFixture fixture;
    const QDateTime now = QDateTime::currentDateTime();
    int hours = 0;
    for (const char *step : {"fixed_centre", "moving_body"}) {
        fixture.session.openStep("single_spring", step);
        fixture.session.editor().setParameter("k", 0.3);
        fixture.goTo(30);
        leave(folder, fixture.session.experiment(), fixture.library, now.addSecs(-3600 * ++hours));
    }
    fixture.session.openStep("multi_foot", "two_feet");
    fixture.drag("foot0", {40, 10});
    fixture.goTo(80);
    leave(folder, fixture.session.experiment(), fixture.library, now.addSecs(-3600 * ++hours));
}

RecoveryList *listOf(WindowFixture &fixture)
{
    return fixture.window.findChild<RecoveryList *>();
}

QTreeWidget &rowsOf(WindowFixture &fixture)
{
    return *listOf(fixture)->findChild<QTreeWidget *>();
}

}

class RecoveryTest : public QObject
{
    Q_OBJECT

private slots:
    void nothingIsWrittenAndNothingRunsWhileNothingChanges();
    void aChangeIsKeptAndTheSameIsNotWrittenAgain();
    void everyStepThatWasChangedIsKept();
    void savingOrUndoingDeletesTheAutosavedScene();
    void theSceneOfAKilledProgramIsOfferedAndGoesOnWhereItWas();
    void onlyTheLastProgramIsReportedAsCrashed();
    void aRunThatIsNamedIsKeptAndComesBack();
    void aDeletedRecoveryIsNotOfferedAgain();
    void aClosedNoticeForgetsNothing();
    void anUnsavedSceneIsOfferedAfterANormalExit();
    void aProgramThatRunsKeepsItsScenesToItself();
    void severalScenesAreListedWithTitleLengthAndTime();
    void anyListedSceneCanBeRecoveredOrDeleted();
    void aSceneKeepsTheTimeOfItsLastChangeThroughRestarts();
    void aBuiltSceneIsOfferedInTheSandbox();
    void aDamagedSceneIsRefusedWithASentence();
    void unwritableFolderIsReportedOnce();

private:
    QTemporaryDir m_folder;
};

void RecoveryTest::nothingIsWrittenAndNothingRunsWhileNothingChanges()
{
    const QTemporaryDir folder;
    WindowFixture fixture;
    fixture.window.autosaveIn(folder.path(), soon);
    fixture.goTo(200);
    fixture.goTo(100);
    const TickCounter ticks;
    QVERIFY(Activity().comesToRest(4 * soon));
    QCOMPARE(ticks.count, 0);
    QVERIFY(QDir(folder.path()).isEmpty());
    fixture.session.editor().setParameter("k", 0.3);
    QTRY_COMPARE(ticks.count, 1);
    QVERIFY(Activity().comesToRest(6 * soon));
    QCOMPARE(ticks.count, 1);
}

void RecoveryTest::aChangeIsKeptAndTheSameIsNotWrittenAgain()
{
    const QTemporaryDir folder;
    WindowFixture fixture;
    fixture.window.autosaveIn(folder.path(), soon);
    fixture.drag("foot", {40, 10});
    QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
    const Experiment kept = readExperiment(scenesIn(folder.path()).front(), fixture.library);
    QCOMPARE(kept.script.input, fixture.session.timeline().script().input);
    QVERIFY(QFile::remove(scenesIn(folder.path()).front()));
    fixture.session.comparisons().removeShown(); // says that the run has changed, which it has not
    fixture.key(Qt::Key_PageDown);
    fixture.session.editor().setParameter("k", 0.3);
    // Files are written in the order of their changes, so the first step is not written before the second one either.
    QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
    QVERIFY(scenesIn(folder.path()).front().endsWith("single_spring.moving_body.json"));
}

void RecoveryTest::everyStepThatWasChangedIsKept()
{
    const QTemporaryDir folder;
    {
        WindowFixture fixture;
        fixture.window.autosaveIn(folder.path(), soon);
        fixture.session.editor().setParameter("k", 0.3);
        fixture.key(Qt::Key_PageDown, {});
        fixture.session.editor().setParameter("k", 0.4);
    }
    const QStringList files = scenesIn(folder.path());
    QCOMPARE(files.size(), 2);
    QVERIFY(files.join(' ').contains("single_spring.fixed_centre.json"));
    QVERIFY(files.join(' ').contains("single_spring.moving_body.json"));
}

void RecoveryTest::savingOrUndoingDeletesTheAutosavedScene()
{
    const QTemporaryDir folder;
    WindowFixture fixture;
    fixture.window.autosaveIn(folder.path(), soon);
    fixture.session.editor().setParameter("k", 0.3);
    QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
    QVERIFY(fixture.window.saveFile(m_folder.filePath("kept.json")));
    fixture.session.editor().endGesture();
    QTRY_COMPARE(scenesIn(folder.path()).size(), 0);
    fixture.session.editor().setParameter("k", 0.4);
    QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
    fixture.key(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(scenesIn(folder.path()).size(), 0);
}

void RecoveryTest::theSceneOfAKilledProgramIsOfferedAndGoesOnWhereItWas()
{
    const QTemporaryDir folder;
    WindowFixture fixture({"multi_foot", "two_feet"});
    fixture.drag("foot0", {40, 10});
    fixture.goTo(80);
    const sim::State end = fixture.session.timeline().state();
    leave(folder.path(), fixture.session.experiment(), fixture.library);
    WindowFixture next;
    next.window.autosaveIn(folder.path(), soon);
    const QString said = next.notice.sentence();
    QVERIFY2(said.startsWith("Springstep did not close normally.") &&
                 said.contains(fixture.session.step().title),
             qPrintable(said));
    QVERIFY(!QApplication::activeModalWidget());
    QCOMPARE(next.session.step().id, QString("fixed_centre"));
    QVERIFY(next.answer("Recover"));
    QCOMPARE(next.session.step().id, QString("two_feet"));
    QCOMPARE(next.session.timeline().cursor().frame, 80);
    QVERIFY(sim::sameBits(next.session.timeline().state(), end));
    QVERIFY(next.isMarked());
    // Only the program that has recovered the scene autosaves it.
    QCOMPARE(scenesIn(folder.path()).size(), 1);
    QVERIFY(!QDir(folder.path() + "/of-another-program").exists());
}

void RecoveryTest::onlyTheLastProgramIsReportedAsCrashed()
{
    const QTemporaryDir folder;
    {
        WindowFixture killed({"multi_foot", "two_feet"});
        killed.drag("foot0", {40, 10});
        leave(folder.path(), killed.session.experiment(), killed.library);
    }
    {
        WindowFixture closed;
        closed.window.autosaveIn(folder.path(), soon);
        QVERIFY(closed.notice.sentence().startsWith("Springstep did not close normally."));
        closed.session.editor().setParameter("k", 0.3);
    }
    WindowFixture next;
    next.window.autosaveIn(folder.path(), soon);
    QCOMPARE(next.notice.sentence(), QString("2 unsaved scenes can be recovered."));
}

void RecoveryTest::aRunThatIsNamedIsKeptAndComesBack()
{
    const QTemporaryDir folder;
    {
        WindowFixture fixture;
        fixture.window.autosaveIn(folder.path(), soon);
        fixture.goTo(40);
        fixture.goTo(20);
        fixture.session.editor().setParameter("k", 0.3);
        QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
        QVERIFY(readExperiment(scenesIn(folder.path()).front(), fixture.library).branches.isEmpty());
        fixture.session.comparisons().rename(fixture.session.comparisons().branches().all().front().id,
                                             "first");
        QTRY_VERIFY(!readExperiment(scenesIn(folder.path()).front(), fixture.library).branches.isEmpty());
    }
    WindowFixture next({"multi_foot", "two_feet"});
    next.window.autosaveIn(folder.path(), soon);
    QVERIFY(next.answer("Recover"));
    QCOMPARE(next.session.comparisons().branches().all().size(), std::size_t(1));
    QCOMPARE(next.session.comparisons().branches().all().front().name, QString("first"));
    QVERIFY(next.isMarked());
}

void RecoveryTest::aDeletedRecoveryIsNotOfferedAgain()
{
    const QTemporaryDir folder;
    WindowFixture fixture;
    fixture.session.editor().setParameter("k", 0.3);
    leave(folder.path(), fixture.session.experiment(), fixture.library);
    WindowFixture next;
    next.window.autosaveIn(folder.path(), soon);
    QVERIFY(next.answer("Delete"));
    QVERIFY(!next.notice.isVisible());
    QVERIFY(QDir(folder.path()).isEmpty());
}

void RecoveryTest::aClosedNoticeForgetsNothing()
{
    const QTemporaryDir folder;
    WindowFixture fixture;
    fixture.session.editor().setParameter("k", 0.3);
    leave(folder.path(), fixture.session.experiment(), fixture.library);
    for (int start = 0; start < 2; ++start) {
        WindowFixture next;
        next.window.autosaveIn(folder.path(), soon);
        QVERIFY(next.notice.isVisible());
        next.key(Qt::Key_Escape, {});
        QTRY_VERIFY(!next.notice.isVisible());
    }
    QCOMPARE(scenesIn(folder.path()).size(), 1);
}

void RecoveryTest::anUnsavedSceneIsOfferedAfterANormalExit()
{
    const QTemporaryDir folder;
    {
        WindowFixture fixture;
        fixture.window.autosaveIn(folder.path(), soon);
        fixture.session.editor().setParameter("k", 0.3);
        QVERIFY(fixture.window.close());
    }
    WindowFixture next;
    next.window.autosaveIn(folder.path(), soon);
    QVERIFY2(next.notice.sentence().contains("was not saved"), qPrintable(next.notice.sentence()));
    QVERIFY(next.answer("Recover"));
    QCOMPARE(next.session.timeline().values()["k"], 0.3);
}

void RecoveryTest::aProgramThatRunsKeepsItsScenesToItself()
{
    const QTemporaryDir folder;
    WindowFixture one, two;
    one.window.autosaveIn(folder.path(), soon);
    one.session.editor().setParameter("k", 0.3);
    QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
    two.window.autosaveIn(folder.path(), soon);
    QVERIFY(!two.notice.isVisible());
    two.session.editor().setParameter("k", 0.4);
    QTRY_COMPARE(scenesIn(folder.path()).size(), 2);
    one.session.editor().undo();
    QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
    const Experiment kept = readExperiment(scenesIn(folder.path()).front(), two.library);
    QCOMPARE(kept.script.input, two.session.timeline().script().input);
    QCOMPARE(kept.script.values, two.session.timeline().script().values);
}

void RecoveryTest::severalScenesAreListedWithTitleLengthAndTime()
{
    const QTemporaryDir folder;
    leaveThree(folder.path());
    WindowFixture fixture;
    fixture.window.autosaveIn(folder.path(), soon);
    QVERIFY2(fixture.notice.sentence().contains("3 unsaved scenes"), qPrintable(fixture.notice.sentence()));
    QVERIFY(fixture.answer("Show them"));
    const QTreeWidget &rows = rowsOf(fixture);
    QVERIFY(rows.isVisible());
    QCOMPARE(rows.topLevelItemCount(), 3);
    const QTreeWidgetItem &last = *rows.topLevelItem(2); // the latest first
    QVERIFY(last.text(0).contains(fixture.library.lesson("multi_foot")->title));
    QVERIFY(last.text(0).contains(fixture.library.lesson("multi_foot")->step("two_feet")->title));
    QTRY_COMPARE(last.text(1), QString("80"));
    QCOMPARE(rows.topLevelItem(0)->text(1), QString("30"));
    const QString file = scenesIn(folder.path()).filter("two_feet").front();
    QCOMPARE(last.text(2), timeOf(QFileInfo(file).lastModified()));
}

void RecoveryTest::anyListedSceneCanBeRecoveredOrDeleted()
{
    const QTemporaryDir folder;
    leaveThree(folder.path());
    WindowFixture fixture;
    fixture.window.autosaveIn(folder.path(), soon);
    QVERIFY(fixture.answer("Show them"));
    QTreeWidget &rows = rowsOf(fixture);
    QTest::keyClick(&rows, Qt::Key_Delete); // the latest
    QCOMPARE(rows.topLevelItemCount(), 2);
    QCOMPARE(scenesIn(folder.path()).size(), 2);
    QTest::keyClick(&rows, Qt::Key_Down);
    QTest::keyClick(&rows, Qt::Key_Return);
    QVERIFY(!listOf(fixture)->isVisible());
    QCOMPARE(fixture.session.step().id, QString("two_feet"));
    QCOMPARE(fixture.session.timeline().cursor().frame, 80);
    fixture.actionCalled("Recover scenes…").trigger(); // the other is still there
    QVERIFY(listOf(fixture)->isVisible());
    QCOMPARE(rows.topLevelItemCount(), 1);
    QVERIFY(rows.topLevelItem(0)->text(0).contains(fixture.library.lesson("single_spring")->title));
}

void RecoveryTest::aSceneKeepsTheTimeOfItsLastChangeThroughRestarts()
{
    const QTemporaryDir folder;
    const QDateTime when = QDateTime::fromString("2026-01-02T03:04:05", Qt::ISODate);
    {
        WindowFixture fixture;
        fixture.session.editor().setParameter("k", 0.3);
        leave(folder.path(), fixture.session.experiment(), fixture.library, when);
    }
    for (int restart = 0; restart < 2; ++restart) {
        WindowFixture fixture;
        fixture.window.autosaveIn(folder.path(), soon);
        QVERIFY(fixture.answer("Recover"));
        QCOMPARE(scenesIn(folder.path()).size(), 1);
        QCOMPARE(QFileInfo(scenesIn(folder.path()).front()).lastModified(), when);
        QVERIFY(fixture.window.close());
    }
    QCOMPARE(QFileInfo(scenesIn(folder.path()).front()).lastModified(), when);
    WindowFixture fixture;
    fixture.window.autosaveIn(folder.path(), soon);
    QVERIFY(fixture.answer("Recover"));
    fixture.session.editor().setParameter("k", 0.4); // that is a change
    QTRY_VERIFY(QFileInfo(scenesIn(folder.path()).front()).lastModified() > when);
}

void RecoveryTest::aBuiltSceneIsOfferedInTheSandbox()
{
    const QTemporaryDir folder;
    WindowFixture fixture;
    fixture.window.setMode(MainWindow::Mode::build);
    sim::Blueprint plan = *fixture.session.editor().blueprint();
    plan.points[1].mass = 7.0;
    QVERIFY(fixture.session.editor().build({"Change mass", {}, {}}, plan));
    leave(folder.path(), fixture.session.experiment(), fixture.library);
    WindowFixture next;
    next.window.autosaveIn(folder.path(), soon);
    next.key(Qt::Key_Escape, {}); // not now
    QTRY_VERIFY(!next.notice.isVisible());
    next.window.setMode(MainWindow::Mode::build);
    QVERIFY2(next.notice.sentence().contains(next.session.step().title), qPrintable(next.notice.sentence()));
    QVERIFY(next.answer("Recover"));
    QCOMPARE(next.session.editor().blueprint()->points[1].mass, 7.0);
    QVERIFY(!next.notice.isVisible()); // it is not offered again while it is opened
}

void RecoveryTest::aDamagedSceneIsRefusedWithASentence()
{
    const QTemporaryDir folder;
    WindowFixture fixture;
    leave(folder.path(), fixture.session.experiment(), fixture.library);
    QFile file(scenesIn(folder.path()).front());
    QVERIFY(file.resize(40));
    fixture.window.autosaveIn(folder.path(), soon);
    QVERIFY(fixture.answer("Recover"));
    QVERIFY2(fixture.notice.sentence().startsWith("Could not open the experiment: "),
             qPrintable(fixture.notice.sentence()));
    QVERIFY(file.exists());
}

void RecoveryTest::unwritableFolderIsReportedOnce()
{
    const QTemporaryDir folder;
    const TickCounter ticks;
    QFile inTheWay(folder.filePath("a-file"));
    QVERIFY(inTheWay.open(QFile::WriteOnly));
    WindowFixture fixture;
    fixture.window.autosaveIn(inTheWay.fileName(), soon);
    fixture.session.editor().setParameter("k", 0.3);
    QTRY_VERIFY(fixture.notice.isVisible());
    QVERIFY2(fixture.notice.sentence().contains("Could not save a backup"),
             qPrintable(fixture.notice.sentence()));
    fixture.key(Qt::Key_Escape, {});
    QTRY_VERIFY(!fixture.notice.isVisible());
    const int before = ticks.count;
    fixture.session.editor().setParameter("k", 0.4);
    QTRY_COMPARE(ticks.count, before + 1); // it has tried to write again
    settle();
    QVERIFY(!fixture.notice.isVisible());
}

SUITE(tst_recovery, RecoveryTest)
#include "tst_recovery.moc"

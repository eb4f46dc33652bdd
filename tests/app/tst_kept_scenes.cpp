// What is kept against a crash, and how it is offered at the next start.

#include "window_bench.h"

#include "app/model/scene_keeper.h"
#include "app/ui/window/kept_list.h"

#include <QDir>
#include <QDirIterator>
#include <QTemporaryDir>
#include <QTreeWidget>

using namespace app;
using window_bench::Bench;

namespace {

constexpr int soon = 50; ///< ms, in place of one and a half seconds
static_assert(SceneKeeper::keepWithin < 2000);

QStringList scenesIn(const QString &folder)
{
    QStringList files;
    for (QDirIterator it(folder, {"*.json"}, QDir::Files, QDirIterator::Subdirectories); it.hasNext();)
        files << it.next();
    return files;
}

/// Puts a scene there as a program leaves it that was killed.
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

}

/// Leaves changed scenes of three steps, the first an hour old, the second two hours, the third three.
void leaveThree(const QString &folder)
{
    Bench bench;
    const QDateTime now = QDateTime::currentDateTime();
    int hours = 0;
    for (const char *step : {"fixed_centre", "moving_body"}) {
        bench.session.openStep("single_spring", step);
        bench.session.setParameter("k", 0.3);
        bench.session.goTo({30, 0});
        leave(folder, bench.session.experiment(), bench.library, now.addSecs(-3600 * ++hours));
    }
    bench.session.openStep("multi_foot", "two_feet");
    bench.drag("foot0", {40, 10});
    bench.session.goTo({80, 0});
    leave(folder, bench.session.experiment(), bench.library, now.addSecs(-3600 * ++hours));
}

KeptList *listOf(Bench &bench)
{
    return bench.window.findChild<KeptList *>();
}

QTreeWidget &rowsOf(Bench &bench)
{
    return *listOf(bench)->findChild<QTreeWidget *>();
}

class KeptScenesTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void nothingIsWrittenAndNothingRunsWhileNothingChanges();
    void aChangeIsKeptAndTheSameIsNotWrittenAgain();
    void everyStepThatWasChangedIsKept();
    void whatIsSavedOrUndoneIsKeptNoLonger();
    void whatAKilledProgramLeftIsOfferedAndGoesOnWhereItWas();
    void aRunThatIsNamedIsKeptAndComesBack();
    void whatIsForgottenIsNotOfferedAgain();
    void aClosedNoticeForgetsNothing();
    void whatWasLeftByClosingIsOfferedAsSuch();
    void aProgramThatRunsKeepsItsScenesToItself();
    void severalAreOneListWithWhatWhenAndHowLong();
    void anyOfTheListIsRecoveredOrDeleted();
    void aSceneKeepsTheTimeOfItsLastChangeThroughRestarts();
    void whatWasBuiltIsOfferedWhereBuildingBegins();
    void aDamagedSceneIsRefusedWithASentence();
    void aFolderThatCannotBeWrittenIsSaidOnce();

private:
    QTemporaryDir m_settings;
};

void KeptScenesTest::initTestCase()
{
    window_bench::keepSettingsIn(m_settings.path());
}

void KeptScenesTest::nothingIsWrittenAndNothingRunsWhileNothingChanges()
{
    struct Ticks : QObject
    {
        int count = 0;
        bool eventFilter(QObject *watched, QEvent *event) override
        {
            const auto *timer = qobject_cast<const QTimer *>(watched);
            count += event->type() == QEvent::Timer && timer && timer->interval() == soon;
            return false;
        }
    } ticks;
    const QTemporaryDir folder;
    Bench bench;
    bench.window.keepScenesIn(folder.path(), soon);
    bench.session.goTo({200, 0});
    bench.session.goTo({100, 0});
    qApp->installEventFilter(&ticks);
    QTest::qWait(4 * soon);
    QCOMPARE(ticks.count, 0);
    QVERIFY(QDir(folder.path()).isEmpty());
    bench.session.setParameter("k", 0.3);
    QTRY_COMPARE(ticks.count, 1);
    QTest::qWait(6 * soon);
    QCOMPARE(ticks.count, 1);
}

void KeptScenesTest::aChangeIsKeptAndTheSameIsNotWrittenAgain()
{
    const QTemporaryDir folder;
    Bench bench;
    bench.window.keepScenesIn(folder.path(), soon);
    bench.drag("foot", {40, 10});
    QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
    const Experiment kept = readExperiment(scenesIn(folder.path()).front(), bench.library);
    QCOMPARE(kept.script.input, bench.session.timeline().script().input);
    // The same again is not written again.
    QVERIFY(QFile::remove(scenesIn(folder.path()).front()));
    bench.session.forgetGhost(); // says that the run has changed, which it has not
    QTest::qWait(6 * soon);
    QCOMPARE(scenesIn(folder.path()).size(), 0);
}

void KeptScenesTest::everyStepThatWasChangedIsKept()
{
    const QTemporaryDir folder;
    {
        Bench bench;
        bench.window.keepScenesIn(folder.path(), soon);
        bench.session.setParameter("k", 0.3);
        bench.press(Qt::Key_PageDown, {});
        bench.session.setParameter("k", 0.4);
    }
    const QStringList files = scenesIn(folder.path());
    QCOMPARE(files.size(), 2);
    QVERIFY(files.join(' ').contains("single_spring.fixed_centre.json"));
    QVERIFY(files.join(' ').contains("single_spring.moving_body.json"));
}

void KeptScenesTest::whatIsSavedOrUndoneIsKeptNoLonger()
{
    const QTemporaryDir folder;
    Bench bench;
    bench.window.keepScenesIn(folder.path(), soon);
    bench.session.setParameter("k", 0.3);
    QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
    QVERIFY(bench.window.saveFile(m_settings.filePath("kept.json")));
    bench.session.endGesture();
    QTRY_COMPARE(scenesIn(folder.path()).size(), 0);
    bench.session.setParameter("k", 0.4);
    QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
    bench.press(Qt::Key_Z, Qt::ControlModifier);
    QTRY_COMPARE(scenesIn(folder.path()).size(), 0);
}

void KeptScenesTest::whatAKilledProgramLeftIsOfferedAndGoesOnWhereItWas()
{
    const QTemporaryDir folder;
    Bench bench("multi_foot", "two_feet");
    bench.drag("foot0", {40, 10});
    bench.session.goTo({80, 0});
    const sim::State end = bench.session.timeline().state();
    leave(folder.path(), bench.session.experiment(), bench.library);
    Bench next;
    next.window.keepScenesIn(folder.path(), soon);
    const QString said = next.notice.sentence();
    QVERIFY2(said.startsWith("Springstep was ended by something else.") &&
                 said.contains(bench.session.step().title),
             qPrintable(said));
    QVERIFY(!QApplication::activeModalWidget());
    QCOMPARE(next.session.step().id, QString("fixed_centre"));
    QVERIFY(next.answer("Open it"));
    QCOMPARE(next.session.step().id, QString("two_feet"));
    QCOMPARE(next.session.timeline().cursor().frame, 80);
    QVERIFY(sim::sameBits(next.session.timeline().state(), end));
    QVERIFY(next.isMarked());
    // It is kept by the program that has it now, and by no other.
    QCOMPARE(scenesIn(folder.path()).size(), 1);
    QVERIFY(!QDir(folder.path() + "/of-another-program").exists());
}

void KeptScenesTest::aRunThatIsNamedIsKeptAndComesBack()
{
    const QTemporaryDir folder;
    {
        Bench bench;
        bench.window.keepScenesIn(folder.path(), soon);
        bench.session.goTo({40, 0});
        bench.session.goTo({20, 0});
        bench.session.setParameter("k", 0.3);
        QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
        QVERIFY(readExperiment(scenesIn(folder.path()).front(), bench.library).branches.isEmpty());
        bench.session.renameBranch(bench.session.branches().all().front().id, "first");
        QTRY_VERIFY(!readExperiment(scenesIn(folder.path()).front(), bench.library).branches.isEmpty());
    }
    Bench next("multi_foot", "two_feet");
    next.window.keepScenesIn(folder.path(), soon);
    QVERIFY(next.answer("Open it"));
    QCOMPARE(next.session.branches().all().size(), std::size_t(1));
    QCOMPARE(next.session.branches().all().front().name, QString("first"));
    QVERIFY(next.isMarked());
}

void KeptScenesTest::whatIsForgottenIsNotOfferedAgain()
{
    const QTemporaryDir folder;
    Bench bench;
    bench.session.setParameter("k", 0.3);
    leave(folder.path(), bench.session.experiment(), bench.library);
    Bench next;
    next.window.keepScenesIn(folder.path(), soon);
    QVERIFY(next.answer("Forget it"));
    QVERIFY(!next.notice.isVisible());
    QVERIFY(QDir(folder.path()).isEmpty());
}

void KeptScenesTest::aClosedNoticeForgetsNothing()
{
    const QTemporaryDir folder;
    Bench bench;
    bench.session.setParameter("k", 0.3);
    leave(folder.path(), bench.session.experiment(), bench.library);
    for (int start = 0; start < 2; ++start) {
        Bench next;
        next.window.keepScenesIn(folder.path(), soon);
        QVERIFY(next.notice.isVisible());
        next.press(Qt::Key_Escape, {});
        QTRY_VERIFY(!next.notice.isVisible());
    }
    QCOMPARE(scenesIn(folder.path()).size(), 1);
}

void KeptScenesTest::whatWasLeftByClosingIsOfferedAsSuch()
{
    const QTemporaryDir folder;
    {
        Bench bench;
        bench.window.keepScenesIn(folder.path(), soon);
        bench.session.setParameter("k", 0.3);
        QVERIFY(bench.window.close());
    }
    Bench next;
    next.window.keepScenesIn(folder.path(), soon);
    QVERIFY2(next.notice.sentence().contains("was not saved"), qPrintable(next.notice.sentence()));
    QVERIFY(next.answer("Open it"));
    QCOMPARE(next.session.timeline().values()["k"], 0.3);
}

void KeptScenesTest::aProgramThatRunsKeepsItsScenesToItself()
{
    const QTemporaryDir folder;
    Bench one, two;
    one.window.keepScenesIn(folder.path(), soon);
    one.session.setParameter("k", 0.3);
    QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
    two.window.keepScenesIn(folder.path(), soon);
    QVERIFY(!two.notice.isVisible());
    two.session.setParameter("k", 0.4);
    QTRY_COMPARE(scenesIn(folder.path()).size(), 2);
    one.session.undo();
    QTRY_COMPARE(scenesIn(folder.path()).size(), 1);
    const Experiment kept = readExperiment(scenesIn(folder.path()).front(), two.library);
    QCOMPARE(kept.script.input, two.session.timeline().script().input);
    QCOMPARE(kept.script.values, two.session.timeline().script().values);
}

void KeptScenesTest::severalAreOneListWithWhatWhenAndHowLong()
{
    const QTemporaryDir folder;
    leaveThree(folder.path());
    Bench bench;
    bench.window.keepScenesIn(folder.path(), soon);
    QVERIFY2(bench.notice.sentence().contains("3 scenes"), qPrintable(bench.notice.sentence()));
    QVERIFY(bench.answer("Show them"));
    const QTreeWidget &rows = rowsOf(bench);
    QVERIFY(rows.isVisible());
    QCOMPARE(rows.topLevelItemCount(), 3);
    const QTreeWidgetItem &last = *rows.topLevelItem(2); // the latest first
    QVERIFY(last.text(0).contains(bench.library.lesson("multi_foot")->title));
    QVERIFY(last.text(0).contains(bench.library.lesson("multi_foot")->step("two_feet")->title));
    QTRY_COMPARE(last.text(1), QString("80"));
    QCOMPARE(rows.topLevelItem(0)->text(1), QString("30"));
    const QString file = scenesIn(folder.path()).filter("two_feet").front();
    QCOMPARE(last.text(2), timeOf(QFileInfo(file).lastModified()));
}

void KeptScenesTest::anyOfTheListIsRecoveredOrDeleted()
{
    const QTemporaryDir folder;
    leaveThree(folder.path());
    Bench bench;
    bench.window.keepScenesIn(folder.path(), soon);
    QVERIFY(bench.answer("Show them"));
    QTreeWidget &rows = rowsOf(bench);
    QTest::keyClick(&rows, Qt::Key_Delete); // the latest
    QCOMPARE(rows.topLevelItemCount(), 2);
    QCOMPARE(scenesIn(folder.path()).size(), 2);
    QTest::keyClick(&rows, Qt::Key_Down);
    QTest::keyClick(&rows, Qt::Key_Return);
    QVERIFY(!listOf(bench)->isVisible());
    QCOMPARE(bench.session.step().id, QString("two_feet"));
    QCOMPARE(bench.session.timeline().cursor().frame, 80);
    for (QAction *one : bench.window.findChildren<QAction *>()) { // the other is still there
        if (one->text() == "Reco&ver scenes…")
            one->trigger();
    }
    QVERIFY(listOf(bench)->isVisible());
    QCOMPARE(rows.topLevelItemCount(), 1);
    QVERIFY(rows.topLevelItem(0)->text(0).contains(bench.library.lesson("single_spring")->title));
}

void KeptScenesTest::aSceneKeepsTheTimeOfItsLastChangeThroughRestarts()
{
    const QTemporaryDir folder;
    const QDateTime when = QDateTime::fromString("2026-01-02T03:04:05", Qt::ISODate);
    {
        Bench bench;
        bench.session.setParameter("k", 0.3);
        leave(folder.path(), bench.session.experiment(), bench.library, when);
    }
    for (int restart = 0; restart < 2; ++restart) {
        Bench bench;
        bench.window.keepScenesIn(folder.path(), soon);
        QVERIFY(bench.answer("Open it"));
        QCOMPARE(scenesIn(folder.path()).size(), 1);
        QCOMPARE(QFileInfo(scenesIn(folder.path()).front()).lastModified(), when);
        QVERIFY(bench.window.close());
    }
    QCOMPARE(QFileInfo(scenesIn(folder.path()).front()).lastModified(), when);
    Bench bench;
    bench.window.keepScenesIn(folder.path(), soon);
    QVERIFY(bench.answer("Open it"));
    bench.session.setParameter("k", 0.4); // that is a change
    QTRY_VERIFY(QFileInfo(scenesIn(folder.path()).front()).lastModified() > when);
}

void KeptScenesTest::whatWasBuiltIsOfferedWhereBuildingBegins()
{
    const QTemporaryDir folder;
    Bench bench;
    bench.window.setMode(MainWindow::Mode::build);
    sim::Blueprint plan = *bench.session.blueprint();
    plan.points[1].mass = 7.0;
    QVERIFY(bench.session.build({"Change mass", {}, {}}, plan));
    leave(folder.path(), bench.session.experiment(), bench.library);
    Bench next;
    next.window.keepScenesIn(folder.path(), soon);
    next.press(Qt::Key_Escape, {}); // not now
    QTRY_VERIFY(!next.notice.isVisible());
    next.window.setMode(MainWindow::Mode::build);
    QVERIFY2(next.notice.sentence().contains(next.session.step().title), qPrintable(next.notice.sentence()));
    QVERIFY(next.answer("Open it"));
    QCOMPARE(next.session.blueprint()->points[1].mass, 7.0);
    QVERIFY(!next.notice.isVisible()); // it is not offered again while it is opened
}

void KeptScenesTest::aDamagedSceneIsRefusedWithASentence()
{
    const QTemporaryDir folder;
    Bench bench;
    leave(folder.path(), bench.session.experiment(), bench.library);
    QFile file(scenesIn(folder.path()).front());
    QVERIFY(file.resize(40));
    bench.window.keepScenesIn(folder.path(), soon);
    QVERIFY(bench.answer("Open it"));
    QVERIFY2(bench.notice.sentence().startsWith("Experiment not opened: "),
             qPrintable(bench.notice.sentence()));
    QVERIFY(file.exists());
}

void KeptScenesTest::aFolderThatCannotBeWrittenIsSaidOnce()
{
    const QTemporaryDir folder;
    QFile inTheWay(folder.filePath("a-file"));
    QVERIFY(inTheWay.open(QFile::WriteOnly));
    Bench bench;
    bench.window.keepScenesIn(inTheWay.fileName(), soon);
    bench.session.setParameter("k", 0.3);
    QTRY_VERIFY(bench.notice.isVisible());
    QVERIFY2(bench.notice.sentence().contains("is not kept"), qPrintable(bench.notice.sentence()));
    bench.press(Qt::Key_Escape, {});
    QTRY_VERIFY(!bench.notice.isVisible());
    bench.session.setParameter("k", 0.4);
    QTest::qWait(6 * soon);
    QVERIFY(!bench.notice.isVisible());
}

QTEST_MAIN(KeptScenesTest)
#include "tst_kept_scenes.moc"

// What is kept against a crash, and how it is offered at the next start.

#include "window_bench.h"

#include "app/model/scene_keeper.h"

#include <QDir>
#include <QDirIterator>
#include <QTemporaryDir>

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
void leave(const QString &folder, const Experiment &experiment, const LessonLibrary &library)
{
    const QString own = folder + "/of-another-program";
    QVERIFY(QDir().mkpath(own));
    writeExperiment(own + '/' + experiment.lesson + '.' + experiment.step + ".json", experiment, library);
    QFile lock(own + "/lock");
    QVERIFY(lock.open(QFile::WriteOnly));
    lock.write("999999999\nspringstep\n\n"); // no program has this number
}

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
    const sim::State end = bench.session.timeline().now();
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
    QCOMPARE(next.session.timeline().at().frame, 80);
    QVERIFY(sim::sameBits(next.session.timeline().now(), end));
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

// Ticks are kept while the program runs and after a restart.

#include "app/model/catalog/progress.h"
#include "tests/suite.h"

#include <QCoreApplication>
#include <QProcess>
#include <QSettings>
#include <QSignalSpy>
#include <QTemporaryDir>
#include <QTest>

using namespace app;

namespace {

constexpr const char *settingsFolder = "SPRINGSTEP_TEST_SETTINGS"; ///< of the program that ticked

}

class ProgressTest : public QObject
{
    Q_OBJECT

    QTemporaryDir m_own;

    /// Runs one test of this program in a process of its own, with the same settings. Returns its exit code.
    int inAnotherProcess(const char *test) const
    {
        QProcess process;
        QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
        environment.insert(settingsFolder, m_own.path());
        process.setProcessEnvironment(environment);
        process.start(QCoreApplication::applicationFilePath(), {"tst_progress", test});
        return process.waitForFinished() ? process.exitCode() : -1;
    }
    static bool isAnotherProcess() { return qEnvironmentVariableIsSet(settingsFolder); }

private slots:
    void initTestCase();
    void ticksSurviveARestart();
    void theNextStartSeesTheTicks();
    void theNextStartSeesNoTicks();
    void aLessonIsStartedOverAndItsTicksComeBack();
};

void ProgressTest::initTestCase()
{
    QSettings::setDefaultFormat(QSettings::IniFormat);
    const QString folder = isAnotherProcess() ? qEnvironmentVariable(settingsFolder) : m_own.path();
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder);
    QCoreApplication::setOrganizationName("springstep-tests");
    QCoreApplication::setApplicationName("progress");
}

void ProgressTest::ticksSurviveARestart()
{
    {
        Progress progress;
        progress.markDone("one", "first", 0);
        progress.markDone("one", "first", 2);
    }
    QCOMPARE(inAnotherProcess("theNextStartSeesTheTicks"), 0);
    QVERIFY(inAnotherProcess("theNextStartSeesNoTicks") > 0);
    Progress().forgetLesson("one");
    QCOMPARE(inAnotherProcess("theNextStartSeesNoTicks"), 0);
    QVERIFY(inAnotherProcess("theNextStartSeesTheTicks") > 0);
}

void ProgressTest::theNextStartSeesTheTicks()
{
    if (!isAnotherProcess())
        QSKIP("run by ticksSurviveARestart");
    const Progress progress;
    QVERIFY(progress.isDone("one", "first", 0));
    QVERIFY(!progress.isDone("one", "first", 1));
    QVERIFY(progress.isDone("one", "first", 2));
}

void ProgressTest::theNextStartSeesNoTicks()
{
    if (!isAnotherProcess())
        QSKIP("run by ticksSurviveARestart");
    QVERIFY(!Progress().isDone("one", "first", 0));
}

void ProgressTest::aLessonIsStartedOverAndItsTicksComeBack()
{
    Progress progress;
    progress.markDone("one", "first", 0);
    progress.markDone("one", "second", 1);
    progress.markDone("one_more", "first", 0);
    const QSignalSpy changed(&progress, &Progress::changed);
    const QStringList ticks = progress.forgetLesson("one");
    QCOMPARE(ticks.size(), 2);
    QCOMPARE(changed.size(), 1);
    QVERIFY(!progress.isDone("one", "first", 0) && !progress.isDone("one", "second", 1));
    QVERIFY(progress.isDone("one_more", "first", 0)); // though its name begins alike
    QVERIFY(!Progress().isDone("one", "first", 0));   // kept, too
    progress.giveBack(ticks);
    QVERIFY(progress.isDone("one", "first", 0) && progress.isDone("one", "second", 1));
    QVERIFY(Progress().isDone("one", "second", 1));
    QVERIFY(!progress.isDone("one", "second", 0));
}

SUITE(tst_progress, ProgressTest)
#include "tst_progress.moc"

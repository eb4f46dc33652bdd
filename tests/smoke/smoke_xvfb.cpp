// The program as a user starts it: a real window on a real X server, used with mouse and keys only. Everything is checked
// from outside: the title of the window, its pixels, the saved file, the exit code and what is printed. Nothing of the
// program's code is linked.

#include <QDir>
#include <QElapsedTimer>
#include <QFile>
#include <QGuiApplication>
#include <QImage>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QPixmap>
#include <QProcess>
#include <QScreen>
#include <QTemporaryDir>
#include <QTest>

namespace {

constexpr int furtherFrames = 5;
constexpr int mostMilliseconds = 30'000; ///< that the program may take for anything

/// Runs xdotool, which sends real input to the X server. Returns what it prints.
QString xdotool(const QStringList &arguments)
{
    QProcess process;
    process.start("xdotool", arguments);
    if (!process.waitForFinished(mostMilliseconds) || process.exitStatus() != QProcess::NormalExit)
        qFatal("xdotool does not run: is the package xdotool installed?");
    return QString::fromUtf8(process.readAllStandardOutput()).trimmed();
}

void key(const char *name)
{
    xdotool({"key", name});
}

void moveTo(QPoint at)
{
    xdotool({"mousemove", QString::number(at.x()), QString::number(at.y())});
}

QImage screenshot()
{
    return QGuiApplication::primaryScreen()->grabWindow(0).toImage().convertToFormat(QImage::Format_RGB32);
}

/// Returns the middle of the topmost dark square of `side` px in an area: the foot is a dark disc, and no letter is as
/// thick. Null if there is none.
QPoint darkSquareIn(const QImage &screen, const QRect &area, int side)
{
    const auto isDark = [&](int x, int y) { return qGray(screen.pixel(x, y)) < 90; };
    for (int y = area.top(); y + side < area.bottom(); ++y) {
        for (int x = area.left(); x + side < area.right(); ++x) {
            bool isWhole = true;
            for (int i = 0; i < side * side && isWhole; ++i)
                isWhole = isDark(x + i % side, y + i / side);
            if (isWhole)
                return {x + side / 2, y + side / 2};
        }
    }
    return {};
}

}

class SmokeTest : public QObject
{
    Q_OBJECT

    QTemporaryDir m_home;
    QProcess m_program;
    QString m_window; ///< the number that X has given it

    QString title() const { return xdotool({"getwindowname", m_window}); }
    /// Waits until the screen stays the same for 0.3 s, which is less than a caret takes to blink. Returns whether it does.
    static bool isStill()
    {
        QImage before = screenshot();
        QElapsedTimer same;
        same.start();
        return QTest::qWaitFor(
            [&] {
                const QImage now = screenshot();
                if (now != before)
                    same.start();
                before = now;
                return same.elapsed() >= 300;
            },
            mostMilliseconds);
    }
    /// Presses a key. Returns whether that changes the screen.
    static bool keyChangesScreen(const char *name)
    {
        const QImage before = screenshot();
        key(name);
        return QTest::qWaitFor([&] { return screenshot() != before; }, mostMilliseconds);
    }

private slots:
    void theProgramOpensItsWindow();
    void theTourIsClosedByAKey();
    void theMapThatFollowsIsClosedByAKey();
    void aKeyPlaysAndPauses();
    void theFootIsDraggedWithTheMouse();
    void aParameterIsTyped();
    void keysComputeFurtherFrames();
    void keysGoToTheNextStepAndBack();
    void theExperimentIsSaved();
    void theFileHasTheRun();
    void itEndsWithoutAnError();
    void theSavedRunIsComputedAgain();
    void cleanupTestCase();
};

void SmokeTest::theProgramOpensItsWindow()
{
    QProcessEnvironment environment = QProcessEnvironment::systemEnvironment();
    for (const char *name : {"QT_QPA_PLATFORM", "WAYLAND_DISPLAY", "XDG_CONFIG_HOME", "XDG_DATA_HOME"})
        environment.remove(name);
    QVERIFY(QDir(m_home.path()).mkdir("run"));
    QFile::setPermissions(m_home.filePath("run"),
                          QFileDevice::ReadOwner | QFileDevice::WriteOwner | QFileDevice::ExeOwner);
    environment.insert("HOME", m_home.path());
    environment.insert("XDG_RUNTIME_DIR", m_home.filePath("run"));
    environment.insert("SPRINGSTEP_LESSONS", LESSON_DIR);
    m_program.setProcessEnvironment(environment);
    m_program.start(PROGRAM, QStringList());
    QVERIFY(m_program.waitForStarted());
    QTRY_VERIFY_WITH_TIMEOUT(
        !(m_window = xdotool({"search", "--onlyvisible", "--class", "springstep"}).section('\n', 0, 0))
             .isEmpty(),
        mostMilliseconds);
    xdotool({"windowmove", "--sync", m_window, "0", "0"});
    xdotool({"windowsize", m_window, "1280", "800"});
    xdotool({"windowfocus", "--sync", m_window});
    QCOMPARE(title(), QString("Drag and throw – Springstep"));
    QVERIFY(isStill());
}

void SmokeTest::theTourIsClosedByAKey()
{
    QVERIFY(keyChangesScreen("Escape"));
    QVERIFY(isStill());
}

void SmokeTest::theMapThatFollowsIsClosedByAKey()
{
    QString map;
    QTRY_VERIFY_WITH_TIMEOUT(
        !(map = xdotool({"search", "--onlyvisible", "--name", "Map of concepts"}).section('\n', 0, 0))
             .isEmpty(),
        mostMilliseconds);
    xdotool({"windowfocus", "--sync", map});
    QVERIFY(isStill());
    QVERIFY(keyChangesScreen("Escape"));
    xdotool({"windowfocus", "--sync", m_window}); // there is no window manager that does it
    QVERIFY(isStill());
}

void SmokeTest::aKeyPlaysAndPauses()
{
    QVERIFY(keyChangesScreen("space")); // the button and the number of the frame
    QVERIFY(keyChangesScreen("space"));
    QVERIFY(isStill());
}

void SmokeTest::theFootIsDraggedWithTheMouse()
{
    const QRect scene(300, 90, 550, 480);
    const QPoint foot = darkSquareIn(screenshot(), scene, 12);
    QVERIFY(!foot.isNull());
    moveTo(foot);
    xdotool({"mousedown", "1"});
    for (int i = 1; i <= 4; ++i)
        moveTo(foot + QPoint(-20, 15) * i);
    const auto wayOff = [&] { return darkSquareIn(screenshot(), scene, 12) - foot - QPoint(-80, 60); };
    QTRY_VERIFY_WITH_TIMEOUT(wayOff().manhattanLength() <= 4, mostMilliseconds);
    QVERIFY(isStill()); // time runs until nothing moves: a foot that is held still is not thrown
    xdotool({"mouseup", "1"});
    QTRY_COMPARE_WITH_TIMEOUT(title(), QString("Drag and throw* – Springstep"), mostMilliseconds);
    QVERIFY(isStill());
    QVERIFY2(wayOff().manhattanLength() <= 4,
             qPrintable(QString("%1, %2 px off").arg(wayOff().x()).arg(wayOff().y())));
}

void SmokeTest::aParameterIsTyped()
{
    moveTo({1147, 743}); // the number of the only parameter, at the bottom right
    xdotool({"click", "1"});
    QVERIFY(isStill());
    key("ctrl+a");
    xdotool({"type", "0.75"});
    key("Return");
    QVERIFY(isStill());
}

void SmokeTest::keysComputeFurtherFrames()
{
    moveTo({580, 500}); // an empty place in the scene
    xdotool({"click", "1"});
    for (int i = 0; i < furtherFrames; ++i)
        QVERIFY(keyChangesScreen("Right"));
}

void SmokeTest::keysGoToTheNextStepAndBack()
{
    key("Next");
    QTRY_COMPARE_WITH_TIMEOUT(title(), QString("A fixed centre – Springstep"), mostMilliseconds);
    key("Prior");
    QTRY_COMPARE_WITH_TIMEOUT(title(), QString("Drag and throw* – Springstep"), mostMilliseconds);
}

void SmokeTest::theExperimentIsSaved()
{
    key("ctrl+s");
    QString dialog;
    QTRY_VERIFY_WITH_TIMEOUT(
        !(dialog = xdotool({"search", "--onlyvisible", "--name", "Save"}).section('\n', 0, 0)).isEmpty(),
        mostMilliseconds);
    xdotool({"windowfocus", "--sync", dialog});
    QVERIFY(isStill());
    key("ctrl+a");
    xdotool({"type", m_home.filePath("smoke.json")});
    key("Return");
    QTRY_VERIFY2_WITH_TIMEOUT(title().contains("smoke.json") && !title().contains('*'), qPrintable(title()),
                              mostMilliseconds);
    QVERIFY(QFile::exists(m_home.filePath("smoke.json")));
}

void SmokeTest::theFileHasTheRun()
{
    QFile file(m_home.filePath("smoke.json"));
    QVERIFY(file.open(QFile::ReadOnly));
    QJsonParseError error;
    const QJsonObject saved = QJsonDocument::fromJson(file.readAll(), &error).object();
    QCOMPARE(error.errorString(), QString("no error occurred"));
    QCOMPARE(saved["format"].toString(), QString("springstep-experiment/1"));
    QCOMPARE(saved["lesson"].toString(), QString("single_spring"));
    QCOMPARE(saved["step"].toString(), QString("drag"));
    QVERIFY(saved["frames"].toInt() >= furtherFrames);
    QStringList events;
    for (const QJsonValue &event : saved["input"].toArray()) {
        events << event["event"].toString();
        if (events.last() == "grab")
            QCOMPARE(event["body"].toString(), QString("foot"));
        if (events.last() == "set") {
            QCOMPARE(event["parameter"].toString(), QString("damp"));
            QCOMPARE(event["value"].toDouble(), 0.75);
        }
    }
    QCOMPARE(events.first(), QString("grab"));
    QVERIFY2(events.contains("move") && events.contains("release"), qPrintable(events.join(", ")));
    QCOMPARE(events.last(), QString("set"));
}

void SmokeTest::itEndsWithoutAnError()
{
    xdotool({"windowfocus", "--sync", m_window});
    key("ctrl+q");
    QVERIFY(m_program.waitForFinished(mostMilliseconds));
    QCOMPARE(m_program.exitStatus(), QProcess::NormalExit);
    QCOMPARE(QString::fromUtf8(m_program.readAllStandardError()), QString()); // says more than the code
    QCOMPARE(m_program.exitCode(), 0);
    QCOMPARE(QString::fromUtf8(m_program.readAllStandardOutput()), QString());
}

void SmokeTest::theSavedRunIsComputedAgain()
{
    QProcess trace;
    trace.start(PROGRAM, {"trace", m_home.filePath("smoke.json")});
    QVERIFY(trace.waitForFinished(mostMilliseconds));
    QCOMPARE(trace.exitCode(), 0);
    QVERIFY(trace.readAllStandardOutput().count('\n') > furtherFrames); // a line a frame, and the titles
}

void SmokeTest::cleanupTestCase()
{
    if (m_program.state() == QProcess::Running) { // after a failure
        m_program.kill();
        m_program.waitForFinished();
    }
}

QTEST_MAIN(SmokeTest)
#include "smoke_xvfb.moc"

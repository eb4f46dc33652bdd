// The window in its modes, and at rest: what it shows beside the scene, and that nothing runs in vain.

#include "app/ui/window/main_window.h"
#include "lessons/api/view/view.h"
#include "quick_bench.h"

#include <QDockWidget>
#include <QLabel>
#include <QSettings>
#include <QStatusBar>
#include <QTemporaryDir>
#include <QtTest>

using namespace app;
using quick_bench::Bench;

namespace {

/// Whether a second comes in which the application does nothing. What opening the window started comes to an end,
/// however slow the machine is, and so does a tip that an earlier test left open: Qt hides it by a timer of its own,
/// seconds later.
bool comesToRest()
{
    struct Counter : QObject
    {
        int timers = 0;
        int paints = 0;
        bool eventFilter(QObject *, QEvent *event) override
        {
            timers += event->type() == QEvent::Timer;
            paints += event->type() == QEvent::Paint;
            return false;
        }
    } counter;
    qApp->installEventFilter(&counter);
    const auto nothingForASecond = [&] {
        counter.timers = counter.paints = 0;
        QTest::qWait(1000);
        return counter.timers + counter.paints == 0;
    };
    bool isQuiet = false;
    for (int i = 0; i < 30 && !isQuiet; ++i)
        isQuiet = nothingForASecond();
    qApp->removeEventFilter(&counter);
    return isQuiet;
}

}

class WindowModesTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase();
    void nothingRunsWhilePaused();
    void nothingRunsWhileEverythingRests();
    void fullScreenIsLeftHoweverItCame();
    void theModesArrangeTheWindowAndBack_data();
    void theModesArrangeTheWindowAndBack();
    void theReferenceRunsAlongUntilTheSceneChanges();
    void guidesOfTheExactMotionGiveWayToTheReference();

private:
    QTemporaryDir m_folder;
};

void WindowModesTest::initTestCase()
{
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, m_folder.path());
}

void WindowModesTest::nothingRunsWhilePaused()
{
    Bench bench("gravity_walls", "gravity");
    bench.session.goTo({50, 0});
    QVERIFY(comesToRest());
}

void WindowModesTest::nothingRunsWhileEverythingRests()
{
    Bench bench("multi_foot", "any_number");
    bench.session.goTo({3000, 0});
    QTRY_VERIFY(!bench.session.goingTo());
    bench.session.play();
    QTRY_VERIFY_WITH_TIMEOUT(bench.session.isResting(), 60'000);
    QVERIFY(comesToRest());
    QVERIFY(bench.session.isResting());
    const auto labels = bench.window.statusBar()->findChildren<QLabel *>();
    QVERIFY(std::any_of(labels.begin(), labels.end(),
                        [](const QLabel *label) { return label->text().contains("Everything rests"); }));
}

void WindowModesTest::fullScreenIsLeftHoweverItCame()
{
    Bench bench;
    bench.window.showFullScreen(); // as the last start left it, or the desktop made it
    QTest::keyClick(&bench.view, Qt::Key_F11, Qt::ShiftModifier);
    QVERIFY(!bench.window.isFullScreen());
    QTest::keyClick(&bench.view, Qt::Key_F11, Qt::ShiftModifier);
    QVERIFY(bench.window.isFullScreen());
}

void WindowModesTest::theModesArrangeTheWindowAndBack_data()
{
    QTest::addColumn<int>("width");
    QTest::addColumn<bool>("lessonsStay");
    QTest::newRow("1280") << 1280 << false;
    QTest::newRow("1920") << 1920 << true;
}

void WindowModesTest::theModesArrangeTheWindowAndBack()
{
    QFETCH(int, width);
    QFETCH(bool, lessonsStay);
    Bench bench;
    bench.window.resize(width, 800);
    QCoreApplication::processEvents();
    const auto dock = [&](const char *name) { return bench.window.findChild<QDockWidget *>(name); };
    QVERIFY(!dock("accuracy")->isVisible());
    QVERIFY(!bench.window.study().isWatched());
    const QRect code = dock("code")->geometry();
    QTest::keyClick(&bench.view, Qt::Key_F6);
    QTRY_VERIFY(dock("accuracy")->isVisible());
    QVERIFY(bench.window.study().isWatched());
    QTRY_COMPARE(dock("lessons")->width() > 44, lessonsStay);        // else they are a rail
    QCOMPARE(!dock("code")->visibleRegion().isEmpty(), lessonsStay); // else a tab behind accuracy
    QVERIFY(dock("parameters")->isVisible());
    QVERIFY(bench.view.width() >= 480);
    QTRY_VERIFY(dock("accuracy")->width() >= 540);
    QTRY_COMPARE(bench.window.study().stage(), AccuracyStudy::Stage::done);
    QTest::keyClick(&bench.view, Qt::Key_F5);
    QTRY_VERIFY(!dock("accuracy")->isVisible());
    QVERIFY(!bench.window.study().isWatched());
    QVERIFY(dock("lessons")->isVisible() && dock("code")->isVisible() && dock("parameters")->isVisible());
    QTRY_COMPARE(dock("code")->geometry(), code);
}

void WindowModesTest::theReferenceRunsAlongUntilTheSceneChanges()
{
    Bench bench("multi_foot", "any_number");
    QVERIFY(!bench.view.shown().reference);
    bench.window.setMode(MainWindow::Mode::measure);
    QTRY_COMPARE(bench.window.study().stage(), AccuracyStudy::Stage::done);
    QVERIFY(bench.view.shown().reference);
    QCOMPARE(bench.view.shown().reference->distance, 5.0);
    QVERIFY(bench.view.accessibleDescription().contains(QString("5\u2009px off the reference here")));
    const QImage with = bench.view.picture();
    Extras extras = bench.view.extras();
    extras.reference = false;
    bench.view.setExtras(extras);
    QVERIFY(bench.view.picture() != with);
    extras.reference = true;
    bench.view.setExtras(extras);
    bench.session.setStepSize(0.5); // the scene is the same
    QVERIFY(bench.view.shown().reference);
    bench.session.setParameter("k", 0.31);
    QVERIFY(!bench.view.shown().reference);
    QTRY_VERIFY(bench.view.shown().reference);
    bench.session.goTo({1, 1}); // inside a frame there is nothing to compare with
    QVERIFY(!bench.view.shown().reference);
    bench.session.goTo({1, 0});
    bench.window.setMode(MainWindow::Mode::learn);
    QVERIFY(!bench.view.shown().reference);
}

void WindowModesTest::guidesOfTheExactMotionGiveWayToTheReference()
{
    Bench bench("accuracy", "halve");
    bench.session.goTo({12, 0});
    const auto marks = [&] {
        const std::vector<lessons::Overlay> &guides = bench.view.shown().picture.guides;
        return std::count_if(guides.begin(), guides.end(), [](const lessons::Overlay &guide) {
            return guide.about == lessons::Overlay::About::exactMotion;
        });
    };
    const auto all = marks();
    QVERIFY(all > 1);
    bench.window.setMode(MainWindow::Mode::measure);
    QTRY_VERIFY(bench.view.shown().reference);
    QCOMPARE(marks(), 0);
    Extras extras = bench.view.extras();
    extras.reference = false;
    bench.view.setExtras(extras);
    QCOMPARE(marks(), all);
    extras.reference = true;
    bench.view.setExtras(extras);
    bench.window.setMode(MainWindow::Mode::learn);
    QCOMPARE(marks(), all);
}

QTEST_MAIN(WindowModesTest)
#include "tst_window_modes.moc"

// The modes of the window and their panels. Also tests that nothing runs while the window is at rest.

#include "app/ui/window/main_window.h"
#include "lessons/api/view/view.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QDockWidget>
#include <QLabel>
#include <QStatusBar>
#include <QtTest>

using namespace app;
using namespace tests;

class WindowModesTest : public QObject
{
    Q_OBJECT

private slots:
    void nothingRunsWhilePaused();
    void nothingRunsWhileEverythingRests();
    void keyLeavesFullScreenHoweverItBegan();
    void theModesArrangeTheWindowAndBack_data();
    void theModesArrangeTheWindowAndBack();
    void theReferenceRunsAlongUntilTheSceneChanges();
    void guidesOfTheExactMotionGiveWayToTheReference();
};

void WindowModesTest::nothingRunsWhilePaused()
{
    WindowFixture fixture({"gravity_walls", "gravity"});
    fixture.goTo(50);
    QVERIFY(Activity().comesToRest());
}

void WindowModesTest::nothingRunsWhileEverythingRests()
{
    WindowFixture fixture({"multi_foot", "any_number"});
    fixture.session.playback().goTo({3000, 0});
    QTRY_VERIFY(!fixture.session.playback().goal());
    fixture.session.playback().play();
    QTRY_VERIFY_WITH_TIMEOUT(fixture.session.playback().isWaiting(), 60'000);
    QVERIFY(Activity().comesToRest());
    QVERIFY(fixture.session.playback().isWaiting());
    const auto labels = fixture.window.statusBar()->findChildren<QLabel *>();
    QVERIFY(std::any_of(labels.begin(), labels.end(),
                        [](const QLabel *label) { return label->text().contains("Everything is at rest"); }));
}

void WindowModesTest::keyLeavesFullScreenHoweverItBegan()
{
    WindowFixture fixture({.study = quickStudy});
    fixture.window.showFullScreen(); // as the last start left it, or the desktop made it
    QTest::keyClick(&fixture.view, Qt::Key_F11, Qt::ShiftModifier);
    QVERIFY(!fixture.window.isFullScreen());
    QTest::keyClick(&fixture.view, Qt::Key_F11, Qt::ShiftModifier);
    QVERIFY(fixture.window.isFullScreen());
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
    WindowFixture fixture({.size = {width, 800}, .study = quickStudy});
    QVERIFY(!fixture.dock("accuracy").isVisible());
    QVERIFY(!fixture.window.study().isActive());
    const QRect code = fixture.dock("code").geometry();
    QTest::keyClick(&fixture.view, Qt::Key_F6);
    QTRY_VERIFY(fixture.dock("accuracy").isVisible());
    QVERIFY(fixture.window.study().isActive());
    QTRY_COMPARE(fixture.dock("lessons").width() > 44, lessonsStay);        // else they are a rail
    QCOMPARE(!fixture.dock("code").visibleRegion().isEmpty(), lessonsStay); // else a tab behind accuracy
    QVERIFY(fixture.dock("parameters").isVisible());
    QVERIFY(fixture.view.width() >= 480);
    QTRY_VERIFY(fixture.dock("accuracy").width() >= 540);
    QTRY_COMPARE(fixture.window.study().stage(), AccuracyStudy::Stage::done);
    QTest::keyClick(&fixture.view, Qt::Key_F5);
    QTRY_VERIFY(!fixture.dock("accuracy").isVisible());
    QVERIFY(!fixture.window.study().isActive());
    QVERIFY(fixture.dock("lessons").isVisible() && fixture.dock("code").isVisible() &&
            fixture.dock("parameters").isVisible());
    QTRY_COMPARE(fixture.dock("code").geometry(), code);
}

void WindowModesTest::theReferenceRunsAlongUntilTheSceneChanges()
{
    WindowFixture fixture({.lesson = "multi_foot", .step = "any_number", .study = quickStudy});
    QVERIFY(!fixture.view.shown().reference);
    fixture.window.setMode(MainWindow::Mode::measure);
    QTRY_COMPARE(fixture.window.study().stage(), AccuracyStudy::Stage::done);
    QVERIFY(fixture.view.shown().reference);
    QCOMPARE(fixture.view.shown().reference->distance, 5.0);
    QVERIFY(fixture.view.accessibleDescription().contains(QString("5\u2009px off the reference here")));
    const QImage with = fixture.view.picture();
    Extras extras = fixture.view.extras();
    extras.reference = false;
    fixture.view.setExtras(extras);
    QVERIFY(fixture.view.picture() != with);
    extras.reference = true;
    fixture.view.setExtras(extras);
    fixture.session.editor().setStepSize(0.5); // the scene is the same
    QVERIFY(fixture.view.shown().reference);
    fixture.session.editor().setParameter("k", 0.31);
    QVERIFY(!fixture.view.shown().reference);
    QTRY_VERIFY(fixture.view.shown().reference);
    fixture.session.playback().goTo({1, 1}); // inside a frame there is nothing to compare with
    QVERIFY(!fixture.view.shown().reference);
    fixture.goTo(1);
    fixture.window.setMode(MainWindow::Mode::learn);
    QVERIFY(!fixture.view.shown().reference);
}

void WindowModesTest::guidesOfTheExactMotionGiveWayToTheReference()
{
    WindowFixture fixture({.lesson = "accuracy", .step = "halve", .study = quickStudy});
    fixture.goTo(12);
    const auto marks = [&] {
        const std::vector<lessons::Overlay> &overlays = fixture.view.shown().picture.overlays;
        return std::count_if(overlays.begin(), overlays.end(), [](const lessons::Overlay &overlay) {
            return overlay.about == lessons::Overlay::About::exactMotion;
        });
    };
    const auto all = marks();
    QVERIFY(all > 1);
    fixture.window.setMode(MainWindow::Mode::measure);
    QTRY_VERIFY(fixture.view.shown().reference);
    QCOMPARE(marks(), 0);
    Extras extras = fixture.view.extras();
    extras.reference = false;
    fixture.view.setExtras(extras);
    QCOMPARE(marks(), all);
    extras.reference = true;
    fixture.view.setExtras(extras);
    fixture.window.setMode(MainWindow::Mode::learn);
    QCOMPARE(marks(), all);
}

SUITE(tst_window_modes, WindowModesTest)
#include "tst_window_modes.moc"

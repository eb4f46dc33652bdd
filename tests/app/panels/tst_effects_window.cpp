// The ledger of effects and undo in the window, by keys and buttons.

#include "app/ui/effects/effect_list.h"
#include "app/ui/effects/effects_panel.h"
#include "app/ui/parameters/parameter_row.h"
#include "tests/app/model/effects_support.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QAction>
#include <QDockWidget>
#include <QTabBar>
#include <QToolButton>
#include <QtTest>

#include <atomic>
#include <thread>

using namespace app;
using namespace tests;

namespace {

struct EffectsWindowFixture : WindowFixture
{
    explicit EffectsWindowFixture(QSize size = {1280, 800})
        : WindowFixture(
              {.lesson = "legs", .step = "tied", .size = size, .library = effects_support::legLibrary()})
    {
    }
    EffectsPanel &panel() const { return part<EffectsPanel>(); }
    /// Returns whether the panel is visible: not hidden, and not behind another tab.
    bool isSeen() const { return panel().isVisible() && !panel().isCovered(); }
};

}

class EffectsWindowTest : public QObject
{
    Q_OBJECT

private slots:
    void keyShowsAndHidesThePanel()
    {
        EffectsWindowFixture fixture;
        QVERIFY(!fixture.panel().isVisible());
        QAction *effects = &fixture.action("showEffects");
        QCOMPARE(effects->shortcut(), QKeySequence("Ctrl+4"));
        QTest::keyClick(&fixture.window, Qt::Key_4, Qt::ControlModifier);
        QTRY_VERIFY(fixture.isSeen());
        QVERIFY(effects->isChecked());
        QVERIFY(fixture.window.width() <= 1280 && fixture.window.height() <= 800);
        QTest::keyClick(&fixture.window, Qt::Key_4, Qt::ControlModifier);
        QTRY_VERIFY(!fixture.panel().isVisible());
        QVERIFY(!effects->isChecked());
    }

    void panelMeasuresOnlyAfterTheAccuracyStudy()
    {
        std::atomic<bool> isStudying = false, mayEnd = false, haveOverlapped = false;
        std::atomic<int> costs = 0;
        const auto study = [&](const sim::Script &script, const sim::StudyPlan &plan,
                               const sim::StudyProgress &progress) {
            isStudying = true;
            const sim::Accuracy found = quickStudy(script, plan, progress);
            while (!mayEnd && progress(found, 0.5))
                std::this_thread::yield();
            isStudying = false;
            return found;
        };
        const auto cost = [&](const CostSubject &, const sim::ShouldContinue &,
                              const std::function<void(const sim::FrameCost &)> &) {
            haveOverlapped = haveOverlapped || isStudying;
            ++costs;
        };
        WindowFixture fixture({.lesson = "legs",
                               .step = "tied",
                               .size = {1920, 1100}, // room for both panels
                               .library = effects_support::legLibrary(),
                               .study = study,
                               .cost = cost});
        MainWindow &window = fixture.window;
        window.setMode(MainWindow::Mode::measure);
        QTRY_VERIFY(isStudying);
        window.docks().show(Panel::effects, true);
        QTRY_COMPARE(window.effects().ledger().costs().stage(), CostMonitor::Stage::measuring);
        const int costsBefore = costs;
        mayEnd = true;
        QTRY_VERIFY(costs > 0);
        QCOMPARE(costsBefore, 0);
        QVERIFY(!haveOverlapped);
    }

    /// Where there is no room for both below the picture, they are tabs.
    void panelIsATabBesideEnergy()
    {
        EffectsWindowFixture fixture;
        fixture.window.docks().show(Panel::energy, true);
        fixture.window.docks().show(Panel::effects, true);
        QTRY_VERIFY(fixture.isSeen());
        QVERIFY(fixture.window.width() <= 1280);
        const auto areTogether = [&] {
            const QList<QTabBar *> bars = fixture.window.findChildren<QTabBar *>();
            return std::any_of(bars.begin(), bars.end(), [](const QTabBar *bar) {
                return bar->isVisible() && bar->count() == 2 && bar->tabText(0) == "Energy" &&
                       bar->tabText(1) == "Effects";
            });
        };
        QTRY_VERIFY(areTogether());
    }

    void panelIsBelowAccuracyOrATabBesideIt_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("seen");
        QTest::newRow("1920 x 1080") << QSize(1920, 1080) << true;
        QTest::newRow("1280 x 800") << QSize(1280, 800) << false;
    }

    void panelIsBelowAccuracyOrATabBesideIt()
    {
        QFETCH(QSize, size);
        QFETCH(bool, seen);
        EffectsWindowFixture fixture(size);
        fixture.window.setMode(MainWindow::Mode::measure);
        QTRY_COMPARE(fixture.isSeen(), seen);
        QVERIFY(fixture.window.width() <= size.width());
        if (!seen) {
            QTest::keyClick(&fixture.window, Qt::Key_4, Qt::ControlModifier); // brings its tab to the front
            QTRY_VERIFY(fixture.isSeen());
            QVERIFY(fixture.action("showEffects").isChecked());
        }
        fixture.window.setMode(MainWindow::Mode::learn);
        QTRY_VERIFY(!fixture.panel().isVisible());
    }

    void aSwitchIsUndoneByKey()
    {
        EffectsWindowFixture fixture;
        QVERIFY(!fixture.action("undo").isEnabled());
        QVERIFY(!fixture.button("Undo")->isEnabled());
        QVERIFY(!fixture.button("Undo")->toolTip().isEmpty());
        fixture.session.editor().setEffect("body_spring", false);
        QCOMPARE(fixture.action("undo").text(), "&Undo: Spring off");
        QCOMPARE(fixture.button("Undo")->accessibleName(), "Undo: Spring off");
        QTest::keyClick(&fixture.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!fixture.session.editor().isOff("body_spring"));
        QVERIFY(!fixture.action("undo").isEnabled());
        QTest::keyClick(&fixture.window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(fixture.session.editor().isOff("body_spring"));
        QTest::mouseClick(fixture.button("Undo"), Qt::LeftButton);
        QVERIFY(!fixture.session.editor().isOff("body_spring"));
        QTest::mouseClick(fixture.button("Redo"), Qt::LeftButton);
        QVERIFY(fixture.session.editor().isOff("body_spring"));
    }

    void aSlidersDragIsOneEntry()
    {
        EffectsWindowFixture fixture;
        ParameterRow *row = nullptr;
        for (ParameterRow *one : fixture.window.findChildren<ParameterRow *>()) {
            if (one->parameter().id == "k")
                row = one;
        }
        QVERIFY(row);
        auto *slider = row->findChild<QSlider *>();
        const QPoint middle = slider->rect().center();
        QTest::mousePress(slider, Qt::LeftButton, {}, middle);
        for (int i = 1; i <= 5; ++i) {
            const QPoint at = middle + QPoint(4 * i, 0);
            QMouseEvent move(QEvent::MouseMove, at, slider->mapToGlobal(at), Qt::NoButton, Qt::LeftButton,
                             {});
            QCoreApplication::sendEvent(slider, &move);
        }
        QTest::mouseRelease(slider, Qt::LeftButton, {}, middle + QPoint(20, 0));
        QVERIFY(fixture.session.editor().parameter("k") != 0.2);
        QCOMPARE(fixture.session.editor().undoStack().count(), 1);
        fixture.session.editor().undo();
        QCOMPARE(fixture.session.editor().parameter("k"), 0.2);
    }
};

SUITE(tst_effects_window, EffectsWindowTest)
#include "tst_effects_window.moc"

// The ledger of effects and undo in the window, by keys and buttons.

#include "app/ui/effects/effect_list.h"
#include "app/ui/effects/effects_panel.h"
#include "app/ui/window/main_window.h"
#include "effects_bench.h"
#include "panels_bench.h"
#include "studies.h"

#include <QAction>
#include <QDockWidget>
#include <QTabBar>
#include <QToolButton>
#include <QtTest>

using namespace app;

namespace {

struct Bench
{
    explicit Bench(QSize size = {1280, 800})
    {
        world.session.openStep("legs", "tied");
        show(window, size);
    }
    QAction *action(const char *name) const { return window.findChild<QAction *>(name); }
    EffectsPanel &panel() const { return *window.findChild<EffectsPanel *>(); }
    /// Whether the learner sees it: not hidden, and no other tab over it.
    bool isSeen() const { return panel().isVisible() && !panel().isCovered(); }
    QToolButton *button(const QString &name) const
    {
        for (QToolButton *one : window.findChildren<QToolButton *>()) {
            if (one->accessibleName().startsWith(name))
                return one;
        }
        return nullptr;
    }

    World world{effects_bench::legLibrary()};
    MainWindow window{world.session, world.theme, noStudy, noCost};
};

}

class EffectsWindowTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }

    void itIsShownByItsKey()
    {
        Bench bench;
        QVERIFY(!bench.panel().isVisible());
        QAction *effects = bench.action("showEffects");
        QCOMPARE(effects->shortcut(), QKeySequence("Ctrl+4"));
        QTest::keyClick(&bench.window, Qt::Key_4, Qt::ControlModifier);
        QTRY_VERIFY(bench.isSeen());
        QVERIFY(effects->isChecked());
        QVERIFY(bench.window.width() <= 1280 && bench.window.height() <= 800);
        QTest::keyClick(&bench.window, Qt::Key_4, Qt::ControlModifier);
        QTRY_VERIFY(!bench.panel().isVisible());
        QVERIFY(!effects->isChecked());
    }

    /// Where there is no room for both below the picture, they are tabs.
    void besideEnergyItIsATab()
    {
        Bench bench;
        bench.window.showEnergy(true);
        bench.window.showEffects(true);
        QTRY_VERIFY(bench.isSeen());
        QVERIFY(bench.window.width() <= 1280);
        const auto areTogether = [&] {
            const QList<QTabBar *> bars = bench.window.findChildren<QTabBar *>();
            return std::any_of(bars.begin(), bars.end(), [](const QTabBar *bar) {
                return bar->isVisible() && bar->count() == 2 && bar->tabText(0) == "Energy" &&
                       bar->tabText(1) == "Effects";
            });
        };
        QTRY_VERIFY(areTogether());
    }

    void whereAccuracyIsMeasuredItIsBelowOrATab_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("seen");
        QTest::newRow("1920 x 1080") << QSize(1920, 1080) << true;
        QTest::newRow("1280 x 800") << QSize(1280, 800) << false;
    }

    void whereAccuracyIsMeasuredItIsBelowOrATab()
    {
        QFETCH(QSize, size);
        QFETCH(bool, seen);
        Bench bench(size);
        bench.window.setMode(MainWindow::Mode::measure);
        QTRY_COMPARE(bench.isSeen(), seen);
        QVERIFY(bench.window.width() <= size.width());
        if (!seen) {
            QTest::keyClick(&bench.window, Qt::Key_4, Qt::ControlModifier); // brings its tab to the front
            QTRY_VERIFY(bench.isSeen());
            QVERIFY(bench.action("showEffects")->isChecked());
        }
        bench.window.setMode(MainWindow::Mode::learn);
        QTRY_VERIFY(!bench.panel().isVisible());
    }

    void whatWasSwitchedComesBackByKey()
    {
        Bench bench;
        QVERIFY(!bench.action("undo")->isEnabled());
        QVERIFY(!bench.button("Undo")->isEnabled());
        QVERIFY(!bench.button("Undo")->toolTip().isEmpty());
        bench.world.session.setEffect("body_spring", false);
        QCOMPARE(bench.action("undo")->text(), "&Undo: Spring off");
        QCOMPARE(bench.button("Undo")->accessibleName(), "Undo: Spring off");
        QTest::keyClick(&bench.window, Qt::Key_Z, Qt::ControlModifier);
        QVERIFY(!bench.world.session.isOff("body_spring"));
        QVERIFY(!bench.action("undo")->isEnabled());
        QTest::keyClick(&bench.window, Qt::Key_Z, Qt::ControlModifier | Qt::ShiftModifier);
        QVERIFY(bench.world.session.isOff("body_spring"));
        QTest::mouseClick(bench.button("Undo"), Qt::LeftButton);
        QVERIFY(!bench.world.session.isOff("body_spring"));
        QTest::mouseClick(bench.button("Redo"), Qt::LeftButton);
        QVERIFY(bench.world.session.isOff("body_spring"));
    }

    void aSlidersDragIsOneEntry()
    {
        Bench bench;
        ParameterRow *row = nullptr;
        for (ParameterRow *one : bench.window.findChildren<ParameterRow *>()) {
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
        QVERIFY(bench.world.session.parameter("k") != 0.2);
        QCOMPARE(bench.world.session.deeds().count(), 1);
        bench.world.session.undo();
        QCOMPARE(bench.world.session.parameter("k"), 0.2);
    }
};

QTEST_MAIN(EffectsWindowTest)
#include "tst_effects_window.moc"

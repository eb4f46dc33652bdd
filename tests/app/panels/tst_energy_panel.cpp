// The ledger of energy and momentum in the window, driven as a learner drives it.

#include "app/ui/energy/energy_list.h"
#include "app/ui/window/main_window.h"
#include "tests/app/panels/energy_panel_support.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QAction>
#include <QTemporaryDir>
#include <QToolButton>

using namespace app;
using namespace energy_panel_support;

class EnergyPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void ledgerFollowsTheCursorForwardsAndBack()
    {
        EnergyFixture fixture;
        for (const std::int64_t frame : {0, 20, 5, 40, 39}) {
            fixture.goTo(frame);
            const sim::State &state = fixture.session.timeline().state();
            QVERIFY(std::abs(fixture.amount("springs") - springEnergy(state)) < 1e-9);
            QVERIFY(std::abs(fixture.amount("moving") - motionEnergy(state)) < 1e-9);
            const double is = fixture.amount("springs") + fixture.amount("moving");
            const double brought = fixture.amount("damping") + fixture.amount("drift");
            QVERIFY(std::abs(atStart + brought - is) < 1e-9);
        }
        QVERIFY(fixture.amount("damping") < -1.0);
    }

    /// A factor of 1 + k h^2 a frame: see the suite of the ledger itself.
    void theEnergyThatExplicitEulerAddsHasItsLine()
    {
        EnergyFixture fixture;
        fixture.session.editor().setParameter("damp", 1.0);
        fixture.session.editor().setMethod("explicit_euler");
        fixture.goTo(10);
        const double made = atStart * (std::pow(1.2, 10.0) - 1.0);
        QVERIFY(std::abs(fixture.amount("drift") - made) < 1e-9 * made);
        QCOMPARE(fixture.line("drift")->number, QString("+%1").arg(made, 0, 'f', 1));
        QVERIFY(!fixture.line("damping"));
        QCOMPARE(fixture.panel.lines().front().id, "drift");
        fixture.session.editor().setMethod("implicit_midpoint");
        fixture.goTo(10);
        QVERIFY(std::abs(fixture.amount("drift")) < 1e-6);
    }

    void dragDoesWork()
    {
        EnergyFixture fixture;
        fixture.goTo(10);
        QVERIFY(!fixture.line("hand"));
        const double before = springEnergy(fixture.session.timeline().state());
        const sim::Scene &scene = fixture.session.timeline().track().interval().scene;
        fixture.session.input().grab(QString::fromStdString(scene.names.front()));
        fixture.session.input().moveTo({370.0, 200.0});
        fixture.session.playback().frameForward();
        fixture.session.input().moveTo({370.0, 200.0});
        fixture.session.playback().frameForward();
        fixture.session.input().release();
        fixture.goTo(12);
        QVERIFY(fixture.line("hand"));
        const double held = 0.5 * 0.2 * 100.0 * 100.0;
        const sim::State end = fixture.session.timeline().track().stateAt(12);
        QVERIFY(std::abs(springEnergy(end) - held) < 1e-9);
        QVERIFY(fixture.amount("hand") > 0.5 * (held - before));
    }

    void undoCountsTheEnergyAgainFromTheUndoneFrame()
    {
        EnergyFixture fixture;
        fixture.goTo(10);
        const QString foot = fixture.session.selected();
        fixture.session.input().grab(foot);
        fixture.session.input().moveTo({370.0, 200.0});
        fixture.session.playback().frameForward();
        fixture.session.input().release();
        fixture.goTo(30);
        QVERIFY(fixture.line("hand"));
        fixture.session.editor().undo();
        fixture.goTo(30);
        QVERIFY(!fixture.line("hand"));
        QVERIFY(std::abs(fixture.amount("springs") - springEnergy(fixture.session.timeline().state())) <
                1e-9);
    }

    void hiddenPanelComputesNothing()
    {
        EnergyFixture fixture;
        fixture.goTo(10);
        fixture.panel.hide();
        fixture.session.playback().goTo({30, 0});
        QTRY_VERIFY(!fixture.session.playback().goal());
        settle();
        QCOMPARE(fixture.panel.series().last(), 10);
        fixture.session.editor().setParameter("k", 0.3);
        fixture.panel.show();
        fixture.goTo(40);
        QCOMPARE(fixture.panel.series().last(), 40);
    }

    void momentumHasATabOfItsOwn()
    {
        EnergyFixture fixture;
        fixture.goTo(3);
        const QList<QToolButton *> tabs = fixture.panel.findChildren<QToolButton *>("tab");
        QCOMPARE(tabs.size(), 2);
        for (QToolButton *tab : tabs)
            QVERIFY(!tab->toolTip().isEmpty() && (tab->focusPolicy() & Qt::TabFocus));
        QTest::mouseClick(tabs[1], Qt::LeftButton);
        QCOMPARE(fixture.panel.view(), EnergyView::momentum);
        const sim::Vec2 v = fixture.session.timeline().state().velocityOf(0);
        QVERIFY(std::abs(fixture.line("momentum")->amount - v.x) < 1e-9);
        QVERIFY(std::abs(fixture.line("momentum")->across - v.y) < 1e-9);
        QVERIFY(fixture.line("anchors")->amount < -1.0);
        QTest::keyClick(tabs[0], Qt::Key_Space);
        QCOMPARE(fixture.panel.view(), EnergyView::energy);
        QVERIFY(fixture.line("springs"));
    }

    void numbersOfEveryFrameAreSaved()
    {
        EnergyFixture fixture;
        fixture.goTo(30);
        const QTemporaryDir folder;
        for (const EnergyView view : {EnergyView::energy, EnergyView::momentum}) {
            fixture.panel.setView(view);
            QSignalSpy said(&fixture.panel.exports(), &PlotExport::messageRequested);
            fixture.panel.exports().saveNumbers(folder.filePath("a.csv"));
            QCOMPARE(said.size(), 1);
            const std::vector<std::map<QString, double>> rows = fixture.readTable(folder.filePath("a.csv"));
            QCOMPARE(rows.size(), std::size_t{31});
            for (const std::map<QString, double> &row : rows) {
                const sim::State at =
                    fixture.session.timeline().track().stateAt(static_cast<std::int64_t>(row.at("frame")));
                if (view == EnergyView::momentum) {
                    QVERIFY(std::abs(row.at("momentum_x") - at.velocityOf(0).x) < 1e-12);
                    QVERIFY(std::abs(row.at("momentum_y") - at.velocityOf(0).y) < 1e-12);
                    continue;
                }
                QVERIFY(std::abs(row.at("moving") - motionEnergy(at)) < 1e-9);
                QVERIFY(std::abs(row.at("springs") - springEnergy(at)) < 1e-9);
                const double brought = row.at("damping") + row.at("drift");
                QVERIFY(std::abs(atStart + brought - row.at("moving") - row.at("springs")) < 1e-9);
            }
        }
    }

    void withoutALedgerNoNumbersAreExported()
    {
        EnergyFixture fixture;
        fixture.session.openStep("one", "puppet");
        const QTemporaryDir folder;
        QSignalSpy failed(&fixture.panel.exports(), &PlotExport::failed);
        fixture.panel.exports().saveNumbers(folder.filePath("a.csv"));
        QCOMPARE(failed.size(), 1);
        QVERIFY(!QFile::exists(folder.filePath("a.csv")));
    }

    void aSceneWithoutInertiaSaysWhyThereIsNoLedger()
    {
        EnergyFixture fixture;
        QVERIFY(fixture.panel.reason().isEmpty());
        fixture.session.openStep("one", "puppet");
        QVERIFY2(fixture.panel.reason().contains("the energy cannot be counted"),
                 qPrintable(fixture.panel.reason()));
        fixture.session.openStep("one", "second");
        QVERIFY(fixture.panel.reason().isEmpty());
        QVERIFY(fixture.line("springs"));
    }

    void aScreenReaderHearsEachLineWithItsUnit()
    {
        EnergyFixture fixture;
        fixture.goTo(10);
        auto *list = fixture.panel.findChild<EnergyList *>();
        QVERIFY(!list->accessibleName().isEmpty());
        QVERIFY(!fixture.panel.plot().accessibleName().isEmpty());
        for (int row = 0; row < list->model()->rowCount(); ++row) {
            const QModelIndex index = list->model()->index(row, 0);
            const QString said = index.data(Qt::AccessibleTextRole).toString();
            QVERIFY2(said.contains(fixture.panel.lines()[std::size_t(row)].number), qPrintable(said));
            QVERIFY2(said.endsWith("mass × px²/frame²"), qPrintable(said));
            QVERIFY(!index.data(Qt::ToolTipRole).toString().isEmpty());
        }
        list->setFocus();
        list->setCurrentIndex(list->model()->index(0, 0));
        QTest::keyClick(list, Qt::Key_Down);
        QCOMPARE(list->currentIndex().row(), 1);
    }

    void theWindowShowsItByKeyAndWhereMeasureHasRoom()
    {
        WindowFixture fixture(
            {.lesson = "one", .step = "first", .size = {1280, 800}, .library = twoLessons()});
        MainWindow &window = fixture.window;
        auto *energy = window.findChild<EnergyPanel *>();
        QVERIFY(!energy->isVisible());
        auto *action = window.findChild<QAction *>("showEnergy");
        QCOMPARE(action->shortcut(), QKeySequence("Ctrl+3"));
        action->trigger();
        QVERIFY(energy->isVisible());
        action->trigger();
        QVERIFY(!energy->isVisible());
        window.setMode(MainWindow::Mode::measure);
        QVERIFY(energy->visibleRegion().isEmpty()); // a tab behind accuracy
        QTest::keyClick(&window, Qt::Key_3, Qt::ControlModifier);
        QTRY_VERIFY(!energy->visibleRegion().isEmpty());
        window.setMode(MainWindow::Mode::learn);
        window.resize(1920, 1080);
        window.setMode(MainWindow::Mode::measure);
        QVERIFY(energy->isVisible());
        QVERIFY(action->isChecked());
        window.setMode(MainWindow::Mode::learn);
        QVERIFY(!energy->isVisible());
    }
};

SUITE(tst_energy_panel, EnergyPanelTest)
#include "tst_energy_panel.moc"

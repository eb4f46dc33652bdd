// The ledger of energy and momentum in the window, driven as a learner drives it.

#include "app/ui/energy/energy_list.h"
#include "app/ui/window/main_window.h"
#include "energy_panel_bench.h"

#include <QAction>
#include <QTemporaryDir>
#include <QToolButton>

using namespace app;
using namespace energy_panel_bench;

class EnergyPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }

    void theLedgerFollowsTheCursorThereAndBack()
    {
        Bench bench;
        for (const std::int64_t frame : {0, 20, 5, 40, 39}) {
            bench.goTo(frame);
            const sim::State &state = bench.session().timeline().state();
            QVERIFY(std::abs(bench.amount("springs") - springEnergy(state)) < 1e-9);
            QVERIFY(std::abs(bench.amount("moving") - motionEnergy(state)) < 1e-9);
            const double is = bench.amount("springs") + bench.amount("moving");
            const double brought = bench.amount("damping") + bench.amount("drift");
            QVERIFY(std::abs(atStart + brought - is) < 1e-9);
        }
        QVERIFY(bench.amount("damping") < -1.0);
    }

    /// A factor of 1 + k h^2 a frame: see the suite of the ledger itself.
    void whatExplicitEulerMakesIsSaidInItsLine()
    {
        Bench bench;
        bench.session().setParameter("damp", 1.0);
        bench.session().setMethod("explicit_euler");
        bench.goTo(10);
        const double made = atStart * (std::pow(1.2, 10.0) - 1.0);
        QVERIFY(std::abs(bench.amount("drift") - made) < 1e-9 * made);
        QCOMPARE(bench.line("drift")->number, QString("+%1").arg(made, 0, 'f', 1));
        QVERIFY(!bench.line("damping"));
        QCOMPARE(bench.panel.lines().front().id, "drift");
        bench.session().setMethod("implicit_midpoint");
        bench.goTo(10);
        QVERIFY(std::abs(bench.amount("drift")) < 1e-6);
    }

    void aHandThatPullsDoesWork()
    {
        Bench bench;
        bench.goTo(10);
        QVERIFY(!bench.line("hand"));
        const double before = springEnergy(bench.session().timeline().state());
        const sim::Scene &scene = bench.session().timeline().track().interval().scene;
        bench.session().grab(QString::fromStdString(scene.names.front()));
        bench.session().moveHand({370.0, 200.0});
        bench.session().frameForward();
        bench.session().moveHand({370.0, 200.0});
        bench.session().frameForward();
        bench.session().letGo();
        bench.goTo(12);
        QVERIFY(bench.line("hand"));
        const double held = 0.5 * 0.2 * 100.0 * 100.0;
        const sim::State end = bench.session().timeline().track().stateAt(12);
        QVERIFY(std::abs(springEnergy(end) - held) < 1e-9);
        QVERIFY(bench.amount("hand") > 0.5 * (held - before));
    }

    void whatIsUndoneIsCountedAnewFromWhereItWas()
    {
        Bench bench;
        bench.goTo(10);
        const QString foot = bench.session().selected();
        bench.session().grab(foot);
        bench.session().moveHand({370.0, 200.0});
        bench.session().frameForward();
        bench.session().letGo();
        bench.goTo(30);
        QVERIFY(bench.line("hand"));
        bench.session().undo();
        bench.goTo(30);
        QVERIFY(!bench.line("hand"));
        QVERIFY(std::abs(bench.amount("springs") - springEnergy(bench.session().timeline().state())) < 1e-9);
    }

    void nothingIsCountedWhileNobodyLooks()
    {
        Bench bench;
        bench.goTo(10);
        bench.panel.hide();
        bench.session().goTo({30, 0});
        QTest::qWait(50);
        QCOMPARE(bench.panel.course().last(), 10);
        bench.session().setParameter("k", 0.3);
        bench.panel.show();
        bench.goTo(40);
        QCOMPARE(bench.panel.course().last(), 40);
    }

    void momentumHasATabOfItsOwn()
    {
        Bench bench;
        bench.goTo(3);
        const QList<QToolButton *> tabs = bench.panel.findChildren<QToolButton *>("tab");
        QCOMPARE(tabs.size(), 2);
        for (QToolButton *tab : tabs)
            QVERIFY(!tab->toolTip().isEmpty() && (tab->focusPolicy() & Qt::TabFocus));
        QTest::mouseClick(tabs[1], Qt::LeftButton);
        QCOMPARE(bench.panel.view(), EnergyPanel::momentum);
        const sim::Vec2 v = bench.session().timeline().state().velocityOf(0);
        QVERIFY(std::abs(bench.line("momentum")->amount - v.x) < 1e-9);
        QVERIFY(std::abs(bench.line("momentum")->across - v.y) < 1e-9);
        QVERIFY(bench.line("anchors")->amount < -1.0);
        QTest::keyClick(tabs[0], Qt::Key_Space);
        QCOMPARE(bench.panel.view(), EnergyPanel::energy);
        QVERIFY(bench.line("springs"));
    }

    void numbersOfEveryFrameAreSaved()
    {
        Bench bench;
        bench.goTo(30);
        const QTemporaryDir folder;
        for (const EnergyPanel::View view : {EnergyPanel::energy, EnergyPanel::momentum}) {
            bench.panel.setView(view);
            QSignalSpy said(&bench.panel.exports(), &PlotExport::said);
            bench.panel.exports().saveNumbers(folder.filePath("a.csv"));
            QCOMPARE(said.size(), 1);
            const std::vector<std::map<QString, double>> rows = bench.readTable(folder.filePath("a.csv"));
            QCOMPARE(rows.size(), std::size_t{31});
            for (const std::map<QString, double> &row : rows) {
                const sim::State at =
                    bench.session().timeline().track().stateAt(static_cast<std::int64_t>(row.at("frame")));
                if (view == EnergyPanel::momentum) {
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

    void whereNothingIsCountedThereAreNoNumbers()
    {
        Bench bench;
        bench.session().openStep("one", "puppet");
        const QTemporaryDir folder;
        QSignalSpy failed(&bench.panel.exports(), &PlotExport::failed);
        bench.panel.exports().saveNumbers(folder.filePath("a.csv"));
        QCOMPARE(failed.size(), 1);
        QVERIFY(!QFile::exists(folder.filePath("a.csv")));
    }

    void whatHasNoInertiaSaysWhyThereIsNoLedger()
    {
        Bench bench;
        QVERIFY(bench.panel.reason().isEmpty());
        bench.session().openStep("one", "puppet");
        QVERIFY2(bench.panel.reason().contains("no energy to count"), qPrintable(bench.panel.reason()));
        bench.session().openStep("one", "second");
        QVERIFY(bench.panel.reason().isEmpty());
        QVERIFY(bench.line("springs"));
    }

    void aScreenReaderHearsEachLineWithItsUnit()
    {
        Bench bench;
        bench.goTo(10);
        auto *list = bench.panel.findChild<EnergyList *>();
        QVERIFY(!list->accessibleName().isEmpty());
        QVERIFY(!bench.panel.plot().accessibleName().isEmpty());
        for (int row = 0; row < list->model()->rowCount(); ++row) {
            const QModelIndex index = list->model()->index(row, 0);
            const QString said = index.data(Qt::AccessibleTextRole).toString();
            QVERIFY2(said.contains(bench.panel.lines()[std::size_t(row)].number), qPrintable(said));
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
        World world;
        MainWindow window(world.session, world.theme,
                          [](const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &) {
                              return sim::Accuracy{};
                          });
        show(window, {1280, 800});
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

QTEST_MAIN(EnergyPanelTest)
#include "tst_energy_panel.moc"

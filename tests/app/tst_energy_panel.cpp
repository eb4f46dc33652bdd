// The ledger of energy and momentum in the window, driven as a learner drives it.

#include "app/ui/energy/energy_list.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/energy/energy_plot.h"
#include "app/ui/window/main_window.h"
#include "panels_bench.h"

#include <QAction>
#include <QToolButton>
#include <QtTest>

using namespace app;

namespace {

/// The lessons of the other suites, and one whose foot has no velocity of its own.
LessonLibrary withPuppet()
{
    LessonLibrary library = twoLessons();
    lessons::Step puppet = library.lessons.front().steps.front();
    puppet.id = "puppet";
    puppet.tries.clear();
    puppet.method = "semi_implicit_euler";
    puppet.scene = [build = puppet.scene](const sim::Values &values) {
        sim::Scene scene = build(values);
        for (sim::Group &group : scene.groups)
            group.inertia = sim::Inertia::none;
        return scene;
    };
    library.lessons.front().steps.push_back(puppet);
    return library;
}

/// A foot that starts at rest, 30 px to the right of and 10 px below the place to which a spring with k = 0.2 pulls it;
/// the body stands.
struct Bench
{
    Bench()
    {
        session().openStep("one", "second");
        show(panel, {660, 300});
    }
    Session &session() { return world.session; }
    void goTo(std::int64_t frame)
    {
        session().goTo({frame, 0});
        QVERIFY(QTest::qWaitFor([&] { return panel.course().last() >= frame; }));
    }
    const EnergyLine *line(const QString &id) const
    {
        for (const EnergyLine &one : panel.lines()) {
            if (one.id == id)
                return &one;
        }
        return nullptr;
    }
    /// What has never had anything in it has no line.
    double amount(const QString &id) const { return line(id) ? line(id)->amount : 0.0; }

    World world{withPuppet()};
    EnergyPanel panel{world.session, world.theme};
};

constexpr double atStart = 0.5 * 0.2 * (30.0 * 30.0 + 10.0 * 10.0);

double springEnergy(const sim::State &state)
{
    const sim::Vec2 d = state.at(0) - sim::Vec2{270.0, 200.0};
    return 0.5 * 0.2 * (d.x * d.x + d.y * d.y);
}

double motionEnergy(const sim::State &state)
{
    double sum = 0.0;
    for (int i = 0; i < state.points(); ++i)
        sum += 0.5 * (state.speed(i).x * state.speed(i).x + state.speed(i).y * state.speed(i).y);
    return sum;
}

}

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
            const sim::State &state = bench.session().timeline().now();
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
        const double before = springEnergy(bench.session().timeline().now());
        const sim::Scene &scene = bench.session().timeline().track().shown().scene;
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
        QVERIFY(std::abs(bench.amount("springs") - springEnergy(bench.session().timeline().now())) < 1e-9);
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
        const sim::Vec2 v = bench.session().timeline().now().speed(0);
        QVERIFY(std::abs(bench.line("momentum")->amount - v.x) < 1e-9);
        QVERIFY(std::abs(bench.line("momentum")->across - v.y) < 1e-9);
        QVERIFY(bench.line("anchors")->amount < -1.0);
        QTest::keyClick(tabs[0], Qt::Key_Space);
        QCOMPARE(bench.panel.view(), EnergyPanel::energy);
        QVERIFY(bench.line("springs"));
    }

    void aPressOnThePlotGoesToItsFrame()
    {
        Bench bench;
        bench.goTo(100);
        QTest::qWait(0);
        EnergyPlot &plot = bench.panel.plot();
        const int x = qRound(plot.xAxis->coordToPixel(25.0));
        QTest::mouseClick(&plot, Qt::LeftButton, {}, {x, plot.height() / 2});
        QTRY_VERIFY(std::abs(bench.session().timeline().at().frame - 25) <= 1);
        const double is = bench.amount("springs") + bench.amount("moving");
        QVERIFY(std::abs(atStart + bench.amount("damping") + bench.amount("drift") - is) < 1e-9);
    }

    void thePileEndsWhereItShouldButForTheDrift()
    {
        Bench bench;
        bench.goTo(50);
        for (const std::int64_t frame : {0, 7, 50}) {
            const sim::Balance &balance = *bench.panel.course().at(frame);
            const EnergyPlot::Pile pile = EnergyPlot::pileOf(balance, -3.0);
            QVERIFY(std::abs(pile.tops[4] - pile.given - balance.energy[sim::Account::drift]) < 1e-9);
            QVERIFY(std::abs(pile.given - atStart - 3.0) < 1e-9);
            QVERIFY(std::is_sorted(pile.tops.begin(), pile.tops.end()));
        }
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
        QVERIFY(!energy->isVisible());
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

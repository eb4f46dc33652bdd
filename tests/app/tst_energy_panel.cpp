// The ledger of energy and momentum in the window, driven as a learner drives it.

#include "app/ui/energy/energy_list.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/energy/energy_plot.h"
#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/window/main_window.h"
#include "panels_bench.h"

#include <QAccessible>
#include <QAction>
#include <QTemporaryDir>
#include <QToolButton>
#include <QtTest>

#include <map>

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
    std::int64_t frame() { return session().timeline().at().frame; }
    QPoint placeOf(std::int64_t frame)
    {
        EnergyPlot &plot = panel.plot();
        return {qRound(plot.xAxis->coordToPixel(static_cast<double>(frame))), plot.height() / 2};
    }
    void hover(QPoint place, Qt::MouseButtons buttons = {})
    {
        EnergyPlot &plot = panel.plot();
        QMouseEvent move(QEvent::MouseMove, place, plot.mapToGlobal(place), Qt::NoButton, buttons, {});
        QApplication::sendEvent(&plot, &move);
    }
    /// The rows of a table, by the names of its columns without their units.
    static std::vector<std::map<QString, double>> readTable(const QString &path)
    {
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            return {};
        const QStringList lines = QString::fromUtf8(file.readAll()).trimmed().split('\n');
        QStringList titles;
        for (const QString &field : lines.front().split(','))
            titles << field.section('"', 1, 1).section(" [", 0, 0);
        std::vector<std::map<QString, double>> rows;
        for (const QString &line : lines.mid(1)) {
            const QStringList fields = line.split(',');
            rows.emplace_back();
            for (int i = 0; i < titles.size() && i < fields.size(); ++i)
                rows.back()[titles[i]] = fields[i].toDouble();
        }
        return rows;
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

    void aDragGoesOnAndStopsPlaying()
    {
        Bench bench;
        bench.goTo(100);
        bench.session().play();
        QTest::mousePress(&bench.panel.plot(), Qt::LeftButton, {}, bench.placeOf(25));
        QVERIFY(!bench.session().isPlaying());
        QVERIFY(std::abs(bench.frame() - 25) <= 1);
        bench.hover(bench.placeOf(60), Qt::LeftButton);
        QVERIFY(std::abs(bench.frame() - 60) <= 1);
        QVERIFY(!bench.panel.plot().hovered());
        QTest::mouseRelease(&bench.panel.plot(), Qt::LeftButton, {}, bench.placeOf(60));
        bench.hover(bench.placeOf(10));
        QVERIFY(std::abs(bench.frame() - 60) <= 1); // let go
    }

    void whereTheMousePointsIsTheSecondCursorWithItsNumbers()
    {
        Bench bench;
        bench.goTo(80);
        EnergyPlot &plot = bench.panel.plot();
        const QImage before = plot.grab().toImage();
        bench.hover(bench.placeOf(20));
        QCOMPARE(plot.hovered(), 20);
        QCOMPARE(bench.frame(), 80);
        QVERIFY(plot.grab().toImage() != before);
        const sim::State there = bench.session().timeline().track().stateAt(20);
        const QString is = QString::number(springEnergy(there) + motionEnergy(there), 'f', 1);
        QVERIFY2(plot.readout(20).startsWith(is), qPrintable(plot.readout(20) + " is not " + is));
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&plot, &leave);
        QVERIFY(!plot.hovered());
        QVERIFY(plot.grab().toImage() == before);
    }

    void arrowsOnThePlotMoveAFrameAndWithShiftAPhase()
    {
        Bench bench;
        bench.goTo(40);
        EnergyPlot &plot = bench.panel.plot();
        QVERIFY(plot.focusPolicy() & Qt::TabFocus);
        plot.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&plot, Qt::Key_Left);
        QCOMPARE(bench.frame(), 39);
        QTest::keyClick(&plot, Qt::Key_Right);
        QTest::keyClick(&plot, Qt::Key_Right);
        QCOMPARE(bench.frame(), 41);
        QTest::keyClick(&plot, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(bench.session().timeline().at().phase, 1);
        QTest::keyClick(&plot, Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(bench.session().timeline().at().phase, 0);
    }

    void aScreenReaderHearsWhatThePlotShowsAtTheCursor()
    {
        Bench bench;
        bench.goTo(12);
        QAccessibleInterface *access = QAccessible::queryAccessibleInterface(&bench.panel.plot());
        QCOMPARE(access->role(), QAccessible::Chart);
        QCOMPARE(access->text(QAccessible::Name), QString("Energy over the last frames"));
        const QString said = access->text(QAccessible::Value);
        QVERIFY2(said.contains(bench.panel.plot().readout(12)) && said.endsWith("frame 12"),
                 qPrintable(said));
        bench.panel.setView(EnergyPanel::momentum);
        const QString momentum = access->text(QAccessible::Value);
        QVERIFY2(momentum.contains("to the right"), qPrintable(momentum));
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
                    QVERIFY(std::abs(row.at("momentum_x") - at.speed(0).x) < 1e-12);
                    QVERIFY(std::abs(row.at("momentum_y") - at.speed(0).y) < 1e-12);
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

    void theWindowMarksWhereTheMouseIsInAllPlotsAndOnTheTimeline()
    {
        World world;
        MainWindow window(world.session, world.theme,
                          [](const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &) {
                              return sim::Accuracy{};
                          });
        show(window, {1920, 1080});
        window.showEnergy(true);
        world.session.goTo({60, 0});
        auto &energy = *window.findChild<EnergyPanel *>();
        QTRY_VERIFY(energy.course().last() >= 60 && window.plots().isSettled());
        EnergyPlot &plot = energy.plot();
        auto &timeline = *window.findChild<TimelineStrip *>();
        QuantityPlot &quantity = window.plots().cards().front()->plot();
        const auto hover = [](QWidget &widget, QPoint place) {
            QMouseEvent move(QEvent::MouseMove, place, widget.mapToGlobal(place), Qt::NoButton, {}, {});
            QApplication::sendEvent(&widget, &move);
        };
        hover(plot, {qRound(plot.xAxis->coordToPixel(20.0)), plot.height() / 2});
        QCOMPARE(plot.hovered(), 20);
        QCOMPARE(quantity.hovered(), 20);
        QCOMPARE(timeline.pointed(), 20);
        hover(quantity, {qRound(quantity.xAxis->coordToPixel(33.0)), quantity.height() / 2});
        QCOMPARE(plot.hovered(), 33);
        QCOMPARE(timeline.pointed(), 33);
        hover(timeline, {qRound(timeline.axis().xOf(41)), 25});
        QCOMPARE(plot.hovered(), timeline.axis().frameAt(qRound(timeline.axis().xOf(41))));
        QCOMPARE(quantity.hovered(), plot.hovered());
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&timeline, &leave);
        QVERIFY(!plot.hovered() && !quantity.hovered() && !timeline.pointed());
        hover(plot, {qRound(plot.xAxis->coordToPixel(20.0)), plot.height() / 2});
        QVERIFY(timeline.pointed());
        QCOMPARE(world.session.timeline().at().frame, 60); // nothing of this has moved time
        world.session.openStep("one", "second");           // its frames are others
        QVERIFY(!timeline.pointed() && !plot.hovered());
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

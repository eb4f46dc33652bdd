// The plot of the ledger: its cursors, hands on it, and how high its pile is.

#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/window/main_window.h"
#include "energy_panel_bench.h"

#include <QAccessible>

using namespace app;
using namespace energy_panel_bench;

class EnergyPlotTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }

    void aPressOnThePlotGoesToItsFrame()
    {
        Bench bench;
        bench.goTo(100);
        QTest::qWait(0);
        EnergyPlot &plot = bench.panel.plot();
        const int x = qRound(plot.xAxis->coordToPixel(25.0));
        QTest::mouseClick(&plot, Qt::LeftButton, {}, {x, plot.height() / 2});
        QTRY_VERIFY(std::abs(bench.session().timeline().cursor().frame - 25) <= 1);
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
        QCOMPARE(bench.session().timeline().cursor().phase, 1);
        QTest::keyClick(&plot, Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(bench.session().timeline().cursor().phase, 0);
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
        QCOMPARE(world.session.timeline().cursor().frame, 60); // nothing of this has moved time
        world.session.openStep("one", "second");               // its frames are others
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
};

QTEST_MAIN(EnergyPlotTest)
#include "tst_energy_plot.moc"

// The plot of energy: its cursors, the mouse on it, and the height of its areas.

#include "app/ui/plots/plot_card.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/window/main_window.h"
#include "tests/app/panels/energy_panel_support.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QAccessible>

using namespace app;
using namespace energy_panel_support;

class EnergyPlotTest : public QObject
{
    Q_OBJECT

private slots:
    void aPressOnThePlotGoesToItsFrame()
    {
        EnergyFixture fixture;
        fixture.goTo(100);
        settle();
        EnergyPlot &plot = fixture.panel.plot();
        const int x = qRound(plot.xAxis->coordToPixel(25.0));
        QTest::mouseClick(&plot, Qt::LeftButton, {}, {x, plot.height() / 2});
        QTRY_VERIFY(std::abs(fixture.session.timeline().cursor().frame - 25) <= 1);
        const double is = fixture.amount("springs") + fixture.amount("moving");
        QVERIFY(std::abs(atStart + fixture.amount("damping") + fixture.amount("drift") - is) < 1e-9);
    }

    void aDragGoesOnAndStopsPlaying()
    {
        EnergyFixture fixture;
        fixture.goTo(100);
        fixture.session.playback().play();
        QTest::mousePress(&fixture.panel.plot(), Qt::LeftButton, {}, fixture.placeOf(25));
        QVERIFY(!fixture.session.playback().isPlaying());
        QVERIFY(std::abs(fixture.frame() - 25) <= 1);
        fixture.hover(fixture.placeOf(60), Qt::LeftButton);
        QVERIFY(std::abs(fixture.frame() - 60) <= 1);
        QVERIFY(!fixture.panel.plot().hovered());
        QTest::mouseRelease(&fixture.panel.plot(), Qt::LeftButton, {}, fixture.placeOf(60));
        fixture.hover(fixture.placeOf(10));
        QVERIFY(std::abs(fixture.frame() - 60) <= 1); // let go
    }

    void hoveringShowsTheNumbersOfAFrame()
    {
        EnergyFixture fixture;
        fixture.goTo(80);
        EnergyPlot &plot = fixture.panel.plot();
        const QImage before = plot.grab().toImage();
        fixture.hover(fixture.placeOf(20));
        QCOMPARE(plot.hovered(), 20);
        QCOMPARE(fixture.frame(), 80);
        QVERIFY(plot.grab().toImage() != before);
        const sim::State there = fixture.session.timeline().track().stateAt(20);
        const QString is = QString::number(springEnergy(there) + motionEnergy(there), 'f', 1);
        QVERIFY2(plot.readout(20).startsWith(is), qPrintable(plot.readout(20) + " is not " + is));
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&plot, &leave);
        QVERIFY(!plot.hovered());
        QVERIFY(plot.grab().toImage() == before);
    }

    void arrowsOnThePlotMoveAFrameAndWithShiftAPhase()
    {
        EnergyFixture fixture;
        fixture.goTo(40);
        EnergyPlot &plot = fixture.panel.plot();
        QVERIFY(plot.focusPolicy() & Qt::TabFocus);
        plot.setFocus(Qt::TabFocusReason);
        QTest::keyClick(&plot, Qt::Key_Left);
        QCOMPARE(fixture.frame(), 39);
        QTest::keyClick(&plot, Qt::Key_Right);
        QTest::keyClick(&plot, Qt::Key_Right);
        QCOMPARE(fixture.frame(), 41);
        QTest::keyClick(&plot, Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(fixture.session.timeline().cursor().phase, 1);
        QTest::keyClick(&plot, Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(fixture.session.timeline().cursor().phase, 0);
    }

    void aScreenReaderHearsWhatThePlotShowsAtTheCursor()
    {
        EnergyFixture fixture;
        fixture.goTo(12);
        QAccessibleInterface *access = QAccessible::queryAccessibleInterface(&fixture.panel.plot());
        QCOMPARE(access->role(), QAccessible::Chart);
        QCOMPARE(access->text(QAccessible::Name), QString("Energy over the last frames"));
        const QString said = access->text(QAccessible::Value);
        QVERIFY2(said.contains(fixture.panel.plot().readout(12)) && said.endsWith("frame 12"),
                 qPrintable(said));
        fixture.panel.setView(EnergyView::momentum);
        const QString momentum = access->text(QAccessible::Value);
        QVERIFY2(momentum.contains("to the right"), qPrintable(momentum));
    }

    void theWindowMarksWhereTheMouseIsInAllPlotsAndOnTheTimeline()
    {
        WindowFixture fixture(
            {.lesson = "one", .step = "first", .size = {1920, 1080}, .library = twoLessons()});
        MainWindow &window = fixture.window;
        window.docks().show(Panel::energy, true);
        fixture.session.playback().goTo({60, 0});
        auto &energy = *window.findChild<EnergyPanel *>();
        QTRY_VERIFY(energy.series().last() >= 60 && window.plots().isSettled());
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
        QCOMPARE(fixture.session.timeline().cursor().frame, 60); // nothing of this has moved time
        fixture.session.openStep("one", "second");               // its frames are others
        QVERIFY(!timeline.pointed() && !plot.hovered());
    }

    void stackDiffersFromTheGivenEnergyByTheDrift()
    {
        EnergyFixture fixture;
        fixture.goTo(50);
        for (const std::int64_t frame : {0, 7, 50}) {
            const sim::Balance &balance = *fixture.panel.series().at(frame);
            const EnergyPlot::Stack stack = EnergyPlot::stackOf(balance, -3.0);
            QVERIFY(std::abs(stack.tops[4] - stack.given - balance.energy[sim::Account::drift]) < 1e-9);
            QVERIFY(std::abs(stack.given - atStart - 3.0) < 1e-9);
            QVERIFY(std::is_sorted(stack.tops.begin(), stack.tops.end()));
        }
    }
};

SUITE(tst_energy_plot, EnergyPlotTest)
#include "tst_energy_plot.moc"

// Plots of quantities in the window, driven as a learner drives them.

#include "app/ui/time/timeline_strip.h"
#include "app/ui/window/main_window.h"
#include "plots_panel_bench.h"

#include <QAccessible>
#include <QDockWidget>
#include <QMenu>
#include <QtTest>

using namespace app;
using plots_panel_bench::Bench;

namespace {

MainWindow::Mode modeOf(bool measures)
{
    return measures ? MainWindow::Mode::measure : MainWindow::Mode::learn;
}

}

class PlotsPanelTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }

    void aStepBeginsWithTheSelectedBodysHeight()
    {
        Bench bench;
        QCOMPARE(bench.panel->cards().size(), 1);
        QCOMPARE(bench.plot().title(), QString("y of foot against time"));
        QVERIFY(bench.plot().emptyText().contains("Play"));
        bench.goTo(30);
        QCOMPARE(bench.plot().emptyText(), QString());
        QVERIFY(bench.plot().yAxis->rangeReversed()); // down in the picture is down in the plot
        const double y = bench.session().timeline().state().positionOf(0).y;
        QCOMPARE(bench.plot().valueText(), QString("%1\u2009px").arg(y, 0, 'f', 2));
    }

    void theAmberLineStandsAtTheCursor()
    {
        Bench bench;
        bench.goTo(100);
        bench.goTo(37);
        QTest::qWait(20);
        const QImage image = bench.plot().grab().toImage();
        const QColor amber = bench.world.theme.tokens().now;
        const int x = qRound(bench.plot().xAxis->coordToPixel(37.0));
        const int bottom = bench.plot().axisRect()->bottom() - 3;
        QVERIFY(image.pixelColor(x, bottom) == amber || image.pixelColor(x - 1, bottom) == amber);
        QVERIFY(bench.pixels(amber, image) > 60);
    }

    void aPressAndADragGoToTheirFrames()
    {
        Bench bench;
        bench.goTo(100);
        QuantityPlot &plot = bench.plot();
        const auto placeOf = [&](double frame) {
            return QPoint(qRound(plot.xAxis->coordToPixel(frame)), plot.height() / 2);
        };
        bench.session().play();
        QTest::mousePress(&plot, Qt::LeftButton, {}, placeOf(25.0));
        QVERIFY(!bench.session().isPlaying());
        QVERIFY(std::abs(bench.frame() - 25) <= 1);
        bench.hover(placeOf(70.0), 0, Qt::LeftButton);
        QVERIFY(std::abs(bench.frame() - 70) <= 1);
        bench.hover(placeOf(5000.0), 0, Qt::LeftButton); // past the end: to the end
        bench.settle();
        QVERIFY(bench.frame() >= 100 && bench.frame() == bench.session().timeline().computed());
        QTest::mouseRelease(&plot, Qt::LeftButton, {}, placeOf(10.0));
        bench.hover(placeOf(10.0));
        QVERIFY(bench.frame() >= 100); // let go
    }

    void aHoveredFrameIsShownInAllPlotsAndMovesNoTime()
    {
        Bench bench;
        bench.panel->add({{Measured::velocityY}, {Measured::placeY}});
        bench.goTo(80);
        bench.hover({qRound(bench.plot().xAxis->coordToPixel(20.0)), 60});
        QCOMPARE(bench.plot(0).hovered(), 20);
        QCOMPARE(bench.plot(1).hovered(), 20);
        QCOMPARE(bench.frame(), 80);
        bench.hover(bench.plot(1).placeOf(33).toPoint(), 1);
        QVERIFY(bench.plot(0).hovered());
        QCOMPARE(bench.plot(0).hovered(), bench.plot(1).hovered());
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&bench.plot(1), &leave);
        QVERIFY(!bench.plot(0).hovered());
    }

    void arrowsMoveAFrameAndWithShiftAPhase()
    {
        Bench bench;
        bench.goTo(40);
        bench.plot().setFocus();
        QTest::keyClick(&bench.plot(), Qt::Key_Left);
        QCOMPARE(bench.frame(), 39);
        QTest::keyClick(&bench.plot(), Qt::Key_Right);
        QTest::keyClick(&bench.plot(), Qt::Key_Right);
        QCOMPARE(bench.frame(), 41);
        QTest::keyClick(&bench.plot(), Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(bench.session().timeline().cursor().phase, 1);
        QTest::keyClick(&bench.plot(), Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(bench.session().timeline().cursor().phase, 0);
    }

    void fewerAndMoreFramesAreShownInAllPlots()
    {
        Bench bench;
        bench.panel->add({{Measured::speed}, {}});
        bench.goTo(1000);
        QCOMPARE(bench.plot().xAxis->range().size(), 480.0);
        QTest::keyClick(&bench.plot(), Qt::Key_Plus);
        bench.settle();
        QCOMPARE(bench.plot(0).xAxis->range().size(), 240.0);
        QCOMPARE(bench.plot(1).xAxis->range().size(), 240.0);
        QVERIFY(bench.plot().xAxis->range().contains(1000.0));
        for (int i = 0; i < 4; ++i)
            QTest::keyClick(&bench.plot(), Qt::Key_Minus);
        bench.settle();
        QCOMPARE(bench.plot().xAxis->range().lower, 0.0);
        QVERIFY(bench.plot().xAxis->range().upper >= 1000.0);
    }

    void menusChooseQuantityBodyAndWhatItIsAgainst()
    {
        Bench bench;
        bench.goTo(50);
        bench.choose("speed");
        QCOMPARE(bench.plot().title(), QString("speed of foot against time"));
        bench.choose("body", "of which body");
        QCOMPARE(bench.plot().title(), QString("speed of body against time"));
        bench.choose("the selected one", "of which body");
        bench.choose("body", "distance to");
        QCOMPARE(bench.plot().title(), QString("distance foot – body against time"));
        bench.choose("x", nullptr, 1);
        QCOMPARE(bench.plot().title(), QString("distance foot – body against x of foot"));
        bench.choose("time", nullptr, 1);
        bench.choose("total energy");
        QCOMPARE(bench.plot().title(), QString("total energy against time"));
        QVERIFY(bench.plot().emptyText().isEmpty());
    }

    void aMenuThatOpensAgainHasNotGrown()
    {
        Bench bench;
        QMenu *menu = bench.panel->cards()[0]->findChildren<FlatButton *>()[0]->menu();
        emit menu->aboutToShow();
        const qsizetype within = menu->findChildren<QObject *>().size();
        for (int i = 0; i < 3; ++i)
            emit menu->aboutToShow();
        QCOMPARE(menu->findChildren<QObject *>().size(), within);
    }

    void itFollowsTheSelectedBodyUnlessItIsKept()
    {
        Bench bench;
        bench.goTo(50);
        bench.session().select("body");
        bench.settle();
        QCOMPARE(bench.plot().title(), QString("y of body against time"));
        QMenu *menu = bench.panel->cards()[0]->menu();
        Bench::entryOf(*menu, "Keep to body")->trigger();
        bench.session().select("foot");
        bench.settle();
        QCOMPARE(bench.plot().title(), QString("y of body against time"));
        QMenu *again = bench.panel->cards()[0]->menu();
        QAction *keep = Bench::entryOf(*again, "Keep to body");
        QVERIFY(keep->isChecked());
        keep->trigger();
        bench.settle();
        QCOMPARE(bench.plot().title(), QString("y of foot against time"));
    }

    void plotsAreRemovedByKeyAndTheLastOneLeavesAHint()
    {
        Bench bench;
        bench.panel->add({{Measured::speed}, {}});
        QCOMPARE(bench.panel->cards().size(), 2);
        QTest::keyClick(&bench.plot(0), Qt::Key_Delete);
        QTRY_COMPARE(bench.panel->cards().size(), 1);
        QCOMPARE(bench.plot().title(), QString("speed of foot against time"));
        QTest::keyClick(&bench.plot(0), Qt::Key_Delete);
        QTRY_VERIFY(bench.panel->cards().empty());
        const QList<QLabel *> labels = bench.panel->findChildren<QLabel *>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel *label) {
            return label->isVisible() && label->text().contains("Nothing is plotted");
        }));
    }

    void whatAStepDoesNotHaveIsSaidAndComesBack()
    {
        Bench bench;
        bench.goTo(40);
        bench.choose("speed");
        bench.choose("body", "of which body");
        bench.session().openStep("plots", "fall");
        bench.goTo(10);
        QVERIFY2(bench.plot().emptyText().contains("Nothing here is called body"),
                 qPrintable(bench.plot().emptyText()));
        bench.session().openStep("plots", "puppet");
        bench.goTo(10);
        QVERIFY(bench.plot().emptyText().contains("keeps no velocity"));
        bench.session().openStep("plots", "pair");
        bench.goTo(40);
        QVERIFY(bench.plot().emptyText().isEmpty());
    }

    void aScreenReaderHearsWhatIsPlottedAndItsValue()
    {
        Bench bench;
        bench.goTo(12);
        QAccessibleInterface *access = QAccessible::queryAccessibleInterface(&bench.plot());
        QCOMPARE(access->role(), QAccessible::Chart);
        QCOMPARE(access->text(QAccessible::Name), QString("y of foot against time"));
        const QString said = access->text(QAccessible::Value);
        QVERIFY2(said.contains(bench.plot().valueText()) && said.endsWith("frame 12"), qPrintable(said));
        for (const QWidget *button : bench.panel->findChildren<QToolButton *>()) {
            QVERIFY(!button->accessibleName().isEmpty());
            QVERIFY(!button->toolTip().isEmpty());
        }
    }

    void theTimelineAndThePlotsMoveTogether()
    {
        World world(plots_bench::library());
        QSettings().clear();
        MainWindow window(world.session, world.theme);
        show(window, {1280, 800});
        window.showPlots(true);
        world.session.goTo({90, 0});
        QVERIFY(QTest::qWaitFor([&] { return window.plots().isSettled(); }));
        auto *timeline = window.findChild<TimelineStrip *>();
        const QPoint at(qRound(timeline->axis().xOf(40)), 20);
        QTest::mouseClick(timeline, Qt::LeftButton, {}, at);
        QVERIFY(QTest::qWaitFor([&] { return window.plots().isSettled(); }));
        const std::int64_t frame = world.session.timeline().cursor().frame;
        QVERIFY(std::abs(frame - 40) <= 1);
        QuantityPlot &plot = window.plots().cards()[0]->plot();
        QVERIFY(plot.sentence().endsWith(QString("frame %1").arg(frame)));
        QTest::mouseClick(&plot, Qt::LeftButton, {},
                          {qRound(plot.xAxis->coordToPixel(70.0)), plot.height() / 2});
        QVERIFY(std::abs(timeline->frame() - 70) <= 1);
    }

    void theWindowHasAPlaceForPlotsInEachSize_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("measures");
        QTest::addColumn<bool>("isTab");
        QTest::newRow("learn, small") << QSize(1280, 800) << false << true;
        QTest::newRow("learn, large") << QSize(1920, 1080) << false << false;
        QTest::newRow("measure, small") << QSize(1280, 800) << true << true;
        QTest::newRow("measure, large") << QSize(1920, 1080) << true << false;
    }

    void theWindowHasAPlaceForPlotsInEachSize()
    {
        QFETCH(QSize, size);
        QFETCH(bool, measures);
        QFETCH(bool, isTab);
        World world(plots_bench::library());
        QSettings().clear();
        MainWindow window(world.session, world.theme,
                          [](const sim::Script &, const sim::StudyPlan &, const sim::StudyProgress &) {
                              return sim::Accuracy{};
                          });
        show(window, size);
        window.setMode(modeOf(measures));
        QTest::qWait(50);
        QCOMPARE(window.size(), size);
        auto *action = window.findChild<QAction *>("showPlots");
        QCOMPARE(action->shortcut(), QKeySequence("Ctrl+5"));
        const auto *dock = qobject_cast<QDockWidget *>(window.plots().parentWidget());
        QVERIFY(dock);
        action->trigger(); // a covered tab comes to the front; an open dock closes
        if (dock->isHidden() || window.plots().isCovered())
            action->trigger();
        QTRY_VERIFY(!dock->isHidden() && !window.plots().isCovered());
        QCOMPARE(!window.tabifiedDockWidgets(const_cast<QDockWidget *>(dock)).isEmpty(), isTab);
        QCOMPARE(window.size(), size);
        action->trigger();
        QVERIFY(dock->isHidden());
        QVERIFY(!action->isChecked());
        window.setMode(modeOf(!measures));
        QVERIFY(dock->isHidden()); // as the learner wants it
    }
};

QTEST_MAIN(PlotsPanelTest)
#include "tst_plots_panel.moc"

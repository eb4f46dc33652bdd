// Plots of quantities in the window, driven as a learner drives them.

#include "app/ui/time/timeline_strip.h"
#include "app/ui/window/main_window.h"
#include "tests/app/plots/plots_panel_support.h"
#include "tests/app/support/window_fixture.h"
#include "tests/suite.h"

#include <QAccessible>
#include <QDockWidget>
#include <QMenu>
#include <QtTest>

using namespace app;
using namespace tests;
using plots_panel_support::PlotsFixture;

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
    void aStepBeginsWithTheSelectedBodysHeight()
    {
        PlotsFixture fixture;
        QCOMPARE(fixture.panel.cards().size(), 1);
        QCOMPARE(fixture.plot().title(), QString("y of foot against time"));
        QVERIFY(fixture.plot().emptyText().contains("Play"));
        fixture.goTo(30);
        QCOMPARE(fixture.plot().emptyText(), QString());
        QVERIFY(fixture.plot().yAxis->rangeReversed()); // down in the picture is down in the plot
        const double y = fixture.session.timeline().state().positionOf(0).y;
        QCOMPARE(fixture.plot().valueText(), QString("%1\u2009px").arg(y, 0, 'f', 2));
    }

    void amberLineMarksTheCursor()
    {
        PlotsFixture fixture;
        fixture.goTo(100);
        fixture.goTo(37);
        settle();
        const QImage image = fixture.plot().grab().toImage();
        const QColor amber = fixture.theme.tokens().now;
        const int x = qRound(fixture.plot().xAxis->coordToPixel(37.0));
        const int bottom = fixture.plot().axisRect()->bottom() - 3;
        QVERIFY(image.pixelColor(x, bottom) == amber || image.pixelColor(x - 1, bottom) == amber);
        QVERIFY(fixture.pixels(amber, image) > 60);
    }

    void aPressAndADragGoToTheirFrames()
    {
        PlotsFixture fixture;
        fixture.goTo(100);
        QuantityPlot &plot = fixture.plot();
        const auto placeOf = [&](double frame) {
            return QPoint(qRound(plot.xAxis->coordToPixel(frame)), plot.height() / 2);
        };
        fixture.session.playback().play();
        QTest::mousePress(&plot, Qt::LeftButton, {}, placeOf(25.0));
        QVERIFY(!fixture.session.playback().isPlaying());
        QVERIFY(std::abs(fixture.frame() - 25) <= 1);
        fixture.hover(placeOf(70.0), 0, Qt::LeftButton);
        QVERIFY(std::abs(fixture.frame() - 70) <= 1);
        fixture.hover(placeOf(5000.0), 0, Qt::LeftButton); // past the end: to the end
        fixture.settle();
        QVERIFY(fixture.frame() >= 100 && fixture.frame() == fixture.session.timeline().computed());
        QTest::mouseRelease(&plot, Qt::LeftButton, {}, placeOf(10.0));
        fixture.hover(placeOf(10.0));
        QVERIFY(fixture.frame() >= 100); // let go
    }

    void aHoveredFrameIsShownInAllPlotsAndMovesNoTime()
    {
        PlotsFixture fixture;
        fixture.panel.add({{QuantityKind::velocityY}, {QuantityKind::placeY}});
        fixture.goTo(80);
        fixture.hover({qRound(fixture.plot().xAxis->coordToPixel(20.0)), 60});
        QCOMPARE(fixture.plot(0).hovered(), 20);
        QCOMPARE(fixture.plot(1).hovered(), 20);
        QCOMPARE(fixture.frame(), 80);
        fixture.hover(fixture.plot(1).placeOf(33).toPoint(), 1);
        QVERIFY(fixture.plot(0).hovered());
        QCOMPARE(fixture.plot(0).hovered(), fixture.plot(1).hovered());
        QEvent leave(QEvent::Leave);
        QApplication::sendEvent(&fixture.plot(1), &leave);
        QVERIFY(!fixture.plot(0).hovered());
    }

    void arrowsMoveAFrameAndWithShiftAPhase()
    {
        PlotsFixture fixture;
        fixture.goTo(40);
        fixture.plot().setFocus();
        QTest::keyClick(&fixture.plot(), Qt::Key_Left);
        QCOMPARE(fixture.frame(), 39);
        QTest::keyClick(&fixture.plot(), Qt::Key_Right);
        QTest::keyClick(&fixture.plot(), Qt::Key_Right);
        QCOMPARE(fixture.frame(), 41);
        QTest::keyClick(&fixture.plot(), Qt::Key_Right, Qt::ShiftModifier);
        QCOMPARE(fixture.session.timeline().cursor().phase, 1);
        QTest::keyClick(&fixture.plot(), Qt::Key_Left, Qt::ShiftModifier);
        QCOMPARE(fixture.session.timeline().cursor().phase, 0);
    }

    void fewerAndMoreFramesAreShownInAllPlots()
    {
        PlotsFixture fixture;
        fixture.panel.add({{QuantityKind::speed}, {}});
        fixture.goTo(1000);
        QCOMPARE(fixture.plot().xAxis->range().size(), 480.0);
        QTest::keyClick(&fixture.plot(), Qt::Key_Plus);
        fixture.settle();
        QCOMPARE(fixture.plot(0).xAxis->range().size(), 240.0);
        QCOMPARE(fixture.plot(1).xAxis->range().size(), 240.0);
        QVERIFY(fixture.plot().xAxis->range().contains(1000.0));
        for (int i = 0; i < 4; ++i)
            QTest::keyClick(&fixture.plot(), Qt::Key_Minus);
        fixture.settle();
        QCOMPARE(fixture.plot().xAxis->range().lower, 0.0);
        QVERIFY(fixture.plot().xAxis->range().upper >= 1000.0);
    }

    void menusChooseQuantityBodyAndWhatItIsAgainst()
    {
        PlotsFixture fixture;
        fixture.goTo(50);
        fixture.choose("speed");
        QCOMPARE(fixture.plot().title(), QString("speed of foot against time"));
        fixture.choose("body", "of which body");
        QCOMPARE(fixture.plot().title(), QString("speed of body against time"));
        fixture.choose("the selected one", "of which body");
        fixture.choose("body", "distance to");
        QCOMPARE(fixture.plot().title(), QString("distance foot – body against time"));
        fixture.choose("x", nullptr, 1);
        QCOMPARE(fixture.plot().title(), QString("distance foot – body against x of foot"));
        fixture.choose("time", nullptr, 1);
        fixture.choose("total energy");
        QCOMPARE(fixture.plot().title(), QString("total energy against time"));
        QVERIFY(fixture.plot().emptyText().isEmpty());
    }

    void aMenuThatOpensAgainHasNotGrown()
    {
        PlotsFixture fixture;
        QMenu *menu = fixture.panel.cards()[0]->findChildren<FlatButton *>()[0]->menu();
        emit menu->aboutToShow();
        const qsizetype within = menu->findChildren<QObject *>().size();
        for (int i = 0; i < 3; ++i)
            emit menu->aboutToShow();
        QCOMPARE(menu->findChildren<QObject *>().size(), within);
    }

    void plotFollowsTheSelectedBodyUnlessItIsPinned()
    {
        PlotsFixture fixture;
        fixture.goTo(50);
        fixture.session.select("body");
        fixture.settle();
        QCOMPARE(fixture.plot().title(), QString("y of body against time"));
        QMenu *menu = fixture.panel.cards()[0]->menu();
        PlotsFixture::entryOf(*menu, "Pin to body")->trigger();
        fixture.session.select("foot");
        fixture.settle();
        QCOMPARE(fixture.plot().title(), QString("y of body against time"));
        QMenu *again = fixture.panel.cards()[0]->menu();
        QAction *keep = PlotsFixture::entryOf(*again, "Pin to body");
        QVERIFY(keep->isChecked());
        keep->trigger();
        fixture.settle();
        QCOMPARE(fixture.plot().title(), QString("y of foot against time"));
    }

    void plotsAreRemovedByKeyAndTheLastOneLeavesAHint()
    {
        PlotsFixture fixture;
        fixture.panel.add({{QuantityKind::speed}, {}});
        QCOMPARE(fixture.panel.cards().size(), 2);
        QTest::keyClick(&fixture.plot(0), Qt::Key_Delete);
        QTRY_COMPARE(fixture.panel.cards().size(), 1);
        QCOMPARE(fixture.plot().title(), QString("speed of foot against time"));
        QTest::keyClick(&fixture.plot(0), Qt::Key_Delete);
        QTRY_VERIFY(fixture.panel.cards().empty());
        const QList<QLabel *> labels = fixture.panel.findChildren<QLabel *>();
        QVERIFY(std::any_of(labels.begin(), labels.end(), [](const QLabel *label) {
            return label->isVisible() && label->text().contains("There is no plot yet");
        }));
    }

    void aPlotThatTheStepLacksSaysSoAndComesBack()
    {
        PlotsFixture fixture;
        fixture.goTo(40);
        fixture.choose("speed");
        fixture.choose("body", "of which body");
        fixture.session.openStep("plots", "fall");
        fixture.goTo(10);
        QVERIFY2(fixture.plot().emptyText().contains("There is no body in this step"),
                 qPrintable(fixture.plot().emptyText()));
        fixture.session.openStep("plots", "puppet");
        fixture.goTo(10);
        QVERIFY(fixture.plot().emptyText().contains("no velocity of its own"));
        fixture.session.openStep("plots", "pair");
        fixture.goTo(40);
        QVERIFY(fixture.plot().emptyText().isEmpty());
    }

    void aScreenReaderHearsWhatIsPlottedAndItsValue()
    {
        PlotsFixture fixture;
        fixture.goTo(12);
        QAccessibleInterface *access = QAccessible::queryAccessibleInterface(&fixture.plot());
        QCOMPARE(access->role(), QAccessible::Chart);
        QCOMPARE(access->text(QAccessible::Name), QString("y of foot against time"));
        const QString said = access->text(QAccessible::Value);
        QVERIFY2(said.contains(fixture.plot().valueText()) && said.endsWith("frame 12"), qPrintable(said));
        const auto buttons = fixture.panel.findChildren<QToolButton *>();
        QVERIFY(!buttons.isEmpty());
        for (const QToolButton *button : buttons) {
            QVERIFY(!button->accessibleName().isEmpty());
            QVERIFY(!button->toolTip().isEmpty());
        }
    }

    void theTimelineAndThePlotsMoveTogether()
    {
        QSettings().clear();
        WindowFixture fixture({.lesson = "plots", .step = "pair", .library = plots_support::library()});
        MainWindow &window = fixture.window;
        window.docks().show(Panel::plots, true);
        fixture.session.playback().goTo({90, 0});
        QVERIFY(QTest::qWaitFor([&] { return window.plots().isSettled(); }));
        auto *timeline = window.findChild<TimelineStrip *>();
        const QPoint at(qRound(timeline->axis().xOf(40)), 20);
        QTest::mouseClick(timeline, Qt::LeftButton, {}, at);
        QVERIFY(QTest::qWaitFor([&] { return window.plots().isSettled(); }));
        const std::int64_t frame = fixture.session.timeline().cursor().frame;
        QVERIFY(std::abs(frame - 40) <= 1);
        QuantityPlot &plot = window.plots().cards()[0]->plot();
        QVERIFY(plot.sentence().endsWith(QString("frame %1").arg(frame)));
        QTest::mouseClick(&plot, Qt::LeftButton, {},
                          {qRound(plot.xAxis->coordToPixel(70.0)), plot.height() / 2});
        QVERIFY(std::abs(timeline->frame() - 70) <= 1);
    }

    void windowHasRoomForPlotsAtEachSize_data()
    {
        QTest::addColumn<QSize>("size");
        QTest::addColumn<bool>("measures");
        QTest::addColumn<bool>("isTab");
        QTest::newRow("learn, small") << QSize(1280, 800) << false << true;
        QTest::newRow("learn, large") << QSize(1920, 1080) << false << false;
        QTest::newRow("measure, small") << QSize(1280, 800) << true << true;
        QTest::newRow("measure, large") << QSize(1920, 1080) << true << false;
    }

    void windowHasRoomForPlotsAtEachSize()
    {
        QFETCH(QSize, size);
        QFETCH(bool, measures);
        QFETCH(bool, isTab);
        QSettings().clear();
        WindowFixture fixture(
            {.lesson = "plots", .step = "pair", .size = size, .library = plots_support::library()});
        MainWindow &window = fixture.window;
        window.setMode(modeOf(measures));
        settle();
        QCOMPARE(window.size(), size);
        auto *action = &fixture.action("showPlots");
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

SUITE(tst_plots_panel, PlotsPanelTest)
#include "tst_plots_panel.moc"

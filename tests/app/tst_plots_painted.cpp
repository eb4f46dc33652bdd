// What plots paint, and when: the run, the old run, and a moment inside a frame.

#include "plots_panel_bench.h"

using namespace app;
using plots_panel_bench::Bench;

class PlotsPaintedTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { prepareProgram(); }

    void theOldRunIsADashedCurve()
    {
        Bench bench;
        bench.goTo(120);
        bench.goTo(40);
        const QColor ghost = bench.world.theme.tokens().ghost;
        QTest::qWait(20);
        QCOMPARE(bench.pixels(ghost, bench.plot().grab().toImage()), 0);
        bench.session().setParameter("k", 0.3);
        bench.goTo(120);
        QTest::qWait(20);
        QVERIFY(bench.pixels(ghost, bench.plot().grab().toImage()) > 20);
    }

    void nothingIsPaintedWhileNothingChanges()
    {
        Bench bench;
        bench.goTo(60);
        QTest::qWait(50);
        const int curves = bench.plot().curvesPainted();
        QTest::qWait(200);
        QCOMPARE(bench.plot().curvesPainted(), curves);
        const int axes = bench.plot().axesPainted();
        for (int i = 0; i < 40; ++i) { // as playing does
            bench.session().frameForward();
            QCoreApplication::processEvents();
        }
        QVERIFY(bench.plot().curvesPainted() - curves <= 41); // one for each picture
        QVERIFY2(bench.plot().axesPainted() - axes <= 6,
                 qPrintable(QString::number(bench.plot().axesPainted() - axes)));
        bench.panel->hide();
        const int hidden = bench.plot().curvesPainted();
        bench.session().goTo({10, 0});
        QTest::qWait(50);
        QCOMPARE(bench.plot().curvesPainted(), hidden);
    }

    void theOldRunIsNotPaintedAnewWhereOnlyTheCursorMoves()
    {
        Bench bench;
        bench.goTo(120);
        bench.goTo(40);
        bench.session().setParameter("k", 0.3);
        bench.goTo(120);
        QTest::qWait(20);
        const int ghosts = bench.plot().ghostsPainted(), axes = bench.plot().axesPainted();
        const int curves = bench.plot().curvesPainted();
        QVERIFY(ghosts > 0);
        for (std::int64_t frame = 119; frame > 60; --frame)
            bench.goTo(frame);
        QCOMPARE(bench.plot().ghostsPainted(), ghosts);
        QCOMPARE(bench.plot().axesPainted(), axes);
        QVERIFY(bench.plot().curvesPainted() <= curves + 59); // once for each moment
    }

    void insideAFrameARingIsWhereTheQuantityIsThen_data()
    {
        QTest::addColumn<bool>("isAgainstTime");
        QTest::newRow("against time") << true;
        QTest::newRow("against another quantity") << false;
    }
    void insideAFrameARingIsWhereTheQuantityIsThen()
    {
        QFETCH(bool, isAgainstTime);
        Bench bench;
        if (!isAgainstTime)
            bench.panel->list().change(0, {{Measured::placeY}, {Measured::velocityY}});
        bench.goTo(12);
        QuantityPlot &plot = bench.plot();
        QVERIFY(!plot.insidePlace());
        const QString before = plot.valueText();
        const sim::Timeline &run = bench.session().timeline();
        const double y = run.now().at(0).y;
        while (run.now().at(0).y == y)
            bench.session().phaseForward();
        QVERIFY(run.at().phase > 0 && run.at().frame == 12);
        bench.settle();
        const double time = 12.0 + double(run.at().phase) / run.track().shown().pipeline.phasesPerRow();
        const double across = isAgainstTime ? time : run.now().speed(0).y;
        QVERIFY(plot.insidePlace());
        const QPointF ring(plot.xAxis->coordToPixel(across), plot.yAxis->coordToPixel(run.now().at(0).y));
        QVERIFY(QLineF(*plot.insidePlace(), ring).length() < 1e-6);
        QVERIFY(plot.valueText() != before);
        QVERIFY2(plot.sentence().endsWith("inside frame 12"), qPrintable(plot.sentence()));
        const QImage shown = plot.grab().toImage();
        const QColor now = bench.world.theme.tokens().now;
        QCOMPARE(shown.pixelColor(plot.placeOf(12).toPoint()), now); // the dot stays where the curve is
        QCOMPARE(shown.pixelColor(ring.toPoint()), bench.world.theme.tokens().panel);
        while (run.at().phase > 0)
            bench.session().phaseForward();
        bench.settle();
        QVERIFY(!plot.insidePlace());
        QVERIFY(plot.sentence().endsWith("at frame 13"));
    }
};

QTEST_MAIN(PlotsPaintedTest)
#include "tst_plots_painted.moc"

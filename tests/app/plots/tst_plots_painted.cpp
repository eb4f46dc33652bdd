// Painting of plots: the run, the old run, and a moment inside a frame. Also tests when plots repaint.

#include "app/ui/plots/dashed_curve.h"
#include "app/ui/plots/plot_value.h"
#include "tests/app/plots/plots_panel_support.h"
#include "tests/suite.h"

#include <limits>

using namespace app;
using namespace tests;
using plots_panel_support::PlotsFixture;

class PlotsPaintedTest : public QObject
{
    Q_OBJECT

private slots:
    void theOldRunIsADashedCurve()
    {
        PlotsFixture fixture;
        fixture.goTo(120);
        fixture.goTo(40);
        const QColor comparison = fixture.theme.tokens().ghost;
        settle();
        QCOMPARE(fixture.pixels(comparison, fixture.plot().grab().toImage()), 0);
        fixture.session.editor().setParameter("k", 0.3);
        fixture.goTo(120);
        settle();
        QVERIFY(fixture.pixels(comparison, fixture.plot().grab().toImage()) > 20);
    }

    void aPowerOfTenHasDigitsThatCanBeRead()
    {
        const Theme theme(Scheme::light);
        const QString power = QStringLiteral("−4.1·10¹⁰⁵ px");
        PlotValue value(theme);
        value.resize(200, 24);
        QPixmap expected = value.grab();
        QPainter painter(&expected);
        painter.setFont(theme.ui(12)); // not the monospaced one
        painter.setPen(theme.tokens().ink);
        painter.drawText(value.rect(), Qt::AlignRight | Qt::AlignVCenter, power);
        painter.end();
        value.setText(power, {});
        QCOMPARE(value.grab().toImage(), expected.toImage());
    }

    void dashesAreHalfOfALineAndLieOnIt()
    {
        QVector<QPointF> bent;
        for (int i = 0; i <= 100; ++i)
            bent << QPointF(3.0 * i, i % 2 ? 40.0 : 0.0); // corners every 40.1 px, dashes of 4.5
        double all = 0.0, drawn = 0.0;
        for (qsizetype i = 1; i < bent.size(); ++i)
            all += QLineF(bent[i - 1], bent[i]).length();
        for (const QLineF &dash : dashesAlong(bent, 4.5, QRectF(-1.0, -1.0, 400.0, 100.0))) {
            drawn += dash.length();
            QVERIFY(dash.length() <= 4.5 + 1e-9);
            for (const QPointF end :
                 {dash.p1(), dash.p2()}) { // between two corners, on the line from one to the other
                const double along = end.x() / 3.0, over = along - std::floor(along);
                const bool rises = static_cast<int>(std::floor(along + 1e-9)) % 2 == 0;
                const double height = 40.0 * (rises ? over : 1.0 - over);
                QVERIFY(std::abs(end.y() - height) < 1e-6 || over < 1e-6 || over > 1.0 - 1e-6);
            }
        }
        QVERIFY(std::abs(drawn - all / 2.0) < 4.5);
    }

    void dashesAreComputedOnlyInTheVisiblePart()
    {
        const QRectF seen(0.0, 0.0, 300.0, 200.0);
        constexpr double nan = std::numeric_limits<double>::quiet_NaN();
        QCOMPARE(dashesAlong({{-500.0, 50.0}, {-10.0, 50.0}}, 4.5, seen).size(), 0);
        QCOMPARE(dashesAlong({{-9e15, 50.0}, {9e15, 50.0}}, 4.5, seen).size() > 0, true);
        QVERIFY(dashesAlong({{-9e15, 50.0}, {9e15, 50.0}}, 4.5, seen).size() < 100);
        QVERIFY(dashesAlong({{150.0, -1e300}, {150.0, 1e300}}, 4.5, seen).size() <
                100); // and comes to an end
        QCOMPARE(dashesAlong({{10.0, 10.0}, {10.0, 10.0}}, 4.5, seen).size(), 0);
        const QVector<QLineF> parted =
            dashesAlong({{0.0, 9.0}, {9.0, 9.0}, {nan, nan}, {100.0, 9.0}, {109.0, 9.0}}, 4.5, seen);
        QCOMPARE(parted.size(), 2);
        QCOMPARE(parted[0], QLineF(0.0, 9.0, 4.5, 9.0));
        QCOMPARE(parted[1], QLineF(100.0, 9.0, 104.5, 9.0));
    }

    void nothingIsPaintedWhileNothingChanges()
    {
        PlotsFixture fixture;
        fixture.goTo(60);
        settle();
        const int curves = fixture.plot().curvesPainted();
        QVERIFY(curves > 0);
        QVERIFY(Activity().comesToRest(200));
        QCOMPARE(fixture.plot().curvesPainted(), curves);
        const int axes = fixture.plot().axesPainted();
        for (int i = 0; i < 40; ++i) { // as playing does
            fixture.session.playback().frameForward();
            QCoreApplication::processEvents();
        }
        const auto painted = fixture.plot().curvesPainted() - curves;
        QVERIFY2(painted >= 20 && painted <= 41,
                 qPrintable(QString::number(painted))); // one for each picture
        QVERIFY2(fixture.plot().axesPainted() - axes <= 6,
                 qPrintable(QString::number(fixture.plot().axesPainted() - axes)));
        fixture.panel.hide();
        const int hidden = fixture.plot().curvesPainted();
        fixture.session.playback().goTo({10, 0});
        QTRY_VERIFY(!fixture.session.playback().goal());
        settle();
        QCOMPARE(fixture.plot().curvesPainted(), hidden);
    }

    void movingTheCursorDoesNotRepaintTheOldRun()
    {
        PlotsFixture fixture;
        fixture.goTo(120);
        fixture.goTo(40);
        fixture.session.editor().setParameter("k", 0.3);
        fixture.goTo(120);
        settle();
        const int comparisons = fixture.plot().comparisonsPainted(), axes = fixture.plot().axesPainted();
        const int curves = fixture.plot().curvesPainted();
        QVERIFY(comparisons > 0);
        for (std::int64_t frame = 119; frame > 60; --frame)
            fixture.goTo(frame);
        QCOMPARE(fixture.plot().comparisonsPainted(), comparisons);
        QCOMPARE(fixture.plot().axesPainted(), axes);
        QVERIFY(fixture.plot().curvesPainted() > curves);
        QVERIFY(fixture.plot().curvesPainted() <= curves + 59); // once for each moment
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
        PlotsFixture fixture;
        if (!isAgainstTime)
            fixture.panel.list().change(0, {{QuantityKind::placeY}, {QuantityKind::velocityY}});
        fixture.goTo(12);
        QuantityPlot &plot = fixture.plot();
        QVERIFY(!plot.insidePlace());
        const QString before = plot.valueText();
        const sim::Timeline &run = fixture.session.timeline();
        const double y = run.state().positionOf(0).y;
        while (run.state().positionOf(0).y == y)
            fixture.session.playback().phaseForward();
        QVERIFY(run.cursor().phase > 0 && run.cursor().frame == 12);
        fixture.settle();
        const double time =
            12.0 + double(run.cursor().phase) / run.track().interval().pipeline.phasesPerOutput();
        const double across = isAgainstTime ? time : run.state().velocityOf(0).y;
        QVERIFY(plot.insidePlace());
        const QPointF ring(plot.xAxis->coordToPixel(across),
                           plot.yAxis->coordToPixel(run.state().positionOf(0).y));
        QVERIFY(QLineF(*plot.insidePlace(), ring).length() < 1e-6);
        QVERIFY(plot.valueText() != before);
        QVERIFY2(plot.sentence().endsWith("inside frame 12"), qPrintable(plot.sentence()));
        const QImage shown = plot.grab().toImage();
        const QColor now = fixture.theme.tokens().now;
        QCOMPARE(shown.pixelColor(plot.placeOf(12).toPoint()), now); // the dot stays where the curve is
        QCOMPARE(shown.pixelColor(ring.toPoint()), fixture.theme.tokens().panel);
        while (run.cursor().phase > 0)
            fixture.session.playback().phaseForward();
        fixture.settle();
        QVERIFY(!plot.insidePlace());
        QVERIFY(plot.sentence().endsWith("at frame 13"));
    }
};

SUITE(tst_plots_painted, PlotsPaintedTest)
#include "tst_plots_painted.moc"

#include "app/ui/scene/layers/stencil.h"
#include "tests/suite.h"

#include <QPainter>
#include <QTest>

#include <cmath>
#include <functional>
#include <numbers>

using namespace app;

/// The painting of a stencil, against the areas of circles and rectangles.
class StencilTest : public QObject
{
    Q_OBJECT

    static constexpr int side = 200; ///< px

    /// How many px of black `draw` puts on white.
    static double inked(const std::function<void(Stencil &)> &draw, double scale = 1.0,
                        const QColor &ink = Qt::black)
    {
        QImage image(qRound(side * scale), qRound(side * scale), QImage::Format_RGB32);
        image.setDevicePixelRatio(scale);
        image.fill(Qt::white);
        Stencil stencil;
        stencil.begin(QRectF(0, 0, side, side), scale);
        draw(stencil);
        QPainter painter(&image);
        stencil.paint(painter, ink);
        painter.end();
        double sum = 0.0;
        for (int y = 0; y < image.height(); ++y) {
            for (int x = 0; x < image.width(); ++x)
                sum += (255 - qGray(image.pixel(x, y))) / 255.0;
        }
        return sum / (scale * scale);
    }

private slots:
    void aDiscCoversItsArea_data();
    void aDiscCoversItsArea();
    void aLineCoversItsArea_data();
    void aLineCoversItsArea();
    void aShortLineIsNotLonger();
    void linesOnTopOfEachOtherCoverEachPixelOnce();
    void shapesOutsideLeaveNoInk();
    void halfOfADiscAtTheEdgeIsThere();
    void aFaintColourIsFaint();
    void stencilStartsEmptyEachTime();
};

void StencilTest::aDiscCoversItsArea_data()
{
    QTest::addColumn<double>("radius");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("scale");
    for (const double radius : {1.5, 3.0, 7.3, 20.0}) {
        for (const double x : {100.0, 100.25, 100.5}) {
            for (const double scale : {1.0, 2.0})
                QTest::addRow("radius %g at %g, scale %g", radius, x, scale) << radius << x << scale;
        }
    }
}

/// Edges are antialiased over one px, which limits the accuracy of the area.
void StencilTest::aDiscCoversItsArea()
{
    QFETCH(double, radius);
    QFETCH(double, x);
    QFETCH(double, scale);
    const double area = inked([&](Stencil &s) { s.addDisc({x, 90.3}, radius); }, scale);
    const double right = std::numbers::pi * radius * radius;
    QVERIFY2(std::abs(area / right - 1.0) < 0.06, qPrintable(QString("%1, not %2").arg(area).arg(right)));
}

void StencilTest::aLineCoversItsArea_data()
{
    QTest::addColumn<double>("width");
    QTest::addColumn<double>("degrees");
    for (const double width : {0.4, 0.8, 1.5, 4.0}) {
        for (const double degrees : {0.0, 17.0, 45.0, 60.0, 90.0, 200.0})
            QTest::addRow("%g px wide, at %g degrees", width, degrees) << width << degrees;
    }
}

/// At 45 degrees a line covers all its pixels in the same way, so errors do not average out.
void StencilTest::aLineCoversItsArea()
{
    QFETCH(double, width);
    QFETCH(double, degrees);
    const double angle = degrees * std::numbers::pi / 180.0;
    const QPointF along(80.0 * std::cos(angle), 80.0 * std::sin(angle));
    const QPointF from(100.2, 99.6);
    const double area = inked([&](Stencil &s) { s.addLine({from, from + along}, width); });
    QVERIFY2(std::abs(area / (80.0 * width) - 1.0) < 0.2, qPrintable(QString::number(area / (80.0 * width))));
}

/// Wherever its ends lie within their px.
void StencilTest::aShortLineIsNotLonger()
{
    for (const double length : {0.3, 0.7, 1.6, 4.2}) {
        for (const double x : {50.0, 50.2, 50.45, 50.8}) {
            const double area = inked([&](Stencil &s) { s.addLine({{x, 40.5}, {x + length, 40.5}}, 0.9); });
            QVERIFY2(std::abs(area - 0.9 * length) < 0.02, qPrintable(QString::number(area / length)));
        }
    }
}

/// Two lines that cover half of a pixel leave a quarter of it. More lines on a fully covered pixel change nothing.
void StencilTest::linesOnTopOfEachOtherCoverEachPixelOnce()
{
    const auto times = [](int count, double width) {
        return inked([&](Stencil &s) {
            for (int i = 0; i < count; ++i)
                s.addLine({{-10.0, 60.5}, {side + 10.0, 60.5}}, width); // along the middles of a row of px
        });
    };
    QVERIFY(std::abs(times(1, 0.5) / side - 0.5) < 0.01);
    QVERIFY(std::abs(times(2, 0.5) / side - 0.75) < 0.01);
    QVERIFY(std::abs(times(1, 1.0) / side - 1.0) < 0.01);
    QVERIFY(std::abs(times(9, 1.0) / side - 1.0) < 0.01);
}

void StencilTest::shapesOutsideLeaveNoInk()
{
    QCOMPARE(inked([](Stencil &s) {
                 s.addDisc({-40.0, 100.0}, 20.0);
                 s.addDisc({100.0, 1e6}, 20.0);
                 s.addDisc({std::nan(""), 10.0}, 20.0);
                 s.addLine({{-50.0, -10.0}, {300.0, -10.0}}, 4.0);
                 s.addLine({{-1e6, 400.0}, {1e6, 500.0}}, 4.0);
                 s.addLine({{210.0, -1e6}, {210.0, 1e6}}, 4.0);
             }),
             0.0);
}

void StencilTest::halfOfADiscAtTheEdgeIsThere()
{
    const double whole = inked([](Stencil &s) { s.addDisc({100.0, 100.0}, 12.0); });
    const double half = inked([](Stencil &s) { s.addDisc({0.0, 100.0}, 12.0); });
    QVERIFY(std::abs(half / whole - 0.5) < 0.01);
    const double crossing = inked([](Stencil &s) { s.addLine({{-1000.0, 50.0}, {1000.0, 50.0}}, 2.0); });
    QVERIFY(std::abs(crossing - 2.0 * side) < 1.0);
}

void StencilTest::aFaintColourIsFaint()
{
    const auto draw = [](Stencil &s) { s.addDisc({100.0, 100.0}, 30.0); };
    QVERIFY(std::abs(inked(draw, 1.0, QColor(0, 0, 0, 102)) / inked(draw) - 0.4) < 0.01);
}

void StencilTest::stencilStartsEmptyEachTime()
{
    QCOMPARE(inked([](Stencil &s) {
                 s.addDisc({100.0, 100.0}, 30.0);
                 s.begin(QRectF(0, 0, side, side), 1.0);
             }),
             0.0);
}

SUITE(tst_stencil, StencilTest)
#include "tst_stencil.moc"

// What the scene view looks at: zoom, moving the picture, signs for bodies outside.

#include "scene_bench.h"

#include <QSignalSpy>
#include <QTemporaryDir>
#include <QtTest>

using namespace app;

class SceneCameraTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { useOwnSettings(m_settings); }
    void theWheelZoomsAroundThePointer();
    void twoFingersMoveThePicture();
    void draggingTheBackgroundMovesThePicture_data();
    void draggingTheBackgroundMovesThePicture();
    void fitShowsTheWholeStage_data();
    void fitShowsTheWholeStage();
    void aStepBeginsWithItsCreatureOrItsRoom_data();
    void aStepBeginsWithItsCreatureOrItsRoom();
    void aSignAtTheEdgeBringsABodyBack();

private:
    QTemporaryDir m_settings;
};

void SceneCameraTest::theWheelZoomsAroundThePointer()
{
    SceneBench bench;
    QSignalSpy zoomed(&bench.view, &SceneView::zoomChanged);
    const QPoint pointer(140, 333);
    const double before = bench.view.zoom();
    const QPointF place = bench.view.viewportTransform().inverted().map(QPointF(pointer));
    for (int i = 0; i < 5; ++i)
        bench.wheel(pointer, {0, 120});
    QCOMPARE(zoomed.count(), 5);
    QVERIFY(bench.view.zoom() > 1.5 * before);
    QVERIFY(QLineF(bench.view.viewportTransform().map(place), pointer).length() < 4.0);
    for (int i = 0; i < 5; ++i)
        bench.wheel(pointer, {0, -120});
    QVERIFY(std::abs(bench.view.zoom() - before) < 1e-6);
}

void SceneCameraTest::twoFingersMoveThePicture()
{
    SceneBench bench;
    const double zoom = bench.view.zoom();
    const QPoint before = bench.onScreen("body");
    bench.wheel({300, 200}, {0, 24}, {30, -18});
    QCOMPARE(bench.view.zoom(), zoom);
    QCOMPARE(bench.onScreen("body") - before, QPoint(30, -18));
}

void SceneCameraTest::draggingTheBackgroundMovesThePicture_data()
{
    QTest::addColumn<int>("button");
    QTest::addColumn<bool>("onBody");
    QTest::newRow("left button on the background") << int(Qt::LeftButton) << false;
    QTest::newRow("middle button on the background") << int(Qt::MiddleButton) << false;
    QTest::newRow("middle button on a body") << int(Qt::MiddleButton) << true;
}

void SceneCameraTest::draggingTheBackgroundMovesThePicture()
{
    QFETCH(int, button);
    QFETCH(bool, onBody);
    SceneBench bench;
    const auto pressed = static_cast<Qt::MouseButton>(button);
    const QPoint before = bench.onScreen("body");
    const QPoint start = onBody ? before : QPoint(40, 100);
    bench.press(start, pressed);
    bench.move(start + QPoint(60, -35), pressed);
    bench.release(start + QPoint(60, -35), pressed);
    QCOMPARE(bench.onScreen("body") - before, QPoint(60, -35));
    QCOMPARE(bench.session.selected(), "foot0");
    QVERIFY(bench.session.timeline().script().input.empty());
}

void SceneCameraTest::fitShowsTheWholeStage_data()
{
    QTest::addColumn<QSize>("size");
    QTest::newRow("the window's") << QSize(600, 470);
    QTest::newRow("small") << QSize(480, 320);
    QTest::newRow("large") << QSize(1300, 900);
}

void SceneCameraTest::fitShowsTheWholeStage()
{
    QFETCH(QSize, size);
    SceneBench bench;
    bench.view.resize(size);
    bench.view.bringBack("foot0");
    bench.view.zoomIn();
    bench.view.fit();
    const QRectF seen =
        bench.view.viewportTransform().inverted().mapRect(QRectF(bench.view.viewport()->rect()));
    QVERIFY(seen.contains(QRectF(0, 0, 540, 400)));
    QVERIFY(seen.width() < 2 * 540 || seen.height() < 1.5 * 400);
}

void SceneCameraTest::aStepBeginsWithItsCreatureOrItsRoom_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QRectF>("seen");
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("most");
    QTest::newRow("a creature, enlarged") << "creature" << QRectF(220, 190, 100, 70) << 180.0 << 260.0;
    QTest::newRow("a whole room") << "room" << QRectF(20, 0, 500, 400) << 50.0 << 150.0;
}

void SceneCameraTest::aStepBeginsWithItsCreatureOrItsRoom()
{
    QFETCH(QString, step);
    QFETCH(QRectF, seen);
    QFETCH(double, least);
    QFETCH(double, most);
    SceneBench bench(qPrintable(step));
    const QRectF view =
        bench.view.viewportTransform().inverted().mapRect(QRectF(bench.view.viewport()->rect()));
    QVERIFY(view.contains(seen));
    QVERIFY(bench.view.zoom() >= least && bench.view.zoom() <= most + 1e-9);
}

void SceneCameraTest::aSignAtTheEdgeBringsABodyBack()
{
    SceneBench bench;
    bench.session.select("foot1");
    bench.view.zoomTo100();
    const QRect view = bench.view.viewport()->rect();
    // Everything goes out of view, to the left.
    bench.press({500, 60}, Qt::MiddleButton);
    bench.move({500 - 2000, 60}, Qt::MiddleButton);
    bench.release({500 - 2000, 60}, Qt::MiddleButton);
    QVERIFY(!view.contains(bench.onScreen("body")));
    const QColor body = bench.theme.tokens().body;
    const QImage picture = bench.image();
    QPoint sign(-1, -1);
    for (int y = 40; y < 420 && sign.x() < 0; ++y) {
        for (int x = 0; x < 60; ++x) {
            if (picture.pixel(x, y) == body.rgb())
                sign = {x, y};
        }
    }
    QVERIFY2(sign.x() >= 0, "no sign at the left edge");
    bench.press(sign);
    bench.release(sign);
    QVERIFY(view.contains(bench.onScreen(qPrintable(bench.session.selected()))));
    QVERIFY(bench.session.timeline().script().input.empty());
}

QTEST_MAIN(SceneCameraTest)
#include "tst_scene_camera.moc"

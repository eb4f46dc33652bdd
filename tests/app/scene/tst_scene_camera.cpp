// The camera of the scene view: zoom, panning, and signs for bodies outside the picture.

#include "tests/app/scene/scene_support.h"
#include "tests/suite.h"

#include <QHelpEvent>
#include <QSignalSpy>
#include <QToolTip>
#include <QtTest>

using namespace app;

class SceneCameraTest : public QObject
{
    Q_OBJECT

private slots:
    void theWheelZoomsAroundThePointer();
    void twoFingersPanTheView();
    void draggingTheBackgroundMovesThePicture_data();
    void draggingTheBackgroundMovesThePicture();
    void fitShowsTheWholeStage_data();
    void fitShowsTheWholeStage();
    void aStepBeginsWithItsCreatureOrItsRoom_data();
    void aStepBeginsWithItsCreatureOrItsRoom();
    void thePictureCannotBeMovedAwayFromAllBodies_data();
    void thePictureCannotBeMovedAwayFromAllBodies();
    void aSignAtTheEdgeIsAnArrowThatSaysWhatAClickDoes();
    void aSignAtTheEdgeBringsABodyBack_data();
    void aSignAtTheEdgeBringsABodyBack();
    void roomIsAtTheBottomOfItsView();
    void insideAFrameASmallCreatureIsEnlarged();
    void legendAndCaptionCoverNoBodyThatHasSwumAway_data();
    void legendAndCaptionCoverNoBodyThatHasSwumAway();
    void aRunBeginsWithItsTargetInView();
    void bodiesThatFlyOffDoNotMakeTheFirstViewSmall_data();
    void bodiesThatFlyOffDoNotMakeTheFirstViewSmall();
};

void SceneCameraTest::theWheelZoomsAroundThePointer()
{
    SceneFixture fixture;
    QSignalSpy zoomed(&fixture.view, &SceneView::zoomChanged);
    const QPoint pointer(140, 333);
    const double before = fixture.view.zoom();
    const QPointF place = fixture.view.viewportTransform().inverted().map(QPointF(pointer));
    for (int i = 0; i < 5; ++i)
        fixture.wheel(pointer, {0, 120});
    QCOMPARE(zoomed.count(), 5);
    QVERIFY(fixture.view.zoom() > 1.5 * before);
    QVERIFY(QLineF(fixture.view.viewportTransform().map(place), pointer).length() < 4.0);
    for (int i = 0; i < 5; ++i)
        fixture.wheel(pointer, {0, -120});
    QVERIFY(std::abs(fixture.view.zoom() - before) < 1e-6);
}

void SceneCameraTest::twoFingersPanTheView()
{
    SceneFixture fixture;
    const double zoom = fixture.view.zoom();
    const QPoint before = fixture.onScreen("body");
    fixture.wheel({300, 200}, {0, 24}, {30, -18});
    QCOMPARE(fixture.view.zoom(), zoom);
    QCOMPARE(fixture.onScreen("body") - before, QPoint(30, -18));
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
    SceneFixture fixture;
    const auto pressed = static_cast<Qt::MouseButton>(button);
    const QPoint before = fixture.onScreen("body");
    const QPoint start = onBody ? before : QPoint(40, 100);
    fixture.press(start, pressed);
    fixture.move(start + QPoint(60, -35), pressed);
    fixture.release(start + QPoint(60, -35), pressed);
    QCOMPARE(fixture.onScreen("body") - before, QPoint(60, -35));
    QCOMPARE(fixture.session.selected(), "foot0");
    QVERIFY(fixture.session.timeline().script().input.empty());
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
    SceneFixture fixture;
    fixture.view.resize(size);
    fixture.view.bringBack("foot0");
    fixture.view.zoomIn();
    fixture.view.fit();
    const QRectF seen =
        fixture.view.viewportTransform().inverted().mapRect(QRectF(fixture.view.viewport()->rect()));
    QVERIFY(seen.contains(QRectF(0, 0, 540, 400)));
    QVERIFY(seen.width() < 2 * 540 || seen.height() < 1.5 * 400);
}

void SceneCameraTest::aStepBeginsWithItsCreatureOrItsRoom_data()
{
    QTest::addColumn<QString>("step");
    QTest::addColumn<QRectF>("seen");
    QTest::addColumn<double>("least");
    QTest::addColumn<double>("most");
    // With room for a hand that carries something 100 px.
    QTest::newRow("a creature, enlarged") << "creature" << QRectF(170, 125, 200, 200) << 120.0 << 260.0;
    QTest::newRow("a whole room") << "room" << QRectF(20, 0, 500, 400) << 50.0 << 150.0;
}

void SceneCameraTest::aStepBeginsWithItsCreatureOrItsRoom()
{
    QFETCH(QString, step);
    QFETCH(QRectF, seen);
    QFETCH(double, least);
    QFETCH(double, most);
    SceneFixture fixture(qPrintable(step));
    const QRectF view =
        fixture.view.viewportTransform().inverted().mapRect(QRectF(fixture.view.viewport()->rect()));
    QVERIFY(view.contains(seen));
    QVERIFY2(fixture.view.zoom() >= least && fixture.view.zoom() <= most + 1e-9,
             qPrintable(QString::number(fixture.view.zoom())));
}

void SceneCameraTest::thePictureCannotBeMovedAwayFromAllBodies_data()
{
    QTest::addColumn<QPoint>("by");
    for (const QPoint by : {QPoint(-4000, 0), QPoint(4000, 0), QPoint(0, 3000), QPoint(-900, -900)})
        QTest::addRow("%d, %d", by.x(), by.y()) << by;
}

void SceneCameraTest::thePictureCannotBeMovedAwayFromAllBodies()
{
    QFETCH(QPoint, by);
    SceneFixture fixture;
    fixture.press({500, 60});
    fixture.move(QPoint(500, 60) + by / 2);
    fixture.move(QPoint(500, 60) + by);
    fixture.release(QPoint(500, 60) + by);
    const QRect view = fixture.view.viewport()->rect();
    int seen = 0;
    for (const char *body : {"foot0", "foot1", "body"})
        seen += view.contains(fixture.onScreen(body)) ? 1 : 0;
    QVERIFY(seen > 0);
    fixture.view.fit();
    for (const char *body : {"foot0", "foot1", "body"})
        QVERIFY(view.contains(fixture.onScreen(body)));
}

namespace {

/// Enlarges `fixture` until foot1 is alone in the picture. Returns where the sign is that points to foot0, at the right.
QRect signOfFoot0(SceneFixture &fixture)
{
    while (fixture.view.zoom() < 800.0)
        fixture.view.zoomIn();
    fixture.view.bringBack("foot1");
    const QImage picture = fixture.image();
    QRect sign;
    for (int y = 40; y < 420; ++y) {
        for (int x = 540; x < 600; ++x) {
            if (picture.pixel(x, y) == fixture.theme.tokens().body.rgb())
                sign |= QRect(x, y, 1, 1);
        }
    }
    return sign;
}

}

void SceneCameraTest::aSignAtTheEdgeIsAnArrowThatSaysWhatAClickDoes()
{
    SceneFixture fixture;
    const QRect sign = signOfFoot0(fixture);
    QVERIFY2(sign.width() > 1.5 * sign.height(), "no arrow to the right");
    fixture.move(sign.center(), Qt::NoButton);
    QCOMPARE(fixture.view.viewport()->cursor().shape(), Qt::PointingHandCursor);
    QHelpEvent help(QEvent::ToolTip, sign.center(), fixture.view.viewport()->mapToGlobal(sign.center()));
    QApplication::sendEvent(fixture.view.viewport(), &help);
    QVERIFY2(QToolTip::text().startsWith("foot 0, "), qPrintable(QToolTip::text()));
    QVERIFY(QToolTip::text().contains("Click"));
}

void SceneCameraTest::aSignAtTheEdgeBringsABodyBack_data()
{
    QTest::addColumn<bool>("byKey");
    QTest::newRow("by a click") << false;
    QTest::newRow("without a mouse") << true;
}

void SceneCameraTest::aSignAtTheEdgeBringsABodyBack()
{
    QFETCH(bool, byKey);
    SceneFixture fixture;
    fixture.session.select("foot1");
    const QRect sign = signOfFoot0(fixture);
    QVERIFY(!sign.isEmpty());
    const QRect view = fixture.view.viewport()->rect();
    QVERIFY(!view.contains(fixture.onScreen("foot0")));
    if (byKey) {
        for (int i = 0; i < 2 && fixture.session.selected() != "foot0"; ++i)
            fixture.view.showNextOutside();
    } else {
        fixture.press(sign.center());
        fixture.release(sign.center());
    }
    QCOMPARE(fixture.session.selected(), "foot0");
    QVERIFY((fixture.onScreen("foot0") - view.center()).manhattanLength() < 6);
    QVERIFY(fixture.session.timeline().script().input.empty());
}

void SceneCameraTest::roomIsAtTheBottomOfItsView()
{
    for (const QSize size : {QSize(600, 470), QSize(600, 900), QSize(1230, 830)}) {
        SceneFixture fixture("room");
        fixture.view.resize(size);
        const auto onScreen = [&](QPointF place) { return fixture.view.viewportTransform().map(place); };
        const double below = size.height() - onScreen({270, 400}).y();
        QVERIFY2(below > 40.0 && below < 60.0, qPrintable(QString::number(below)));
        QVERIFY(onScreen({270, 0}).y() >= 0.0); // all of its height
        const double across = onScreen({520, 0}).x() - onScreen({20, 0}).x();
        const double down = onScreen({0, 400}).y() - onScreen({0, 0}).y();
        QVERIFY(across > 0.85 * size.width() || down > 0.85 * (size.height() - 52.0)); // it fills its view
    }
}

void SceneCameraTest::insideAFrameASmallCreatureIsEnlarged()
{
    SceneFixture fixture("room");
    const QRect view = fixture.view.viewport()->rect();
    const double home = fixture.view.zoom();
    fixture.session.playback().frameForward();
    QCOMPARE(fixture.view.zoom(), home);
    fixture.session.playback().phaseForward();
    const double close = fixture.view.zoom();
    QVERIFY2(close > 1.3 * home && close > 150.0, qPrintable(QString::number(close)));
    for (const char *body : {"foot0", "foot1", "body"}) // with room for arrows
        QVERIFY(view.adjusted(90, 90, -90, -90).contains(fixture.onScreen(body)));
    fixture.session.playback().phaseForward();
    QCOMPARE(fixture.view.zoom(), close);
    fixture.session.playback().play();
    QCOMPARE(fixture.view.zoom(), home);
    fixture.session.playback().pause();
    fixture.view.zoomIn(); // a zoom that a learner chose stays
    const double chosen = fixture.view.zoom();
    fixture.session.playback().phaseForward();
    QCOMPARE(fixture.view.zoom(), chosen);
}

namespace {

/// Returns the step `id` of a lesson of the program, alone.
std::vector<lessons::Step> lessonStep(const QString &of, const QString &id)
{
    static const LessonLibrary library = LessonLibrary::load({LESSON_DIR}); // keeps the plugin loaded
    for (const LessonEntry &lesson : library.lessons) {
        for (const lessons::Step &step : lesson.steps) {
            if (lesson.id == of && step.id == id)
                return {step};
        }
    }
    return {};
}

}

void SceneCameraTest::legendAndCaptionCoverNoBodyThatHasSwumAway_data()
{
    QTest::addColumn<sim::Vec2>("to");
    QTest::newRow("to the right and down") << sim::Vec2{420, 330};
    QTest::newRow("down") << sim::Vec2{200, 360};
    QTest::newRow("up") << sim::Vec2{180, 30};
}

void SceneCameraTest::legendAndCaptionCoverNoBodyThatHasSwumAway()
{
    QFETCH(sim::Vec2, to);
    SceneFixture fixture(lessonStep("codeling", "motor"));
    fixture.session.input().setTarget(to);
    fixture.goTo(100);
    const auto isClear = [&](int above) {
        const double radius = fixture.session.presentation().picture().view->bodies.front().radius *
                              fixture.view.zoom() / 100.0;
        const QRectF view = QRectF(fixture.view.viewport()->rect())
                                .adjusted(20.0 + radius, above + radius, -20.0 - radius, -50.0 - radius);
        return view.contains(fixture.onScreen("lead")); // 50 px: two lines of the legend
    };
    QVERIFY(isClear(20));
    fixture.session.playback().phaseForward(); // a line of text at the top
    QVERIFY(isClear(34));
}

void SceneCameraTest::aRunBeginsWithItsTargetInView()
{
    SceneFixture fixture(lessonStep("codeling", "motor"));
    fixture.session.editor().setParameter("target_x", 400.0);
    QTRY_COMPARE(fixture.session.timeline().state().input.target.x, 400.0);
    const QPointF target = fixture.view.viewportTransform().map(QPointF(400, 200));
    QVERIFY2(QRectF(fixture.view.viewport()->rect()).adjusted(20, 20, -20, -20).contains(target),
             qPrintable(QString::number(target.x())));
}

void SceneCameraTest::bodiesThatFlyOffDoNotMakeTheFirstViewSmall_data()
{
    QTest::addColumn<QString>("step");
    QTest::newRow("springs that contradict") << "contradiction";
    QTest::newRow("too many feet") << "many_feet";
}

void SceneCameraTest::bodiesThatFlyOffDoNotMakeTheFirstViewSmall()
{
    QFETCH(QString, step);
    const SceneFixture fixture(lessonStep("hard_cases", step));
    QVERIFY2(fixture.view.zoom() > 100.0, qPrintable(QString::number(fixture.view.zoom())));
}

SUITE(tst_scene_camera, SceneCameraTest)
#include "tst_scene_camera.moc"

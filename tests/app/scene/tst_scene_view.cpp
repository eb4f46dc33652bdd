// Mouse and keys in the scene.

#include "tests/app/scene/drawn_scenes.h"
#include "tests/app/scene/scene_support.h"
#include "tests/suite.h"

#include <QtTest>

using namespace app;

namespace {

/// The events of a drag, one word each.
QStringList dragEvents(const Session &session)
{
    QStringList all;
    for (const sim::Event &event : session.timeline().script().input) {
        if (std::holds_alternative<sim::Grab>(event.what))
            all << "grab " + QString::fromStdString(std::get<sim::Grab>(event.what).body);
        else if (std::holds_alternative<sim::Move>(event.what))
            all << "move";
        else if (std::holds_alternative<sim::Release>(event.what))
            all << "release";
    }
    return all;
}

}

class SceneViewTest : public QObject
{
    Q_OBJECT

private slots:
    void aDragCarriesTheBodyThatWasPressed();
    void aBodyThatIsLetGoWhileMovingIsThrown();
    void aClickSelectsAndChangesNothing_data();
    void aClickSelectsAndChangesNothing();
    void aPressTakesHoldAtOnceWhileTheRunPlays();
    void draggingABodyStartsThePlaybackAtEitherEndOfTheRun_data();
    void draggingABodyStartsThePlaybackAtEitherEndOfTheRun();
    void recordedPointerOfAReplayIsDrawn();
    void bodiesCanBeGrabbedFromTwelvePixelsAway_data();
    void bodiesCanBeGrabbedFromTwelvePixelsAway();
    void theNearestOfTwoBodiesIsTaken();
    void aBodyUnderAnotherOneIsNotTaken();
    void aHiddenBodyIsNotTaken();
    void escapeFocusLossAndANewStepReleaseTheBody_data();
    void escapeFocusLossAndANewStepReleaseTheBody();
    void theCursorIsAHandOverBodies();
    void bracketsChooseTheNextAndThePreviousBody();
    void altArrowsCarryTheSelectedBody_data();
    void altArrowsCarryTheSelectedBody();
    void keysOfTheWindowAreNotEaten_data();
    void keysOfTheWindowAreNotEaten();
    void theWheelZoomsWhileABodyIsCarried();
    void screenReadersHearThePositionOfTheSelectedBody();
};

void SceneViewTest::aDragCarriesTheBodyThatWasPressed()
{
    SceneFixture fixture;
    const sim::Vec2 before = fixture.place("foot1");
    const QPoint start = fixture.onScreen("foot1") + QPoint(4, -3);
    const double zoom = fixture.view.zoom() / 100.0;
    fixture.press(start);
    fixture.move(start + QPoint(26, 13));
    QVERIFY(fixture.session.input().isHolding());
    fixture.move(start + QPoint(52, 39));
    fixture.release(start + QPoint(52, 39));
    QVERIFY(!fixture.session.input().isHolding());
    QCOMPARE(fixture.session.selected(), "foot1");
    const sim::Vec2 after = fixture.place("foot1");
    // The place under the pointer stays under it: no jump to the middle of the disc.
    QVERIFY(std::abs(after.x - before.x - 52 / zoom) < 1e-9);
    QVERIFY(std::abs(after.y - before.y - 39 / zoom) < 1e-9);
}

void SceneViewTest::aBodyThatIsLetGoWhileMovingIsThrown()
{
    SceneFixture fixture;
    const QPoint start = fixture.onScreen("foot0");
    fixture.press(start);
    for (int i = 1; i <= 4; ++i) {
        fixture.move(start + QPoint(0, -13 * i));
        fixture.session.playback().frameForward();
    }
    fixture.release(start + QPoint(0, -52));
    QCOMPARE(dragEvents(fixture.session),
             QStringList({"grab foot0", "move", "move", "move", "move", "release"}));
    fixture.session.playback().frameForward();
    QVERIFY(fixture.session.timeline().state().velocityOf(0).y < -2.0);
}

void SceneViewTest::aClickSelectsAndChangesNothing_data()
{
    QTest::addColumn<int>("phase");
    QTest::addColumn<QPoint>("slip");
    QTest::newRow("between two frames") << 0 << QPoint(0, 0);
    QTest::newRow("inside a frame") << 2 << QPoint(0, 0);
    QTest::newRow("with a hand that is not quite still") << 2 << QPoint(1, 1);
}

void SceneViewTest::aClickSelectsAndChangesNothing()
{
    QFETCH(int, phase);
    QFETCH(QPoint, slip);
    SceneFixture fixture;
    fixture.session.playback().goTo({3, phase});
    QCOMPARE(fixture.session.selected(), "foot0");
    const QPoint at = fixture.onScreen("body");
    fixture.press(at);
    fixture.move(at + slip);
    fixture.release(at + slip);
    QCOMPARE(fixture.session.selected(), "body");
    QVERIFY(fixture.session.timeline().script().input.empty());
    QCOMPARE(fixture.session.timeline().cursor().phase, phase);
}

void SceneViewTest::aPressTakesHoldAtOnceWhileTheRunPlays()
{
    SceneFixture fixture;
    fixture.session.playback().play();
    fixture.press(fixture.onScreen("body"));
    QVERIFY(fixture.session.input().isHolding());
    fixture.release(fixture.onScreen("body"));
    QVERIFY(!fixture.session.input().isHolding());
    QCOMPARE(dragEvents(fixture.session), QStringList({"grab body", "release"}));
}

void SceneViewTest::draggingABodyStartsThePlaybackAtEitherEndOfTheRun_data()
{
    QTest::addColumn<int>("computed");
    QTest::addColumn<int>("frame");
    QTest::addColumn<int>("phase");
    QTest::addColumn<bool>("starts");
    QTest::newRow("at the start") << 0 << 0 << 0 << true;
    QTest::newRow("at the start of a run that went on") << 20 << 0 << 0 << true;
    QTest::newRow("at the end") << 20 << 20 << 0 << true;
    QTest::newRow("in the past") << 20 << 10 << 0 << false;
    QTest::newRow("inside a frame") << 20 << 20 << 2 << false;
}

void SceneViewTest::draggingABodyStartsThePlaybackAtEitherEndOfTheRun()
{
    QFETCH(int, computed);
    QFETCH(int, frame);
    QFETCH(int, phase);
    QFETCH(bool, starts);
    SceneFixture fixture;
    fixture.goTo(computed);
    fixture.session.playback().goTo({frame, phase});
    const QSignalSpy said(&fixture.session.changes(), &ChangeNotifier::messageRequested);
    const QPoint at = fixture.onScreen("foot0");
    fixture.press(at);
    QVERIFY(!fixture.session.playback().isPlaying()); // a click changes nothing
    fixture.move(at + QPoint(0, 30));
    QCOMPARE(fixture.session.playback().isPlaying(), starts);
    QVERIFY(fixture.session.input().isHolding());
    const bool isTold = std::any_of(said.begin(), said.end(), [&](const QList<QVariant> &one) {
        return one.constFirst().toString().contains(starts ? "The run plays" : "The run is paused");
    });
    QVERIFY(isTold);
    if (starts)
        QTRY_VERIFY(fixture.session.timeline().cursor().frame > frame + 1);
    else
        QCOMPARE(fixture.session.timeline().cursor(), (sim::Cursor{frame, phase}));
    fixture.release(at + QPoint(0, 30));
    fixture.session.playback().pause();
}

void SceneViewTest::recordedPointerOfAReplayIsDrawn()
{
    SceneFixture fixture;
    const auto inked = [&] { return fixture.pixels(fixture.theme.tokens().ink); };
    fixture.goTo(5);
    fixture.session.input().grab("foot0");
    fixture.session.input().moveTo({200, 150});
    fixture.session.playback().frameForward();
    QVERIFY(!fixture.session.input().recordedPointer()); // the learner's own
    fixture.session.input().release();
    fixture.goTo(20);
    QVERIFY(!fixture.session.input().recordedPointer());
    fixture.goTo(6);
    QVERIFY(fixture.session.input().recordedPointer());
    QVERIFY(*fixture.session.input().recordedPointer() == (sim::Vec2{200, 150}));
    QVERIFY(fixture.view.accessibleDescription().contains("hand"));
    const int withPointer = inked();
    fixture.goTo(8);
    QVERIFY(!fixture.session.input().recordedPointer());
    QVERIFY(withPointer > inked() + 20);
}

void SceneViewTest::bodiesCanBeGrabbedFromTwelvePixelsAway_data()
{
    QTest::addColumn<double>("zoom");
    QTest::addColumn<int>("away");
    QTest::addColumn<bool>("reached");
    QTest::newRow("small, within 12 px") << 50.0 << 11 << true;
    QTest::newRow("small, outside of 12 px") << 50.0 << 14 << false;
    QTest::newRow("large, within the disc") << 500.0 << 23 << true;
    QTest::newRow("large, outside of the disc") << 500.0 << 33 << false;
}

void SceneViewTest::bodiesCanBeGrabbedFromTwelvePixelsAway()
{
    QFETCH(double, zoom);
    QFETCH(int, away);
    QFETCH(bool, reached);
    SceneFixture fixture("lone");
    while (fixture.view.zoom() > zoom)
        fixture.view.zoomOut();
    while (fixture.view.zoom() < zoom)
        fixture.view.zoomIn();
    fixture.view.bringBack("foot");
    const QPoint at = fixture.onScreen("foot") + QPoint(away, 0);
    fixture.press(at);
    fixture.move(at + QPoint(20, 0));
    QCOMPARE(fixture.session.input().isHolding(), reached);
}

void SceneViewTest::theNearestOfTwoBodiesIsTaken()
{
    SceneFixture fixture;
    fixture.session.input().grab("foot0");
    fixture.session.input().moveTo(fixture.place("body") + sim::Vec2{14, 0});
    fixture.session.input().release();
    const QPoint between = fixture.onScreen("foot0");
    fixture.press(between - QPoint(2, 0));
    fixture.release(between - QPoint(2, 0));
    QCOMPARE(fixture.session.selected(), "foot0");
    fixture.press(fixture.onScreen("body") - QPoint(4, 0));
    QCOMPARE(fixture.session.selected(), "body");
}

void SceneViewTest::aBodyUnderAnotherOneIsNotTaken()
{
    SceneFixture fixture;
    fixture.session.input().grab("foot0");
    fixture.session.input().moveTo(fixture.place("body") + sim::Vec2{3, 0});
    fixture.session.input().release();
    fixture.press(fixture.onScreen("foot0")); // the body is drawn over it
    QCOMPARE(fixture.session.selected(), "body");
}

void SceneViewTest::aHiddenBodyIsNotTaken()
{
    const sim::Scene scene = scenes::pointsAt({{270, 200}, {320, 240}});
    lessons::View view = drawn_scenes::feetOnly(scene);
    view.bodies[0].shape = lessons::BodyView::Shape::none;
    SceneFixture fixture({drawn_scenes::step("hidden", scene, view)});
    const QPoint hidden = fixture.onScreen("p0");
    fixture.move(hidden, Qt::NoButton);
    QCOMPARE(fixture.view.viewport()->cursor().shape(), Qt::ArrowCursor);
    fixture.press(hidden);
    fixture.move(hidden + QPoint(30, 0));
    QVERIFY(!fixture.session.input().isHolding());
    fixture.release(hidden + QPoint(30, 0));
    const QPoint shown = fixture.onScreen("p1");
    fixture.press(shown);
    fixture.move(shown + QPoint(30, 0));
    QVERIFY(fixture.session.input().isHolding());
    fixture.release(shown + QPoint(30, 0));
}

void SceneViewTest::escapeFocusLossAndANewStepReleaseTheBody_data()
{
    QTest::addColumn<QString>("how");
    QTest::newRow("when Escape is pressed") << "escape";
    QTest::newRow("when the focus goes elsewhere") << "focus";
    QTest::newRow("when another step opens") << "step";
}

void SceneViewTest::escapeFocusLossAndANewStepReleaseTheBody()
{
    QFETCH(QString, how);
    SceneFixture fixture;
    const QPoint start = fixture.onScreen("foot0");
    fixture.press(start);
    fixture.move(start + QPoint(30, 0));
    QVERIFY(fixture.session.input().isHolding());
    if (how == "escape") {
        QTest::keyClick(&fixture.view, Qt::Key_Escape);
    } else if (how == "focus") {
        QFocusEvent out(QEvent::FocusOut, Qt::OtherFocusReason);
        QApplication::sendEvent(&fixture.view, &out);
    } else {
        fixture.session.openStep("scene", "room");
    }
    QVERIFY(!fixture.session.input().isHolding());
    const std::size_t events = fixture.session.timeline().script().input.size();
    fixture.move(start + QPoint(60, 0));
    QCOMPARE(fixture.session.timeline().script().input.size(), events);
}

void SceneViewTest::theCursorIsAHandOverBodies()
{
    SceneFixture fixture;
    const QPoint foot = fixture.onScreen("foot0");
    fixture.move(foot, Qt::NoButton);
    QCOMPARE(fixture.view.viewport()->cursor().shape(), Qt::OpenHandCursor);
    fixture.press(foot);
    QCOMPARE(fixture.view.viewport()->cursor().shape(), Qt::ClosedHandCursor);
    fixture.release(foot);
    fixture.move({10, 200}, Qt::NoButton);
    QCOMPARE(fixture.view.viewport()->cursor().shape(), Qt::ArrowCursor);
}

void SceneViewTest::bracketsChooseTheNextAndThePreviousBody()
{
    SceneFixture fixture;
    QStringList chosen;
    for (const int key : {Qt::Key_BracketRight, Qt::Key_BracketRight, Qt::Key_BracketRight,
                          Qt::Key_BracketLeft, Qt::Key_BracketLeft}) {
        QTest::keyClick(&fixture.view, static_cast<Qt::Key>(key));
        chosen << fixture.session.selected();
    }
    QCOMPARE(chosen, QStringList({"foot1", "body", "foot0", "body", "foot1"}));
}

void SceneViewTest::altArrowsCarryTheSelectedBody_data()
{
    QTest::addColumn<int>("key");
    QTest::addColumn<QPointF>("by");
    QTest::newRow("left") << int(Qt::Key_Left) << QPointF(-10, 0);
    QTest::newRow("right") << int(Qt::Key_Right) << QPointF(10, 0);
    QTest::newRow("up") << int(Qt::Key_Up) << QPointF(0, -10);
    QTest::newRow("down") << int(Qt::Key_Down) << QPointF(0, 10);
}

void SceneViewTest::altArrowsCarryTheSelectedBody()
{
    QFETCH(int, key);
    QFETCH(QPointF, by);
    SceneFixture fixture;
    fixture.session.select("foot1");
    const sim::Vec2 before = fixture.place("foot1");
    QTest::keyClick(&fixture.view, static_cast<Qt::Key>(key), Qt::AltModifier);
    QVERIFY(!fixture.session.input().isHolding());
    const sim::Vec2 after = fixture.place("foot1");
    QCOMPARE(QPointF(after.x - before.x, after.y - before.y), by);
}

void SceneViewTest::keysOfTheWindowAreNotEaten_data()
{
    QTest::addColumn<int>("key");
    QTest::newRow("right") << int(Qt::Key_Right);
    QTest::newRow("down") << int(Qt::Key_Down);
    QTest::newRow("page down") << int(Qt::Key_PageDown);
    QTest::newRow("space") << int(Qt::Key_Space);
    QTest::newRow("escape, with nothing in the hand") << int(Qt::Key_Escape);
}

void SceneViewTest::keysOfTheWindowAreNotEaten()
{
    QFETCH(int, key);
    SceneFixture fixture;
    const QTransform before = fixture.view.viewportTransform();
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
    QApplication::sendEvent(&fixture.view, &event);
    QVERIFY(!event.isAccepted());
    QCOMPARE(fixture.view.viewportTransform(), before);
}

void SceneViewTest::theWheelZoomsWhileABodyIsCarried()
{
    SceneFixture fixture;
    const QPoint start = fixture.onScreen("foot0");
    fixture.press(start);
    fixture.move(start + QPoint(40, 0));
    const double before = fixture.view.zoom();
    fixture.wheel(start + QPoint(40, 0), {0, 120});
    QVERIFY(fixture.view.zoom() > before);
    QVERIFY(fixture.session.input().isHolding());
    fixture.move(start + QPoint(41, 0));
    QVERIFY(QLineF(fixture.onScreen("foot0"), start + QPoint(41, 0)).length() < 4.0);
}

void SceneViewTest::screenReadersHearThePositionOfTheSelectedBody()
{
    SceneFixture fixture;
    QCOMPARE(fixture.view.accessibleDescription(), "foot 0 at (310, 240), at rest");
    fixture.session.select("body");
    QVERIFY(fixture.view.accessibleDescription().startsWith("body at (270, 200)"));
    fixture.session.playback().frameForward();
    QVERIFY(fixture.view.accessibleDescription().contains("moving"));
    fixture.session.playback().phaseForward();
    QVERIFY(fixture.view.accessibleDescription().contains("Inside frame 1"));
}

SUITE(tst_scene_view, SceneViewTest)
#include "tst_scene_view.moc"

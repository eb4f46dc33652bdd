// The hand and the keys of the scene view.

#include "scene_bench.h"

#include <QTemporaryDir>
#include <QtTest>

using namespace app;

namespace {

/// What the hand did, one word an event.
QStringList handEvents(const Session &session)
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
    void initTestCase() { useOwnSettings(m_settings); }
    void aDragCarriesTheBodyThatWasPressed();
    void aBodyThatIsLetGoWhileMovingIsThrown();
    void aClickSelectsAndChangesNothing_data();
    void aClickSelectsAndChangesNothing();
    void aPressTakesHoldAtOnceWhileTheRunPlays();
    void aHandThatTakesSomethingStartsTime_data();
    void aHandThatTakesSomethingStartsTime();
    void theHandOfAReplayedRunIsSeen();
    void theHandReachesTwelvePixels_data();
    void theHandReachesTwelvePixels();
    void theNearestOfTwoBodiesIsTaken();
    void theHandLetsGo_data();
    void theHandLetsGo();
    void theCursorIsAHandOverBodies();
    void bracketsChooseTheNextAndThePreviousBody();
    void altArrowsCarryTheSelectedBody_data();
    void altArrowsCarryTheSelectedBody();
    void keysOfTheWindowAreNotEaten_data();
    void keysOfTheWindowAreNotEaten();
    void theWheelZoomsWhileABodyIsCarried();
    void thePlaceOfTheSelectedBodyIsSaid();

private:
    QTemporaryDir m_settings;
};

void SceneViewTest::aDragCarriesTheBodyThatWasPressed()
{
    SceneBench bench;
    const sim::Vec2 before = bench.place("foot1");
    const QPoint start = bench.onScreen("foot1") + QPoint(4, -3);
    const double zoom = bench.view.zoom() / 100.0;
    bench.press(start);
    bench.move(start + QPoint(26, 13));
    QVERIFY(bench.session.isHolding());
    bench.move(start + QPoint(52, 39));
    bench.release(start + QPoint(52, 39));
    QVERIFY(!bench.session.isHolding());
    QCOMPARE(bench.session.selected(), "foot1");
    const sim::Vec2 after = bench.place("foot1");
    // The place under the pointer stays under it: no jump to the middle of the disc.
    QVERIFY(std::abs(after.x - before.x - 52 / zoom) < 1e-9);
    QVERIFY(std::abs(after.y - before.y - 39 / zoom) < 1e-9);
}

void SceneViewTest::aBodyThatIsLetGoWhileMovingIsThrown()
{
    SceneBench bench;
    const QPoint start = bench.onScreen("foot0");
    bench.press(start);
    for (int i = 1; i <= 4; ++i) {
        bench.move(start + QPoint(0, -13 * i));
        bench.session.frameForward();
    }
    bench.release(start + QPoint(0, -52));
    QCOMPARE(handEvents(bench.session),
             QStringList({"grab foot0", "move", "move", "move", "move", "release"}));
    bench.session.frameForward();
    QVERIFY(bench.session.timeline().state().velocityOf(0).y < -2.0);
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
    SceneBench bench;
    bench.session.goTo({3, phase});
    QCOMPARE(bench.session.selected(), "foot0");
    const QPoint at = bench.onScreen("body");
    bench.press(at);
    bench.move(at + slip);
    bench.release(at + slip);
    QCOMPARE(bench.session.selected(), "body");
    QVERIFY(bench.session.timeline().script().input.empty());
    QCOMPARE(bench.session.timeline().cursor().phase, phase);
}

void SceneViewTest::aPressTakesHoldAtOnceWhileTheRunPlays()
{
    SceneBench bench;
    bench.session.play();
    bench.press(bench.onScreen("body"));
    QVERIFY(bench.session.isHolding());
    bench.release(bench.onScreen("body"));
    QVERIFY(!bench.session.isHolding());
    QCOMPARE(handEvents(bench.session), QStringList({"grab body", "release"}));
}

void SceneViewTest::aHandThatTakesSomethingStartsTime_data()
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

void SceneViewTest::aHandThatTakesSomethingStartsTime()
{
    QFETCH(int, computed);
    QFETCH(int, frame);
    QFETCH(int, phase);
    QFETCH(bool, starts);
    SceneBench bench;
    bench.goTo(computed);
    bench.session.goTo({frame, phase});
    const QSignalSpy said(&bench.session, &Session::said);
    const QPoint at = bench.onScreen("foot0");
    bench.press(at);
    QVERIFY(!bench.session.isPlaying()); // a click changes nothing
    bench.move(at + QPoint(0, 30));
    QCOMPARE(bench.session.isPlaying(), starts);
    QVERIFY(bench.session.isHolding());
    const bool isTold = std::any_of(said.begin(), said.end(), [&](const QList<QVariant> &one) {
        return one.constFirst().toString().contains(starts ? "Time runs" : "Time stands still");
    });
    QVERIFY(isTold);
    if (starts)
        QTRY_VERIFY(bench.session.timeline().cursor().frame > frame + 1);
    else
        QCOMPARE(bench.session.timeline().cursor(), (sim::Cursor{frame, phase}));
    bench.release(at + QPoint(0, 30));
    bench.session.pause();
}

void SceneViewTest::theHandOfAReplayedRunIsSeen()
{
    SceneBench bench;
    const auto inked = [&] { return bench.pixels(bench.theme.tokens().ink); };
    bench.goTo(5);
    bench.session.grab("foot0");
    bench.session.moveHand({200, 150});
    bench.session.frameForward();
    QVERIFY(!bench.session.recordedHand()); // the learner's own
    bench.session.letGo();
    bench.goTo(20);
    QVERIFY(!bench.session.recordedHand());
    bench.goTo(6);
    QVERIFY(bench.session.recordedHand());
    QVERIFY(*bench.session.recordedHand() == (sim::Vec2{200, 150}));
    QVERIFY(bench.view.accessibleDescription().contains("hand"));
    const int withHand = inked();
    bench.session.goTo({8, 0});
    QVERIFY(!bench.session.recordedHand());
    QVERIFY(withHand > inked() + 20);
}

void SceneViewTest::theHandReachesTwelvePixels_data()
{
    QTest::addColumn<double>("zoom");
    QTest::addColumn<int>("away");
    QTest::addColumn<bool>("reached");
    QTest::newRow("small, within 12 px") << 50.0 << 11 << true;
    QTest::newRow("small, outside of 12 px") << 50.0 << 14 << false;
    QTest::newRow("large, within the disc") << 500.0 << 23 << true;
    QTest::newRow("large, outside of the disc") << 500.0 << 33 << false;
}

void SceneViewTest::theHandReachesTwelvePixels()
{
    QFETCH(double, zoom);
    QFETCH(int, away);
    QFETCH(bool, reached);
    SceneBench bench("lone");
    while (bench.view.zoom() > zoom)
        bench.view.zoomOut();
    while (bench.view.zoom() < zoom)
        bench.view.zoomIn();
    bench.view.bringBack("foot");
    const QPoint at = bench.onScreen("foot") + QPoint(away, 0);
    bench.press(at);
    bench.move(at + QPoint(20, 0));
    QCOMPARE(bench.session.isHolding(), reached);
}

void SceneViewTest::theNearestOfTwoBodiesIsTaken()
{
    SceneBench bench;
    bench.session.grab("foot0");
    bench.session.moveHand(bench.place("body") + sim::Vec2{10, 0});
    bench.session.letGo();
    const QPoint between = bench.onScreen("foot0");
    bench.press(between - QPoint(2, 0));
    bench.release(between - QPoint(2, 0));
    QCOMPARE(bench.session.selected(), "foot0");
    bench.press(bench.onScreen("body") - QPoint(4, 0));
    QCOMPARE(bench.session.selected(), "body");
}

void SceneViewTest::theHandLetsGo_data()
{
    QTest::addColumn<QString>("how");
    QTest::newRow("when Escape is pressed") << "escape";
    QTest::newRow("when the focus goes elsewhere") << "focus";
    QTest::newRow("when another step opens") << "step";
}

void SceneViewTest::theHandLetsGo()
{
    QFETCH(QString, how);
    SceneBench bench;
    const QPoint start = bench.onScreen("foot0");
    bench.press(start);
    bench.move(start + QPoint(30, 0));
    QVERIFY(bench.session.isHolding());
    if (how == "escape") {
        QTest::keyClick(&bench.view, Qt::Key_Escape);
    } else if (how == "focus") {
        QFocusEvent out(QEvent::FocusOut, Qt::OtherFocusReason);
        QApplication::sendEvent(&bench.view, &out);
    } else {
        bench.session.openStep("scene", "room");
    }
    QVERIFY(!bench.session.isHolding());
    const std::size_t events = bench.session.timeline().script().input.size();
    bench.move(start + QPoint(60, 0));
    QCOMPARE(bench.session.timeline().script().input.size(), events);
}

void SceneViewTest::theCursorIsAHandOverBodies()
{
    SceneBench bench;
    const QPoint foot = bench.onScreen("foot0");
    bench.move(foot, Qt::NoButton);
    QCOMPARE(bench.view.viewport()->cursor().shape(), Qt::OpenHandCursor);
    bench.press(foot);
    QCOMPARE(bench.view.viewport()->cursor().shape(), Qt::ClosedHandCursor);
    bench.release(foot);
    bench.move({10, 200}, Qt::NoButton);
    QCOMPARE(bench.view.viewport()->cursor().shape(), Qt::ArrowCursor);
}

void SceneViewTest::bracketsChooseTheNextAndThePreviousBody()
{
    SceneBench bench;
    QStringList chosen;
    for (const int key : {Qt::Key_BracketRight, Qt::Key_BracketRight, Qt::Key_BracketRight,
                          Qt::Key_BracketLeft, Qt::Key_BracketLeft}) {
        QTest::keyClick(&bench.view, static_cast<Qt::Key>(key));
        chosen << bench.session.selected();
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
    SceneBench bench;
    bench.session.select("foot1");
    const sim::Vec2 before = bench.place("foot1");
    QTest::keyClick(&bench.view, static_cast<Qt::Key>(key), Qt::AltModifier);
    QVERIFY(!bench.session.isHolding());
    const sim::Vec2 after = bench.place("foot1");
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
    SceneBench bench;
    const QTransform before = bench.view.viewportTransform();
    QKeyEvent event(QEvent::KeyPress, key, Qt::NoModifier);
    QApplication::sendEvent(&bench.view, &event);
    QVERIFY(!event.isAccepted());
    QCOMPARE(bench.view.viewportTransform(), before);
}

void SceneViewTest::theWheelZoomsWhileABodyIsCarried()
{
    SceneBench bench;
    const QPoint start = bench.onScreen("foot0");
    bench.press(start);
    bench.move(start + QPoint(40, 0));
    const double before = bench.view.zoom();
    bench.wheel(start + QPoint(40, 0), {0, 120});
    QVERIFY(bench.view.zoom() > before);
    QVERIFY(bench.session.isHolding());
    bench.move(start + QPoint(41, 0));
    QVERIFY(QLineF(bench.onScreen("foot0"), start + QPoint(41, 0)).length() < 4.0);
}

void SceneViewTest::thePlaceOfTheSelectedBodyIsSaid()
{
    SceneBench bench;
    QCOMPARE(bench.view.accessibleDescription(), "foot 0 at (310, 240), at rest");
    bench.session.select("body");
    QVERIFY(bench.view.accessibleDescription().startsWith("body at (270, 200)"));
    bench.session.frameForward();
    QVERIFY(bench.view.accessibleDescription().contains("moving"));
    bench.session.phaseForward();
    QVERIFY(bench.view.accessibleDescription().contains("Inside frame 1"));
}

QTEST_MAIN(SceneViewTest)
#include "tst_scene_view.moc"

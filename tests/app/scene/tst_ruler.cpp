// Measuring in the picture: lengths, angles, the time and all forces.

#include "tests/app/scene/scene_support.h"

#include "app/ui/scene/scene_bar.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace app;

class RulerTest : public QObject
{
    Q_OBJECT

private slots:
    void lengthAndAngleAreThoseOfTheTriangle_data();
    void lengthAndAngleAreThoseOfTheTriangle();
    void theMouseMovesOneEnd();
    void keysMoveEitherEnd();
    void aRulerThatIsNotShownTakesNoPress();
    void allForcesAreShownBetweenTwoFrames();
    void theClockTellsFramesAndSeconds();
};

void RulerTest::lengthAndAngleAreThoseOfTheTriangle_data()
{
    QTest::addColumn<QPointF>("to");
    QTest::addColumn<double>("length");
    QTest::addColumn<double>("angle");
    QTest::newRow("right") << QPointF(5, 0) << 5.0 << 0.0;
    QTest::newRow("up: y points down") << QPointF(0, -2) << 2.0 << 90.0;
    QTest::newRow("down") << QPointF(0, 2) << 2.0 << -90.0;
    QTest::newRow("3, 4, 5") << QPointF(3, -4) << 5.0 << 53.13010235415598;
    QTest::newRow("no length") << QPointF(0, 0) << 0.0 << 0.0;
}

void RulerTest::lengthAndAngleAreThoseOfTheTriangle()
{
    QFETCH(const QPointF, to);
    QFETCH(const double, length);
    QFETCH(const double, angle);
    const Ruler ruler{{10.0, 20.0}, {10.0 + to.x(), 20.0 + to.y()}};
    QCOMPARE(ruler.length(), length);
    QVERIFY(std::abs(ruler.angle() - angle) < 1e-12);
}

namespace {

SceneFixture &withRuler(SceneFixture &fixture)
{
    Extras extras = fixture.view.extras();
    extras.ruler = true;
    fixture.view.setExtras(extras);
    return fixture;
}

QPoint endOf(const SceneFixture &fixture, sim::Vec2 end)
{
    return fixture.view.viewportTransform().map(QPointF(end.x, end.y)).toPoint();
}

}

void RulerTest::theMouseMovesOneEnd()
{
    SceneFixture fixture;
    withRuler(fixture);
    const Ruler before = fixture.view.shown().ruler;
    const QPoint from = endOf(fixture, before.to);
    fixture.press(from);
    fixture.move(from + QPoint(30, 40));
    fixture.release(from + QPoint(30, 40));
    const Ruler after = fixture.view.shown().ruler;
    const double zoom = fixture.view.zoom() / 100.0;
    QCOMPARE(after.from.x, before.from.x);
    QVERIFY(std::abs(after.to.x - before.to.x - 30.0 / zoom) < 1.0 / zoom); // presses count whole px
    QVERIFY(std::abs(after.to.y - before.to.y - 40.0 / zoom) < 1.0 / zoom);
    QVERIFY(!fixture.session.input().isHolding());
}

void RulerTest::keysMoveEitherEnd()
{
    SceneFixture fixture;
    withRuler(fixture);
    const Ruler before = fixture.view.shown().ruler;
    QTest::keyClick(&fixture.view, Qt::Key_Up, Qt::ControlModifier | Qt::AltModifier);
    QTest::keyClick(&fixture.view, Qt::Key_Left, Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier);
    const Ruler after = fixture.view.shown().ruler;
    QCOMPARE(after.to.y, before.to.y - 5.0);
    QCOMPARE(after.to.x, before.to.x);
    QCOMPARE(after.from.x, before.from.x - 5.0);
}

void RulerTest::aRulerThatIsNotShownTakesNoPress()
{
    SceneFixture fixture;
    withRuler(fixture);
    const Ruler before = fixture.view.shown().ruler;
    Extras extras = fixture.view.extras();
    extras.ruler = false;
    fixture.view.setExtras(extras);
    const QPoint from = endOf(fixture, before.to);
    fixture.press(from);
    fixture.move(from + QPoint(30, 40));
    fixture.release(from + QPoint(30, 40));
    QCOMPARE(fixture.view.shown().ruler.to.x, before.to.x);
}

void RulerTest::allForcesAreShownBetweenTwoFrames()
{
    SceneFixture fixture;
    fixture.goTo(12);
    QVERIFY(fixture.view.shown().gathered.empty());
    Extras extras = fixture.view.extras();
    extras.pulls = true;
    fixture.view.setExtras(extras);
    const std::vector<sim::ForceSnapshot> &pulls = fixture.view.shown().gathered;
    QCOMPARE(pulls.size(), std::size_t(2)); // springs and gravity
    const auto gravity = std::find_if(pulls.begin(), pulls.end(), [](const sim::ForceSnapshot &pull) {
        return pull.effect->kind() == sim::EffectKind::gravity;
    });
    QVERIFY(gravity != pulls.end());
    for (Eigen::Index point = 0; point < gravity->acceleration.rows(); ++point) {
        QCOMPARE(gravity->acceleration(point, 0), 0.0);
        QVERIFY(gravity->acceleration(point, 1) > 0.0); // straight down
    }
    fixture.session.playback().phaseForward(); // inside the frame it is what has been gathered so far
    QVERIFY(!fixture.view.shown().pullsAreAll);
    QCOMPARE(fixture.view.shown().gathered.size(), std::size_t(1));
}

void RulerTest::theClockTellsFramesAndSeconds()
{
    SceneFixture fixture;
    fixture.goTo(45);
    QVERIFY(fixture.view.shown().clock.contains("45"));
    QVERIFY(fixture.view.shown().clock.contains(QLocale().toString(1.5, 'f', 2))); // 30 frames a second
    const int before = fixture.pixels(fixture.theme.tokens().ink);
    Extras extras = fixture.view.extras();
    extras.clock = true;
    fixture.view.setExtras(extras);
    QVERIFY(fixture.pixels(fixture.theme.tokens().ink) > before);
}

SUITE(tst_ruler, RulerTest)
#include "tst_ruler.moc"

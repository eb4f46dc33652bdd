// What a learner measures in the picture: lengths and angles, the time, and all that pulls.

#include "scene_bench.h"

#include "app/ui/scene/scene_bar.h"

#include <QTest>

#include <cmath>

using namespace app;

class RulerTest : public QObject
{
    Q_OBJECT

private slots:
    void initTestCase() { useOwnSettings(m_folder); }
    void lengthAndAngleAreThoseOfTheTriangle_data();
    void lengthAndAngleAreThoseOfTheTriangle();
    void theMouseMovesOneEnd();
    void keysMoveEitherEnd();
    void aRulerThatIsNotShownTakesNoPress();
    void betweenTwoFramesAllThatPullsIsShown();
    void theClockTellsFramesAndSeconds();

private:
    QTemporaryDir m_folder;
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

SceneBench &withRuler(SceneBench &bench)
{
    Extras extras = bench.view.extras();
    extras.ruler = true;
    bench.view.setExtras(extras);
    return bench;
}

QPoint endOf(const SceneBench &bench, sim::Vec2 end)
{
    return bench.view.viewportTransform().map(QPointF(end.x, end.y)).toPoint();
}

}

void RulerTest::theMouseMovesOneEnd()
{
    SceneBench bench;
    withRuler(bench);
    const Ruler before = bench.view.shown().ruler;
    const QPoint from = endOf(bench, before.to);
    bench.press(from);
    bench.move(from + QPoint(30, 40));
    bench.release(from + QPoint(30, 40));
    const Ruler after = bench.view.shown().ruler;
    const double zoom = bench.view.zoom() / 100.0;
    QCOMPARE(after.from.x, before.from.x);
    QVERIFY(std::abs(after.to.x - before.to.x - 30.0 / zoom) < 1.0 / zoom); // presses count whole px
    QVERIFY(std::abs(after.to.y - before.to.y - 40.0 / zoom) < 1.0 / zoom);
    QVERIFY(!bench.session.isHolding());
}

void RulerTest::keysMoveEitherEnd()
{
    SceneBench bench;
    withRuler(bench);
    const Ruler before = bench.view.shown().ruler;
    QTest::keyClick(&bench.view, Qt::Key_Up, Qt::ControlModifier | Qt::AltModifier);
    QTest::keyClick(&bench.view, Qt::Key_Left, Qt::ControlModifier | Qt::AltModifier | Qt::ShiftModifier);
    const Ruler after = bench.view.shown().ruler;
    QCOMPARE(after.to.y, before.to.y - 5.0);
    QCOMPARE(after.to.x, before.to.x);
    QCOMPARE(after.from.x, before.from.x - 5.0);
}

void RulerTest::aRulerThatIsNotShownTakesNoPress()
{
    SceneBench bench;
    withRuler(bench);
    const Ruler before = bench.view.shown().ruler;
    Extras extras = bench.view.extras();
    extras.ruler = false;
    bench.view.setExtras(extras);
    const QPoint from = endOf(bench, before.to);
    bench.press(from);
    bench.move(from + QPoint(30, 40));
    bench.release(from + QPoint(30, 40));
    QCOMPARE(bench.view.shown().ruler.to.x, before.to.x);
}

void RulerTest::betweenTwoFramesAllThatPullsIsShown()
{
    SceneBench bench;
    bench.goTo(12);
    QVERIFY(bench.view.shown().gathered.empty());
    Extras extras = bench.view.extras();
    extras.pulls = true;
    bench.view.setExtras(extras);
    const std::vector<sim::ForceSnapshot> &pulls = bench.view.shown().gathered;
    QCOMPARE(pulls.size(), std::size_t(2)); // springs and gravity
    for (const sim::ForceSnapshot &pull : pulls) {
        if (pull.effect->kind() != sim::EffectKind::gravity)
            continue;
        for (Eigen::Index point = 0; point < pull.acceleration.rows(); ++point) {
            QCOMPARE(pull.acceleration(point, 0), 0.0);
            QVERIFY(pull.acceleration(point, 1) > 0.0); // straight down
        }
    }
    bench.session.phaseForward(); // inside the frame it is what has been gathered so far, as ever
    QVERIFY(!bench.view.shown().pullsAreAll);
    QVERIFY(bench.view.shown().gathered.size() <= 1);
}

void RulerTest::theClockTellsFramesAndSeconds()
{
    SceneBench bench;
    bench.goTo(45);
    QVERIFY(bench.view.shown().clock.contains("45"));
    QVERIFY(bench.view.shown().clock.contains(QLocale().toString(1.5, 'f', 2))); // 30 frames a second
    const int before = bench.pixels(bench.theme.tokens().ink);
    Extras extras = bench.view.extras();
    extras.clock = true;
    bench.view.setExtras(extras);
    QVERIFY(bench.pixels(bench.theme.tokens().ink) > before);
}

QTEST_MAIN(RulerTest)
#include "tst_ruler.moc"

#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "sim/run/track.h"
#include "tests/lessons/support/support.h"

#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

#include <array>
#include <cmath>
#include <numbers>

using namespace support;
using std::numbers::pi;

/// Step `ground` of the lesson on walking: the creature walks, because planted feet have traction.
class WalkingGround : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("walking_gait"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    /// Returns whether the method of the row has order 1, like the one behind the numbers in the texts.
    static bool hasOrderOfTheTexts()
    {
        QFETCH(QString, method);
        return sim::findMethod(method.toStdString())->order() == 1;
    }

    sim::Script scriptOfRow(const char *id, double h, const Changes &changes = {}) const
    {
        QFETCH(QString, method);
        return scriptOf(step(id), method.toStdString(), h, changes);
    }

    /// Returns the mean velocity of the body in px/frame, over gait cycles 11 to 20.
    static double meanVelocity(const sim::Script &script)
    {
        const double cycle = 2.0 * pi / std::abs(script.values["speed"]);
        const auto from = std::llround(10.0 * cycle), to = std::llround(20.0 * cycle);
        sim::Track track(script, 0);
        track.seek({from, 0});
        const double before = track.state().positionOf(2).x;
        track.seek({to, 0});
        return (track.state().positionOf(2).x - before) / double(to - from);
    }

    /// Returns the mean of a measure of step `ground` over frames 601 to 1200, without values that are not
    /// finite.
    double meanMeasure(const char *name, const sim::Script &script) const;

private slots:
    void signOfTheSpeedSetsTheDirection_data();
    void signOfTheSpeedSetsTheDirection();
    void leftAndRightAreMirrorImages();
    void creatureDoesNotAdvanceWithoutTraction_data() { addWalkingMethodRows(); }
    void creatureDoesNotAdvanceWithoutTraction();
    void slipIsProportionalToTheStep_data() { addWalkingMethodRows(); }
    void slipIsProportionalToTheStep();
    void groundStopsOrReflectsFeet_data();
    void groundStopsOrReflectsFeet();
    void onlyFeetTouchTheGround();
};

double WalkingGround::meanMeasure(const char *name, const sim::Script &script) const
{
    for (const lessons::Measure &measure : step("ground").measures) {
        if (measure.name != QString::fromUtf8(name))
            continue;
        sim::Track track(script, 0);
        track.seek({600, 0});
        double sum = 0.0;
        int count = 0;
        for (int frame = 601; frame <= 1200; ++frame) {
            const sim::State before = track.state();
            track.seek({frame, 0});
            const double now =
                measure.of(track.interval().scene, track.state(), &before, track.interval().values);
            sum += std::isfinite(now) ? now : 0.0;
            count += std::isfinite(now);
        }
        return sum / count;
    }
    return NAN;
}

void WalkingGround::signOfTheSpeedSetsTheDirection_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("minVelocity");
    for (const sim::MethodPtr &method : walkingMethods()) {
        for (const auto &[speed, minVelocity] :
             {std::pair{0.02, 0.4}, {0.05, 1.1}, {0.1, 2.4}, {0.15, 3.5}}) {
            for (double sign : {1.0, -1.0})
                QTest::addRow("%s, speed %g", method->id().c_str(), sign * speed)
                    << QString::fromStdString(method->id()) << sign * speed << sign * minVelocity;
        }
    }
}

void WalkingGround::signOfTheSpeedSetsTheDirection()
{
    QFETCH(double, speed);
    QFETCH(double, minVelocity);
    const double velocity = meanVelocity(scriptOfRow("ground", 1.0, {{"speed", speed}}));
    QVERIFY2(velocity * speed > 0.0 && std::abs(velocity) > std::abs(minVelocity),
             qPrintable(QString::number(velocity)));
    if (std::abs(speed) == 0.05 && hasOrderOfTheTexts()) // the text: about 150 px per gait cycle
        QVERIFY(std::abs(std::abs(velocity) * 2.0 * pi / 0.05 - 150.0) < 8.0);
}

void WalkingGround::leftAndRightAreMirrorImages()
{
    const auto after = [&](double speed) {
        return stateAfter(scriptOf(step("ground"), "published", 1.0, {{"speed", speed}}), 400);
    };
    const sim::State right = after(0.05), left = after(-0.05);
    const std::array<int, 3> mirrored = {1, 0, 2};
    for (int i = 0; i < 3; ++i) {
        const sim::Vec2 toTheRight = right.positionOf(i),
                        toTheLeft = left.positionOf(mirrored[static_cast<std::size_t>(i)]);
        QVERIFY(std::abs(toTheRight.x - 270.0 + toTheLeft.x - 270.0) < 1e-8 &&
                std::abs(toTheRight.y - toTheLeft.y) < 1e-8);
    }
}

/// On ice no horizontal external force acts, so the centre of mass stays.
void WalkingGround::creatureDoesNotAdvanceWithoutTraction()
{
    const sim::State state = stateAfter(scriptOfRow("ground", 1.0, {{"traction", 1.0}}), 3000);
    QVERIFY(std::abs(state.position.col(0).mean() - 270.0) < 1e-8);
    QVERIFY(std::abs(state.positionOf(2).x - 270.0) < 1.0);
    const double distance = stateAfter(scriptOfRow("ground", 1.0), 3000).positionOf(2).x - 270.0;
    QVERIFY(distance > 3000.0);
}

void WalkingGround::slipIsProportionalToTheStep()
{
    const auto slip = [&](double h) { return meanMeasure("Slip", scriptOfRow("ground", h)); };
    if (hasOrderOfTheTexts()) {
        const double fullStepSlip = slip(1.0);
        QVERIFY2(fullStepSlip > 0.35 && fullStepSlip < 0.5, qPrintable(QString::number(fullStepSlip)));
        QVERIFY(std::abs(slip(0.5) - 0.25) < 0.01); // this and the next two numbers are in the text
        QVERIFY(std::abs(meanVelocity(scriptOfRow("ground", 1.0)) - 1.2) < 0.05);
        QVERIFY(std::abs(meanVelocity(scriptOfRow("ground", 0.5)) - 1.4) < 0.05);
    }
    const OrderRange order = observedOrders(slip, 0, 4);
    QVERIFY2(order.min > 0.8 && order.max < 1.2, qPrintable(u"%1 to %2"_qs.arg(order.min).arg(order.max)));
}

void WalkingGround::groundStopsOrReflectsFeet_data()
{
    QTest::addColumn<double>("bounce");
    QTest::addColumn<double>("traction");
    QTest::addColumn<sim::Vec2>("after");
    QTest::newRow("as published") << 0.0 << 0.0 << sim::Vec2{0, 0};
    QTest::newRow("bounce 1") << 1.0 << 0.0 << sim::Vec2{0, -8};
    QTest::newRow("bounce 0.25") << 0.25 << 0.0 << sim::Vec2{0, -2};
    QTest::newRow("ice") << 0.0 << 1.0 << sim::Vec2{3, 0};
    QTest::newRow("ice, bounce 0.5") << 0.5 << 1.0 << sim::Vec2{3, -4};
}

void WalkingGround::groundStopsOrReflectsFeet()
{
    QFETCH(double, bounce);
    QFETCH(double, traction);
    QFETCH(sim::Vec2, after);
    sim::Script script =
        scriptOf(step("ground"), "published", 1.0,
                 {{"bounce", bounce}, {"traction", traction}, {"k", 0.0}, {"gravity", 0.0}, {"damp", 1.0}});
    script.bodies = {{"foot0", {{220, 395}, sim::Vec2{3, 8}}}, {"foot1", {{320, 392}, sim::Vec2{3, 8}}}};
    const sim::State state = stateAfter(script, 1);
    QCOMPARE(state.positionOf(0), (sim::Vec2{223, 400}));
    QCOMPARE(state.velocityOf(0), after);
    QVERIFY(!std::signbit(state.velocityOf(0).x) && (after.y != 0.0 || !std::signbit(state.velocityOf(0).y)));
    QCOMPARE(state.positionOf(1), (sim::Vec2{323, 400})); // touches the ground and is not below it
    QCOMPARE(state.velocityOf(1), (sim::Vec2{3, 8}));
}

void WalkingGround::onlyFeetTouchTheGround()
{
    sim::Script script = scriptOf(step("ground"), "published", 1.0, {{"k", 0.0}});
    const sim::State fallen = stateAfter(script, 200);
    QVERIFY(fallen.positionOf(0).y == 400.0 && fallen.positionOf(1).y == 400.0 &&
            fallen.positionOf(2).y > 600.0);
    script.input = {{5, sim::Grab{"foot0"}}, {5, sim::Move{{200, 450}}}};
    QCOMPARE(stateAfter(script, 50).positionOf(0), (sim::Vec2{200, 450}));
}

SUITE(tst_walking_ground, WalkingGround)
#include "tst_walking_ground.moc"

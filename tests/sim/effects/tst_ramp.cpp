// A ramp: its geometry, and bodies that slide and bounce on it, against closed forms.

#include "tests/sim/support/support.h"

#include "sim/effects/contacts/ramp.h"
#include "sim/effects/fields/gravity.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

#include <numbers>

using namespace sim;

namespace {

constexpr double rampGravity = 0.5; ///< px/frame^2

/// Returns a ball of width 10 px, `height` px above a ramp through (0, 0), with gravity.
Scene ballOn(double angle, double bounce, double height, Vec2 v)
{
    const Incline edge = inclineOf({0.0, 0.0}, angle, bounce);
    Scene scene = scenes::onePoint("ball", (5.0 + height) * edge.normal, v);
    scene.effects = {std::make_shared<Gravity>(rampGravity),
                     std::make_shared<Ramp>(edge, Eigen::ArrayXd::Constant(1, 5.0))};
    return scene;
}

State stateAfter(const Scene &scene, const Method &method, double h, int frames)
{
    Script script = support::script(scene, method.id());
    script.step = support::stepFor(method, h);
    Timeline run(script);
    run.seek({frames, 0});
    return run.state();
}

}

class TestRamp : public QObject
{
    Q_OBJECT

private slots:
    void bodiesAreKeptOnTheFreeSide_data()
    {
        QTest::addColumn<double>("angle");
        QTest::addColumn<PointMotion>("before");
        QTest::addColumn<PointMotion>("after");
        const auto row = [](const char *name, double angle, PointMotion before, PointMotion after) {
            QTest::newRow(name) << angle << before << after;
        };
        row("above a level ramp", 0, {{70, 90}, {3, 4}}, {{70, 90}, {3, 4}});
        row("below a level ramp", 0, {{70, 100}, {3, 4}}, {{70, 95}, {3, -2}});
        row("already moving away", 0, {{70, 100}, {3, -4}}, {{70, 95}, {3, -4}});
        row("a wall on the right", 90, {{70, 70}, {3, 4}}, {{45, 70}, {-1.5, 4}});
        row("a wall on the left", -90, {{30, 70}, {-3, 4}}, {{55, 70}, {1.5, 4}});
        row("a ceiling", 180, {{70, 20}, {3, -4}}, {{70, 105}, {3, 2}});
        const double root = std::numbers::sqrt2;
        row("rising to the right", 45, {{50, 100}, {1, 1}},
            {{50 - 2.5 * root, 100 - 2.5 * root}, {-0.5, -0.5}});
        row("falling to the right", -45, {{50, 100}, {-1, 1}},
            {{50 + 2.5 * root, 100 - 2.5 * root}, {0.5, -0.5}});
    }
    void bodiesAreKeptOnTheFreeSide()
    {
        QFETCH(double, angle);
        QFETCH(PointMotion, before);
        QFETCH(PointMotion, after);
        State state = State::ofPoints(2);
        for (const int point : {0, 1}) {
            state.place(point, before.x);
            state.setVelocity(point, before.v);
        }
        state.inverseMass[1] = 0.0;
        const Ramp ramp(inclineOf({50, 100}, angle, 0.5), Eigen::ArrayXd::Constant(2, 5.0));
        QCOMPARE(ramp.count(state, {0, 2}), 1);
        ramp.resolve(state, {0, 2});
        QVERIFY(length(state.positionOf(0) - after.x) < 1e-12);
        QVERIFY(length(state.velocityOf(0) - after.v) < 1e-12);
        QVERIFY(state.positionOf(1) == before.x); // held bodies have no contacts
    }

    /// The acceleration along the ramp is g sin(angle).
    void slidingBallMatchesTheClosedForm_data()
    {
        QTest::addColumn<double>("angle");
        for (const double angle : {20.0, -35.0, 70.0})
            QTest::addRow("%g degrees", angle) << angle;
    }
    void slidingBallMatchesTheClosedForm()
    {
        QFETCH(double, angle);
        constexpr int frames = 60;
        const Scene scene = ballOn(angle, 0.0, 0.0, {0, 0});
        const double rad = angle / 180.0 * std::numbers::pi;
        const double pull = rampGravity * std::sin(rad);
        const Vec2 down{-std::cos(rad), std::sin(rad)};
        int methods = 0;
        for (const MethodPtr &method : allMethods()) {
            if (!support::fits(scene, *method))
                continue;
            const bool isAdaptive = method->stepping() == Stepping::adaptive;
            constexpr double h = 0.25;
            const State end = stateAfter(scene, *method, h, frames);
            const Vec2 displacement = end.positionOf(0) - scene.start.positionOf(0);
            const double slid = displacement.x * down.x + displacement.y * down.y;
            const double offAxis = displacement.x * down.y - displacement.y * down.x;
            // First-order methods are off by at most half a step, pull t h / 2.
            const double tolerance = isAdaptive ? 0.01 : std::abs(pull) * frames * h / 2.0 + 1e-9;
            QVERIFY2(std::abs(slid - 0.5 * pull * frames * frames) <= tolerance, method->id().c_str());
            QVERIFY2(std::abs(offAxis) < (isAdaptive ? 0.01 : 1e-9), method->id().c_str());
            ++methods;
        }
        QVERIFY(methods >= 10);
    }

    void elasticBounceConservesEnergy_data()
    {
        QTest::addColumn<double>("angle");
        for (const double angle : {0.0, 20.0, -35.0})
            QTest::addRow("%g degrees", angle) << angle;
    }
    void elasticBounceConservesEnergy()
    {
        QFETCH(double, angle);
        const Scene scene = ballOn(angle, 1.0, 40.0, {0.7, -1.0});
        const auto energy = [](const State &state) {
            const Vec2 v = state.velocityOf(0);
            return 0.5 * (v.x * v.x + v.y * v.y) - rampGravity * state.positionOf(0).y;
        };
        for (const char *id : {"dormand_prince", "dop853"}) {
            const MethodPtr method = findMethod(id);
            double minDistance = 1e9;
            for (const int frames : {10, 35, 60, 90}) {
                const State end = stateAfter(scene, *method, 0.01, frames);
                QVERIFY2(std::abs(energy(end) - energy(scene.start)) < 0.01, id);
                const Vec2 normal = inclineOf({0, 0}, angle, 1.0).normal;
                minDistance =
                    std::min(minDistance, end.positionOf(0).x * normal.x + end.positionOf(0).y * normal.y);
            }
            QVERIFY(minDistance > 5.0 - 1e-3);
        }
    }
};

SUITE(tst_ramp, TestRamp)
#include "tst_ramp.moc"

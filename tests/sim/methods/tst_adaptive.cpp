// Adaptive methods against closed forms: order, tolerance and contact events. Also checks that a step
// computed ahead does not change later input.

#include "sim/pipeline/pipeline.h"
#include "tests/sim/support/support.h"

#include "sim/base/error.h"
#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"

#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;

namespace {

Scene onePoint(Vec2 x, Vec2 v, std::vector<EffectPtr> effects)
{
    Scene scene = scenes::onePoint("ball", x, v);
    scene.effects = std::move(effects);
    return scene;
}

const QStringList ids = {"dormand_prince", "rkn86", "dop853"};

/// Returns the states of all frames of a run with `tolerance` px, including the start.
std::vector<State> run(const Scene &scene, const std::string &method, double tolerance, int frames)
{
    const MethodPtr rule = findMethod(method);
    Scene prepared = scene;
    rule->prepareState(prepared.start);
    const Pipeline pipeline = compose(prepared, *rule, StepSize::withTolerance(tolerance));
    std::vector<State> all = {prepared.start};
    for (int frame = 1; frame <= frames; ++frame) {
        all.push_back(all.back());
        all.back().frame = frame;
        for (const Phase &phase : pipeline.phases)
            phase.run(all.back());
    }
    return all;
}

/// A ball that falls from rest onto a floor.
struct FallingBall
{
    double gravity; ///< px/frame^2
    double height;  ///< px, initial height above the floor
    double bounce;  ///< share of the speed that a bounce keeps
    /// Returns the height after `t` frames, px: parabola after parabola.
    double at(double t) const
    {
        double speed = std::sqrt(2 * gravity * height), since = t - speed / gravity;
        if (since < 0)
            return height - gravity * t * t / 2;
        for (;;) {
            speed *= bounce;
            const double flightTime = 2 * speed / gravity;
            if (since < flightTime || flightTime < 1e-9)
                return std::max(0.0, speed * since - gravity * since * since / 2);
            since -= flightTime;
        }
    }
};

}

class TestAdaptive : public QObject
{
    Q_OBJECT

private:
    static void addAdaptiveRows()
    {
        QTest::addColumn<QString>("method");
        for (const QString &id : ids)
            QTest::newRow(qPrintable(id)) << id;
    }

private slots:
    void dampedSpringMeetsTheTolerance_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("damp");
        QTest::addColumn<double>("tolerance");
        for (const QString &id : ids) {
            for (const double damp : {1.0, 0.9, 0.3}) {
                for (const double tolerance : {1e-2, 1e-5, 1e-8, 1e-11})
                    QTest::addRow("%s, damp %g, %g px", qPrintable(id), damp, tolerance)
                        << id << damp << tolerance;
            }
        }
    }
    void dampedSpringMeetsTheTolerance()
    {
        QFETCH(QString, method);
        QFETCH(double, damp);
        QFETCH(double, tolerance);
        const Scene scene =
            onePoint({100, -40}, {3, 8},
                     {std::make_shared<PointSpring>(0, Vec2{0, 0}, 0.2), std::make_shared<Damping>(damp)});
        const std::vector<State> all = run(scene, method.toStdString(), tolerance, 100);
        for (std::size_t frame = 0; frame < all.size(); ++frame) {
            const double t = double(frame);
            // At worst the errors of some hundred steps add up. Rounding adds a little.
            const double bound = 300 * tolerance + 1e-10;
            QVERIFY(std::abs(all[frame].positionOf(0).x - support::dampedOscillation(100, 3, 0.2, damp, t)) <
                    bound);
            QVERIFY(std::abs(all[frame].positionOf(0).y - support::dampedOscillation(-40, 8, 0.2, damp, t)) <
                    bound);
        }
        QVERIFY(all.back().pointEvaluations > 0);
    }

    void errorFallsWithTheOrderOfTheMethod_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("coarse");
        QTest::addColumn<double>("fine");
        QTest::newRow("Dormand-Prince") << "dormand_prince" << 1e-6 << 1e-10;
        QTest::newRow("DOP853") << "dop853" << 1e-5 << 1e-9;
        QTest::newRow("Nystrom") << "rkn86" << 1e-5 << 1e-9;
    }
    void errorFallsWithTheOrderOfTheMethod()
    {
        QFETCH(QString, method);
        QFETCH(double, coarse);
        QFETCH(double, fine);
        constexpr int frames = 1000;
        const Scene scene = onePoint({100, -40}, {3, 8}, {std::make_shared<PointSpring>(0, Vec2{0, 0}, 0.2)});
        const auto measure = [&](double tolerance) {
            const std::vector<State> all = run(scene, method.toStdString(), tolerance, frames);
            double error = 0.0, length = 0.0;
            for (int frame = frames - 40; frame <= frames; ++frame) {
                const State &state = all[std::size_t(frame)];
                error = std::max(error, std::abs(state.positionOf(0).x -
                                                 support::dampedOscillation(100, 3, 0.2, 1.0, frame)));
                length += state.adaptiveSteps.front().length / 41;
            }
            return std::pair(error, length);
        };
        const auto [coarseError, coarseStep] = measure(coarse);
        const auto [fineError, fineStep] = measure(fine);
        const double order = std::log(coarseError / fineError) / std::log(coarseStep / fineStep);
        QVERIFY2(std::abs(order - findMethod(method.toStdString())->order()) < 0.15,
                 qPrintable(QString::number(order)));
    }

    void dampingAloneIsExact_data() { addAdaptiveRows(); }
    void dampingAloneIsExact()
    {
        QFETCH(QString, method);
        for (const double damp : {1.0, 0.9, 1e-3, 1e-300, 0.0}) {
            const Scene scene = onePoint({5, 5}, {3, 8}, {std::make_shared<Damping>(damp)});
            const std::vector<State> all = run(scene, method.toStdString(), 1e-9, 20);
            for (std::size_t frame = 1; frame < all.size(); ++frame) {
                const double factor = std::pow(damp, double(frame));
                // Steps are exact. Between their ends the velocity is the derivative of the dense output,
                // which is one order less accurate than the position.
                QVERIFY(std::abs(all[frame].velocityOf(0).y - 8 * factor) <= 1e-11 * 8 * factor + 3e-8);
                // The distance travelled is the integral of v.
                const double c = -std::log(damp);
                const double travelled = damp == 1.0 ? double(frame) : damp == 0.0 ? 0.0 : (1 - factor) / c;
                QVERIFY(std::abs(all[frame].positionOf(0).x - (5 + 3 * travelled)) < 1e-6);
            }
        }
    }

    void nystromNeedsTheSameDampingForAllDynamicPoints()
    {
        Scene scene = scenes::pointsAt({{}, {}, {}}); // the last point is a handle
        scene.start.setVelocity(0, {3, 8});
        scene.start.setVelocity(1, {-2, 5});
        scene.groups.front().points = {0, 2};
        const EffectPtr first = std::make_shared<Damping>(0.9, PointRange{0, 1});
        scene.effects = {first, std::make_shared<Damping>(0.5, PointRange{1, 1})};
        const MethodPtr rule = findMethod("rkn86");
        rule->prepareState(scene.start);
        try {
            compose(scene, *rule, StepSize::withTolerance(1e-3));
            QFAIL("two different dampings were accepted");
        } catch (const Error &error) {
            QCOMPARE(error.id(), std::string("method-does-not-fit"));
            QCOMPARE(error.values().at("effect"), std::string("damping"));
        }
        // A handle is not damped, so its damping does not matter.
        scene.effects = {std::make_shared<Damping>(0.9, PointRange{0, 2})};
        const std::vector<State> all = run(scene, "rkn86", 1e-9, 7);
        const double travelled = (1 - std::pow(0.9, 7)) / -std::log(0.9);
        QVERIFY(std::abs(all.back().positionOf(1).x - -2 * travelled) < 1e-12);
    }

    void bouncesAreLocatedInTime_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("bounce");
        QTest::addColumn<double>("tolerance");
        for (const QString &id : ids) {
            for (const double bounce : {1.0, 0.8, 0.3, 0.0}) {
                for (const double tolerance : {1e-3, 1e-9})
                    QTest::addRow("%s, bounce %g, %g px", qPrintable(id), bounce, tolerance)
                        << id << bounce << tolerance;
            }
        }
    }
    void bouncesAreLocatedInTime()
    {
        QFETCH(QString, method);
        QFETCH(double, bounce);
        QFETCH(double, tolerance);
        const FallingBall exact{0.5, 100.0, bounce};
        const Scene scene =
            onePoint({0, 280}, {2, 0},
                     {std::make_shared<Gravity>(0.5),
                      std::make_shared<Walls>(Room{-1e6, 1e6, 380, bounce}, Eigen::ArrayXd::Zero(1))});
        const std::vector<State> all = run(scene, method.toStdString(), tolerance, 300);
        for (std::size_t frame = 0; frame < all.size(); ++frame) {
            const double error = (380 - all[frame].positionOf(0).y) - exact.at(double(frame));
            // Replacing the last small bounces by resting contact costs up to the tolerance and a millionth
            // of a pixel.
            QVERIFY2(std::abs(error) < 10 * tolerance + 1e-5, qPrintable(QString("frame %1").arg(frame)));
            QVERIFY(std::abs(all[frame].positionOf(0).x - 2 * double(frame)) < 1e-6);
        }
        if (bounce < 0.9)
            QCOMPARE(all.back().velocityOf(0).y, 0.0); // resting contact, without small bounces
    }

    void footSticksWhereItLandsAndLiftsWhenPulledUp_data() { addAdaptiveRows(); }
    void footSticksWhereItLandsAndLiftsWhenPulledUp()
    {
        QFETCH(QString, method);
        // The foot's spring turns round the body: the foot lands, stands still, and is pulled off again.
        Scene scene = scenes::pairOnHandle();
        scene.start.place(0, {0, 40});
        scene.start.place(1, {0, 0});
        scene.start.gait.setZero(1);
        scene.start.gaitSpeed.setConstant(1, 0.05);
        scene.effects = {
            std::make_shared<LegSpring>(std::vector<Leg>{{0, 1, 0.0, 0}},
                                        LegRule{0.1, 50.0, 0.0, Aim::swing, Reaction::none}),
            std::make_shared<Damping>(0.9),
            std::make_shared<Ground>(std::vector<int>{0}, GroundPlane{20.0, 0.0, Traction::full}),
            std::make_shared<GaitClock>()};
        const std::vector<State> all = run(scene, method.toStdString(), 1e-9, 300);
        // The foot lifts when the leg's end rises above the ground: -50 sin(gait) = 20.
        int framesOnGround = 0, landings = 0;
        for (std::size_t frame = 1; frame < all.size(); ++frame) {
            const State &state = all[frame];
            QVERIFY(state.positionOf(0).y <= 20.0);
            const bool on = state.positionOf(0).y == 20.0, was = all[frame - 1].positionOf(0).y == 20.0;
            framesOnGround += on;
            landings += on && !was;
            if (on && was) {
                QCOMPARE(state.positionOf(0).x, all[frame - 1].positionOf(0).x);
                QVERIFY(-50 * std::sin(0.05 * double(frame)) > 20.0 - 1e-9);
            }
            if (was && !on)
                QVERIFY(-50 * std::sin(0.05 * double(frame)) < 20.0);
        }
        QVERIFY(framesOnGround > 40 && landings == 2);
        // Another method must give the same motion.
        const std::vector<State> other =
            run(scene, method == "dormand_prince" ? "dop853" : "dormand_prince", 1e-10, 300);
        for (std::size_t frame = 0; frame < all.size(); ++frame)
            QVERIFY(length(all[frame].positionOf(0) - other[frame].positionOf(0)) < 1e-6);
    }

    void fixedStepMethodsLoseTheirOrderAtABounce()
    {
        const FallingBall exact{0.5, 100.0, 1.0};
        const Scene scene =
            onePoint({0, 280}, {0, 0},
                     {std::make_shared<Gravity>(0.5),
                      std::make_shared<Walls>(Room{-1e6, 1e6, 380, 1.0}, Eigen::ArrayXd::Zero(1))});
        const auto error = [&](double h) {
            double maxError = 0.0;
            for (int frame = 1; frame <= 60; ++frame) {
                const State state = support::plainRun(scene, "rk4", h, frame);
                maxError = std::max(maxError, std::abs(380 - state.positionOf(0).y - exact.at(frame)));
            }
            return maxError;
        };
        // The method is exact in free fall. After the bounce its error is proportional to h, not to h^4.
        const double coarse = error(1.0 / 8), fine = error(1.0 / 64);
        QVERIFY(fine > coarse / 64 && fine > 1e-2);
    }

    void dragDiscardsTheStepComputedAhead_data() { addAdaptiveRows(); }
    void dragDiscardsTheStepComputedAhead()
    {
        QFETCH(QString, method);
        const Scene scene = onePoint({100, -40}, {3, 8}, {std::make_shared<PointSpring>(0, Vec2{0, 0}, 0.2)});
        Script script = support::script(scene, method.toStdString());
        script.step = StepSize::withTolerance(1e-9);
        script.input = {{10, Grab{"ball"}}, {10, Move{{50, 60}}}, {12, Release{}}};
        Track track(script, 0);
        track.seek({9, 0});
        QVERIFY(track.state().adaptiveSteps.front().end > 0.0);
        track.seek({11, 0});
        QVERIFY(track.state().positionOf(0) == (Vec2{50, 60}));
        track.seek({30, 0}); // released at rest after frame 11
        QVERIFY(std::abs(track.state().positionOf(0).x - support::dampedOscillation(50, 0, 0.2, 1.0, 19)) <
                1e-6);
    }

    void frameWithTooManyStepsEndsTheRun_data() { addAdaptiveRows(); }
    void frameWithTooManyStepsEndsTheRun()
    {
        QFETCH(QString, method);
        // The spring turns by 4000 rad per frame, some 600 oscillations.
        const Scene scene = onePoint({100, 0}, {}, {std::make_shared<PointSpring>(0, Vec2{0, 0}, 1.6e7)});
        Script script = support::script(scene, method.toStdString());
        script.step = StepSize::withTolerance(1e-13);
        Track track(script, 0);
        track.seek({10, 0});
        QVERIFY(track.stop());
        QVERIFY(track.stop()->reason == StopReason::tooManySteps);
        QCOMPARE(track.stop()->frame, std::int64_t(0));
        QCOMPARE(track.stop()->body, std::string("ball"));
        QVERIFY(sameBits(track.state(), Track(script, 0).state())); // unchanged
        script.step = StepSize::withTolerance(1.0);                 // the remedy that the message offers
        Track rough(script, 0);
        rough.seek({10, 0});
        QVERIFY(!rough.stop());
        QCOMPARE(rough.cursor().frame, std::int64_t(10));
    }

    void stoppedRunKeepsItsLastFrame()
    {
        support::Sample sample;
        sample.values.set("k", 0.2);
        sample.build = [](const Values &values) {
            return onePoint({100, 0}, {0, 3}, {std::make_shared<PointSpring>(0, Vec2{0, 0}, values["k"])});
        };
        Script script = support::script(sample, "dormand_prince");
        script.step = StepSize::withTolerance(1e-9);
        const Script unchanged = script;
        script.input = {{21, Set{"k", 1e14}}};
        Track track(script, 0);
        track.seek({20, 1});
        track.seek({40, 0});
        QVERIFY(track.stop() && track.stop()->reason == StopReason::tooManySteps);
        QVERIFY(track.cursor() == (Cursor{20, 0}));
        Track plain(unchanged, 0);
        plain.seek({20, 0});
        QVERIFY(sameBits(track.state(), plain.state()));
        track.replaceInput(track.prepareInput({}, 21)); // without the event the run continues
        track.seek({40, 0});
        QVERIFY(!track.stop());
    }

    void impossibleContactEndsTheRun()
    {
        // The walls are closer together than the ball is wide.
        const Scene scene =
            onePoint({0, 0}, {1, 0},
                     {std::make_shared<Gravity>(0.5),
                      std::make_shared<Walls>(Room{-1, 1, 380, 1.0}, Eigen::ArrayXd::Constant(1, 5.0))});
        Script script = support::script(scene, "dormand_prince");
        Track track(script, 0);
        track.seek({10, 0});
        QVERIFY(track.stop());
        QVERIFY(track.stop()->reason == StopReason::tooManySteps);
        QCOMPARE(track.stop()->body, std::string("ball"));
    }
};

SUITE(tst_adaptive, TestAdaptive)
#include "tst_adaptive.moc"

#include "sim/analysis/cost/cost.h"
#include "sim/base/error.h"
#include "sim/effects/fields/gravity.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/run_step.h"
#include "tests/sim/support/support.h"
#include "tests/suite.h"

#include <QTest>

namespace {

constexpr double ns = 1e-9;
constexpr double clockCost = 30 * ns; ///< time that reading the clock takes

/// A fake time that passes only when a test says so.
struct FakeTime
{
    double now = 0.0;
    void pass(double nanoseconds) { now += nanoseconds * ns; }
    /// Returns a clock whose readings cost time themselves, half before and half after the reading.
    sim::CostMeter::Clock clock()
    {
        return [this] {
            now += clockCost;
            return now - 0.5 * clockCost;
        };
    }
};

/// A force that takes the same time on each call. Its Jacobian takes twice as long.
class SlowForce : public sim::Force
{
public:
    SlowForce(std::string id, double takes, FakeTime &time)
        : m_id(std::move(id)), m_takes(takes), m_time(time)
    {
    }
    std::string id() const override { return m_id; }
    std::string title() const override { return m_id; }
    sim::EffectKind kind() const override { return sim::EffectKind::gravity; }
    std::vector<sim::Region> regions(sim::DirectionRule) const override { return {}; }
    int count(const sim::State &, sim::PointRange points) const override { return points.count; }
    void add(const sim::State &, sim::PointRange, double, sim::DirectionRule,
             Eigen::ArrayX2d &) const override
    {
        m_time.pass(m_takes);
    }
    bool addJacobian(const sim::State &, sim::PointRange, double, sim::DirectionRule,
                     sim::Jacobian &) const override
    {
        m_time.pass(2 * m_takes);
        return true;
    }
    std::vector<sim::LiveValue> explain(const sim::State &, int, sim::DirectionRule) const override
    {
        return {};
    }

private:
    std::string m_id;
    double m_takes;
    FakeTime &m_time;
};

/// An effect whose parameters make it idle.
class IdleGravity : public sim::Gravity
{
public:
    IdleGravity() : sim::Gravity(0.0) {}
    bool isIdle() const override { return true; }
};

/// A method with three phases: one without effects, one with a prelude and the scene's first force, and one
/// that computes the scene's second force three times and its Jacobian once.
class TestMethod : public sim::Method
{
public:
    explicit TestMethod(FakeTime &time) : m_time(time) {}
    std::string id() const override { return "test_method"; }
    std::string title() const override { return "test_method"; }
    int order() const override { return 1; }
    std::vector<std::string> requirements() const override { return {}; }
    sim::DirectionRule directionRule() const override { return sim::DirectionRule::regularised; }
    sim::Region region() const override { return {}; }
    void prepareState(sim::State &state) const override { state.acceleration.setZero(state.pointCount(), 2); }
    std::vector<sim::Phase> phases(const sim::Scene &scene, sim::StepSize) const override
    {
        const auto taking = [&time = m_time](double takes) {
            return [&time, takes](sim::State &) { time.pass(takes); };
        };
        const auto force = [&](std::size_t index) {
            const auto selected = std::dynamic_pointer_cast<const sim::Force>(scene.effects[index]);
            return [selected](sim::State &state) {
                selected->add(state, {0, state.pointCount()}, 1.0, sim::DirectionRule::regularised,
                              state.acceleration);
            };
        };
        sim::Phase methodPhase, first, within;
        methodPhase.id = "method";
        methodPhase.kernels = {{taking(5), {}}};
        first.id = "first";
        first.effect = scene.effects[0];
        first.kernels = {{taking(20), {}}, {force(0), {}}};
        within.id = "within";
        within.innerEffects = {scene.effects[1]};
        const auto computed = [&time = m_time, add = force(1), second = scene.effects[1]](sim::State &state) {
            time.pass(100);
            for (int i = 0; i < 3; ++i)
                add(state);
            sim::Jacobian jacobian(state.pointCount());
            dynamic_cast<const sim::Force &>(*second).addJacobian(state, {0, state.pointCount()}, 1.0,
                                                                  sim::DirectionRule::regularised, jacobian);
        };
        within.kernels = {{computed, {}}};
        return {methodPhase, first, within};
    }

private:
    FakeTime &m_time;
};

sim::Scene slowScene(FakeTime &time)
{
    sim::Scene scene = scenes::creature(2);
    scene.effects = {std::make_shared<SlowForce>("slow", 40, time),
                     std::make_shared<SlowForce>("slower", 300, time)};
    return scene;
}

sim::CostMeter meterOf(const sim::Script &script)
{
    const sim::Scene scene = sim::sceneOf(script, script.values);
    return {scene, script.method, script.step, scene.start};
}

bool near(double a, double b)
{
    return std::abs(a - b) < 1e-3 + 1e-6 * std::abs(b);
}

}

/// The cost of effects by a fake clock. tst_instructions compares real costs.
class TestCost : public QObject
{
    Q_OBJECT

private slots:
    void eachPartIsMeasuredExactly_data()
    {
        QTest::addColumn<double>("h");
        QTest::addColumn<int>("steps");  // per output step
        QTest::addColumn<int>("frames"); // per output step
        QTest::newRow("one step per frame") << 1.0 << 1 << 1;
        QTest::newRow("four steps per frame") << 0.25 << 4 << 1;
        QTest::newRow("one step per five frames") << 5.0 << 1 << 5;
    }
    void eachPartIsMeasuredExactly()
    {
        QFETCH(double, h);
        QFETCH(int, steps);
        QFETCH(int, frames);
        FakeTime time;
        const sim::Scene scene = slowScene(time);
        sim::CostMeter meter(scene, std::make_shared<TestMethod>(time), sim::StepSize::ofLength(h),
                             scene.start, time.clock());
        for (int i = 0; i < 3; ++i)
            QVERIFY(meter.round());
        const sim::FrameCost cost = meter.result();
        const double perFrame = double(steps) / frames;
        QCOMPARE(cost.rounds, 3);
        QVERIFY(near(cost.ns, perFrame * (5 + 20 + 40 + 100 + 3 * 300 + 600)));
        QVERIFY(near(cost.restNs, perFrame * (5 + 20 + 100)));
        QCOMPARE(cost.effects.size(), std::size_t{2});
        QVERIFY(near(cost.effects[0].ns, perFrame * 40));
        QVERIFY(near(cost.effects[1].ns, perFrame * (3 * 300 + 600)));
        QVERIFY(near(cost.effects[0].evaluations, perFrame));
        QVERIFY(near(cost.effects[1].evaluations, 3 * perFrame));
        QVERIFY(near(cost.sum(), cost.ns));
        QVERIFY(near(cost.spread, 0) && near(cost.effects[1].spread, 0) && near(cost.restSpread, 0));
    }

    void effectsAreListedInTheirOrderOfExecution()
    {
        const sim::Script script = support::script(support::sample("walkers"), "published");
        const sim::Scene scene = sim::sceneOf(script, script.values);
        sim::CostMeter meter(scene, script.method, script.step, scene.start);
        std::vector<sim::EffectPtr> order;
        for (const sim::Phase &phase : meter.pipeline().phases) {
            if (phase.effect && std::find(order.begin(), order.end(), phase.effect) == order.end())
                order.push_back(phase.effect);
        }
        const sim::FrameCost cost = meter.result();
        QCOMPARE(cost.effects.size(), order.size());
        for (std::size_t i = 0; i < order.size(); ++i)
            QCOMPARE(cost.effects[i].effect, order[i]);
    }

    void affectedPointsAreCounted_data()
    {
        QTest::addColumn<QString>("sample");
        QTest::addColumn<QString>("effect");
        QTest::addColumn<int>("points");
        const auto row = [](const char *sample, const char *effect, int points) {
            QTest::addRow("%s: %s", sample, effect) << sample << effect << points;
        };
        row("creature in a room", "radial_spring", 6); // ten forces on six points
        row("creature in a room", "gravity", 6);
        row("creature in a room", "walls", 6);
        row("beside a handle", "offset_spring", 1); // the handle feels nothing
        row("walkers", "leg_spring", 6);            // feet and bodies
        row("walkers", "ground", 4);
    }
    void affectedPointsAreCounted()
    {
        QFETCH(QString, sample);
        QFETCH(QString, effect);
        QFETCH(int, points);
        const sim::Script script =
            support::script(support::sample(sample.toStdString()), "semi_implicit_euler");
        const sim::Scene scene = sim::sceneOf(script, script.values);
        const sim::CostMeter meter(scene, script.method, script.step, scene.start);
        QStringList ids;
        for (const sim::EffectCost &cost : meter.result().effects) {
            ids << QString::fromStdString(cost.effect->id());
            if (ids.back() == effect)
                QCOMPARE(cost.points, points);
        }
        QVERIFY2(ids.contains(effect), qPrintable(ids.join(' ')));
    }

    void idleEffectIsNotListed()
    {
        sim::Scene scene = scenes::creature(1);
        const auto acting = std::make_shared<sim::Gravity>(0.5);
        scene.effects = {std::make_shared<IdleGravity>(), acting};
        const sim::Script script = support::script(scene, "semi_implicit_euler");
        const sim::CostMeter meter = meterOf(script);
        QCOMPARE(meter.result().effects.size(), std::size_t{1});
        QCOMPARE(meter.result().effects[0].effect, sim::EffectPtr(acting));
        QCOMPARE(meter.pipeline().idleEffects.size(), std::size_t{1});
    }

    void cancelledRoundIsDiscarded()
    {
        FakeTime time;
        const sim::Scene scene = slowScene(time);
        sim::CostMeter meter(scene, std::make_shared<TestMethod>(time), sim::StepSize::ofLength(1),
                             scene.start, time.clock());
        int maxCalls = 0; // calls of a complete round
        QVERIFY(meter.round([&] {
            ++maxCalls;
            return true;
        }));
        QVERIFY(maxCalls > 10);
        for (int allowed = 0; allowed < maxCalls;
             allowed += 1 + maxCalls / 50) { // later rounds are shorter than the first
            int callsLeft = allowed;
            const int before = meter.result().rounds;
            const bool isDone = meter.round([&] { return callsLeft-- > 0; });
            QCOMPARE(meter.result().rounds, before + (isDone ? 1 : 0));
            QVERIFY(isDone || callsLeft < 0);
            QVERIFY(near(meter.result().effects[1].ns, 1500));
            QVERIFY(near(meter.result().restNs, 125));
        }
        sim::CostMeter fresh(scene, std::make_shared<TestMethod>(time), sim::StepSize::ofLength(1),
                             scene.start, time.clock());
        QVERIFY(!fresh.round([] { return false; }));
        QCOMPARE(fresh.result().rounds, 0);
        QVERIFY(fresh.round());
        QVERIFY(near(fresh.result().effects[1].ns, 1500));
    }

    /// An adaptive step of ten frames computes effects in one of them only.
    void adaptiveStepsOfSeveralFramesAreMeasuredWhole()
    {
        FakeTime time;
        sim::Scene scene = scenes::creature(2);
        scene.effects = {std::make_shared<SlowForce>("slow", 1e6, time)};
        const sim::MethodPtr method = sim::findMethod("dop853");
        const auto step = sim::StepSize::withTolerance(1e-3);
        const sim::Pipeline pipeline = sim::compose(scene, *method, step);
        sim::State state = scene.start;
        method->prepareState(state);
        for (int frame = 0; frame < 40; ++frame) {
            sim::CostMeter meter(scene, method, step, state, time.clock());
            QVERIFY(meter.round());
            const sim::FrameCost cost = meter.result();
            QVERIFY2(cost.effects[0].evaluations > 0.0, qPrintable(QString("from frame %1").arg(frame)));
            QVERIFY(std::abs(cost.effects[0].ns - cost.ns) < 0.01 * cost.ns);
            sim::runStep(pipeline, state);
        }
        QVERIFY(state.adaptiveSteps[0].nextLength > 5.0);
    }

    void methodThatDoesNotFitIsRefused()
    {
        const sim::Script script = support::script(support::sample("walkers"), "backward_euler");
        const sim::Scene scene = sim::sceneOf(script, script.values);
        QVERIFY_THROWS_EXCEPTION(sim::Error, sim::CostMeter(scene, sim::findMethod("dop853"),
                                                            sim::StepSize::ofLength(1), scene.start));
    }

    /// A run that does not stay finite is measured up to its last finite frame.
    void runThatEndsEarlyIsMeasured()
    {
        sim::Scene scene = scenes::creature(0);
        scene.effects = {std::make_shared<sim::Gravity>(1e308)};
        sim::CostMeter meter = meterOf(support::script(scene, "semi_implicit_euler"));
        QVERIFY(meter.round());
        QVERIFY(std::isfinite(meter.result().ns));
    }
};

SUITE(tst_cost, TestCost)
#include "tst_cost.moc"

#include "sim/effects/tree/torsion.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "sim/run/track.h"
#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <random>

using namespace support;

/// Step `real_sway`: a tree with torsional springs as joints.
class RealSway : public QObject
{
    Q_OBJECT

    const lessons::Step m_step = loadLesson(QStringLiteral("swaying_tree")).step(QStringLiteral("real_sway"));

    /// Returns the step with branch i bent by `bend(i)` degrees at the start.
    sim::Script bent(const std::function<double(int)> &bend, double h = 1.0,
                     const Changes &changes = {}) const
    {
        sim::Script script = scriptOf(m_step, "semi_implicit_euler", h, changes);
        script.build = [build = script.build, bend](const sim::Values &values) {
            sim::Scene scene = build(values);
            for (int i = 0; i < scene.start.pointCount(); ++i)
                scene.start.angle[i] += bend(i);
            return scene;
        };
        return script;
    }

    static const sim::Torsion &springsOf(const sim::Scene &scene)
    {
        for (const sim::EffectPtr &effect : scene.effects) {
            if (const auto *found = dynamic_cast<const sim::Torsion *>(effect.get()))
                return *found;
        }
        throw std::runtime_error("no springs");
    }

    sim::Scene sceneOf(const Changes &changes = {}) const
    {
        const sim::Script script = scriptOf(m_step, "semi_implicit_euler", 1.0, changes);
        return sim::sceneOf(script, script.values);
    }

    static Eigen::ArrayXd accelerations(const sim::Torsion &springs, const sim::State &state)
    {
        Eigen::ArrayXd result = Eigen::ArrayXd::Zero(state.pointCount());
        springs.add(state, {0, state.pointCount()}, 1.0, result);
        return result;
    }

    /// Computes the largest eigenvalue of stiffness/inertia, by power iteration on the accelerations.
    static double largestEigenvalue(const sim::Scene &scene)
    {
        const sim::Torsion &springs = springsOf(scene);
        sim::State state = scene.start;
        Eigen::ArrayXd bends(state.pointCount());
        for (int i = 0; i < state.pointCount(); ++i)
            bends[i] = std::sin(1.0 + 3.7 * i);
        double value = 0.0;
        for (int turn = 0; turn < 3000; ++turn) {
            state.angle = scene.start.angle + bends;
            const Eigen::ArrayXd next = -accelerations(springs, state);
            value = std::sqrt(next.square().sum() / bends.square().sum());
            bends = next / std::sqrt(next.square().sum());
        }
        return value;
    }

private slots:
    void trunkMatchesClosedForm_data();
    void trunkMatchesClosedForm();
    void twigOfAHeldBranchMatchesClosedForm();
    void thinBranchesOscillateFaster();
    void internalTorquesCancel();
    void bentTwigMovesTheTrunk();
    void undampedEnergyStaysBoundedOver100000Frames();
    void dampingReducesEnergy();
    void stepLimitMatchesText();
    void stiffnessBoundIsSafeAndTight_data();
    void stiffnessBoundIsSafeAndTight();
    void publishedMethodMatchesSemiImplicitEuler();
    void energyMeasuresAddUp();
};

void RealSway::trunkMatchesClosedForm_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("damp");
    QTest::newRow("default values") << 0.05 << 0.96;
    QTest::newRow("without damping") << 0.05 << 1.0;
    QTest::newRow("stiff, strongly damped") << 0.3 << 0.7;
    QTest::newRow("overdamped") << 0.01 << 0.7;
}

/// The bend b follows b'' = -k b - c b' with c = -ln(damp), from b = 10 and b' = 0. The method has order 1,
/// so the error halves with the step. It vanishes when extrapolated to a step of 0.
void RealSway::trunkMatchesClosedForm()
{
    QFETCH(double, k);
    QFETCH(double, damp);
    constexpr int frames = 40;
    const std::complex<double> c = -std::log(damp), w = std::sqrt(std::complex<double>(k) - 0.25 * c * c);
    const auto exact = [&](int frame) {
        const std::complex<double> t = frame;
        return (10.0 * std::exp(-0.5 * c * t) * (std::cos(w * t) + 0.5 * c / w * std::sin(w * t))).real();
    };
    const auto bends = [&](double h) {
        const Changes trunkOnly = {{"min_scale", 1.0}, {"k", k}, {"damp", damp}};
        sim::Track run(bent([](int) { return 10.0; }, h, trunkOnly), 0);
        std::vector<double> all;
        for (int frame = 1; frame <= frames; ++frame) {
            run.seek({frame, 0});
            all.push_back(run.state().angle[0] + 90.0);
        }
        return all;
    };
    const auto error = [&](double h) {
        const std::vector<double> all = bends(h);
        double largestError = 0.0;
        for (int frame = 1; frame <= frames; ++frame)
            largestError =
                std::max(largestError, std::abs(all[static_cast<std::size_t>(frame - 1)] - exact(frame)));
        return largestError;
    };
    const OrderRange order = observedOrders(error, 5, 10);
    QVERIFY2(order.min > 0.9 && order.max < 1.1,
             qPrintable(QString::number(order.min) + u' ' + QString::number(order.max)));
    const auto coarse = bends(1.0 / 256), fine = bends(1.0 / 512), finest = bends(1.0 / 1024);
    for (int frame = 1; frame <= frames; ++frame) {
        const auto index = static_cast<std::size_t>(frame - 1);
        const double second = 2.0 * finest[index] - fine[index], first = 2.0 * fine[index] - coarse[index];
        QVERIFY(std::abs((4.0 * second - first) / 3.0 - exact(frame)) < 1e-5);
    }
}

/// A single branch has w^2 = k / scale at any bend. With steps of h, cos(w h) = 1 - k h^2 / (2 scale).
void RealSway::twigOfAHeldBranchMatchesClosedForm()
{
    const double k = 0.05, scale = std::pow(0.8, 7);
    const double w = std::acos(1.0 - 0.5 * k / scale);
    sim::Script script = bent([](int i) { return i == 254 ? 7.0 : 0.0; }, 1.0, {{"damp", 1.0}});
    script.input = {{1, sim::Grab{"branch126"}}};
    sim::Track run(script, 0);
    const double rest = run.interval().scene.start.angle[254] - 7.0;
    // From rest, b(n) = 7 (cos(w n) - tan(w / 2) sin(w n)), because spins are updated before angles.
    for (int n = 1; n <= 200; ++n) {
        run.seek({n, 0});
        const double exact = 7.0 * (std::cos(w * n) - std::tan(0.5 * w) * std::sin(w * n));
        QVERIFY(std::abs(run.state().angle[254] - rest - exact) < 1e-9);
    }
}

void RealSway::thinBranchesOscillateFaster()
{
    const sim::Scene scene = sceneOf();
    const Eigen::ArrayXd squaredFrequency =
        springsOf(scene).mechanics().stiffness / springsOf(scene).mechanics().inertia;
    for (int i = 1; i < squaredFrequency.rows(); ++i) {
        const int parent = (i - 1) / 2;
        QVERIFY(squaredFrequency[i] > 1.2 * squaredFrequency[parent]);
    }
}

/// Internal torques cancel: the sum over all joints is the torque of the ground on the trunk.
void RealSway::internalTorquesCancel()
{
    const sim::Scene scene = sceneOf();
    const sim::Torsion &springs = springsOf(scene);
    std::mt19937 random(5);
    for (int turn = 0; turn < 20; ++turn) {
        sim::State state = scene.start;
        for (int i = 0; i < state.pointCount(); ++i)
            state.angle[i] += std::uniform_real_distribution<double>(-40, 40)(random);
        const double torque = (springs.mechanics().inertia * accelerations(springs, state)).sum();
        const double ground = -springs.mechanics().stiffness[0] * (state.angle[0] - scene.start.angle[0]);
        const double size = springs.mechanics().stiffness[0] * 40.0;
        QVERIFY(std::abs(torque - ground) < 1e-10 * size);
    }
}

void RealSway::bentTwigMovesTheTrunk()
{
    sim::Track run(bent([](int i) { return i == 254 ? 30.0 : 0.0; }), 0);
    run.seek({20, 0});
    QVERIFY(std::abs(run.state().angle[0] + 90.0) > 1e-6);
}

/// Semi-implicit Euler conserves a modified energy, H + (h/2) sum(I w a), up to rounding. So the energy H
/// stays within bounds, without a trend.
void RealSway::undampedEnergyStaysBoundedOver100000Frames()
{
    const sim::Script script = bent([](int i) { return 20.0 * std::sin(1.0 + i); }, 1.0, {{"damp", 1.0}});
    sim::Track run(script, 0);
    const sim::Torsion &springs = springsOf(run.interval().scene);
    const auto energy = [&] {
        return springs.kineticEnergy(run.state()) + springs.springEnergy(run.state());
    };
    const auto modifiedEnergy = [&] {
        const Eigen::ArrayXd a = accelerations(springs, run.state());
        return energy() + 0.5 * (springs.mechanics().inertia * run.state().spin * a).sum();
    };
    const double start = energy(), startModified = modifiedEnergy();
    double minEnergy = start, maxEnergy = start, early = 0.0, late = 0.0;
    constexpr int frames = 100'000, part = 10'000;
    for (int frame = 1; frame <= frames; ++frame) {
        run.seek({frame, 0});
        const double now = energy();
        minEnergy = std::min(minEnergy, now);
        maxEnergy = std::max(maxEnergy, now);
        early += frame <= part ? now / part : 0.0;
        late += frame > frames - part ? now / part : 0.0;
    }
    QVERIFY(std::abs(modifiedEnergy() / startModified - 1.0) < 1e-9);
    // |H - modified energy| is at most h sqrt(largest eigenvalue) / 2 of H.
    const double bound = 0.5 * std::sqrt(springs.stiffnessBound());
    QVERIFY(minEnergy > start * (1.0 - bound) / (1.0 + bound) &&
            maxEnergy < start * (1.0 + bound) / (1.0 - bound));
    QVERIFY2(std::abs(late / early - 1.0) < 0.005, qPrintable(QString::number(late / early)));
}

void RealSway::dampingReducesEnergy()
{
    sim::Track run(bent([](int i) { return 20.0 * std::sin(1.0 + i); }), 0);
    const sim::Torsion &springs = springsOf(run.interval().scene);
    double last = 1e300;
    for (int frame = 0; frame <= 1000; frame += 100) { // longer than the longest period
        run.seek({frame, 0});
        const double now = springs.kineticEnergy(run.state()) + springs.springEnergy(run.state());
        QVERIFY(now < 0.5 * last);
        last = now;
    }
}

void RealSway::stepLimitMatchesText()
{
    const double limit = 2.0 / std::sqrt(largestEigenvalue(sceneOf()));
    QVERIFY2(limit >= 3.1 && limit < 3.2, qPrintable(QString::number(limit, 'g', 8)));
    const auto maxBend = [&](double h) {
        sim::Track run(bent([](int i) { return 0.1 * std::sin(1.0 + i); }, h, {{"damp", 1.0}}), 0);
        run.seek({1200, 0});
        return (run.state().angle - sceneOf().start.angle).abs().maxCoeff();
    };
    QVERIFY(maxBend(3.0) < 100.0);
    QVERIFY(!(maxBend(4.0) < 1e6));
}

void RealSway::stiffnessBoundIsSafeAndTight_data()
{
    QTest::addColumn<double>("slope");
    QTest::addColumn<double>("minScale");
    QTest::newRow("default values") << 0.8 << 0.2;
    QTest::newRow("only a trunk") << 0.8 << 1.0;
    QTest::newRow("gradually thinner branches") << 0.9 << 0.5;
    QTest::newRow("quickly thinner branches") << 0.5 << 0.01;
}

void RealSway::stiffnessBoundIsSafeAndTight()
{
    QFETCH(double, slope);
    QFETCH(double, minScale);
    const sim::Scene scene = sceneOf({{"slope", slope}, {"min_scale", minScale}});
    const double exact = largestEigenvalue(scene), bound = springsOf(scene).stiffnessBound();
    QVERIFY(bound >= exact * (1.0 - 1e-9) && bound <= 2.0 * exact);
}

void RealSway::publishedMethodMatchesSemiImplicitEuler()
{
    const auto after = [&](const char *method, double h) {
        sim::Script script = scriptOf(m_step, method, h);
        script.input = {{1, sim::Pointer{{60, 250}, true}}, {9, sim::Pointer{{60, 250}, false}}};
        return stateAfter(script, 40);
    };
    QVERIFY(largestDistance(after("published", 1.0), after("semi_implicit_euler", 1.0)) < 1e-9);
}

void RealSway::energyMeasuresAddUp()
{
    const auto measured = [&](const QString &name, const sim::State &state) {
        for (const lessons::Measure &measure : m_step.measures) {
            if (measure.name == name)
                return measure.of(sceneOf(), state, nullptr, m_step.defaultValues());
        }
        return -1.0;
    };
    sim::Script script = m_step.script();
    script.input = {{1, sim::Pointer{{60, 250}, true}}};
    const sim::State state = stateAfter(script, 60);
    QCOMPARE(measured(u"Energy"_qs, sceneOf().start), 0.0);
    QVERIFY(measured(u"In motion"_qs, state) > 0.0 && measured(u"In springs"_qs, state) > 0.0);
    QCOMPARE(measured(u"Energy"_qs, state),
             measured(u"In motion"_qs, state) + measured(u"In springs"_qs, state));
}

SUITE(tst_real_sway, RealSway)
#include "tst_real_sway.moc"

// The bound of a step, the spring that determines it, and the effects that the analysis ignores.

#include "tests/sim/support/stability_scenes.h"
#include "tests/sim/support/support.h"

#include "sim/analysis/stability/modes/spectrum.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <Eigen/Eigenvalues>
#include <QTest>

#include <cmath>

using namespace sim;
using namespace stability_scenes;
using std::make_shared;

namespace {

/// A force that hides the Jacobian of another force.
class ForceWithoutJacobian : public Force
{
public:
    explicit ForceWithoutJacobian(std::shared_ptr<const Force> inner) : m_inner(std::move(inner)) {}
    std::string id() const override { return "silent"; }
    std::string title() const override { return "silent"; }
    EffectKind kind() const override { return EffectKind::spring; }
    std::vector<Region> regions(DirectionRule) const override { return {}; }
    int count(const State &state, PointRange points) const override { return m_inner->count(state, points); }
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &accelerations) const override
    {
        m_inner->add(state, movers, scale, directionRule, accelerations);
    }
    std::vector<LiveValue> explain(const State &, int, DirectionRule) const override { return {}; }

private:
    std::shared_ptr<const Force> m_inner;
};

class VelocityForce : public ForceWithoutJacobian
{
public:
    using ForceWithoutJacobian::ForceWithoutJacobian;
    bool dependsOnVelocity() const override { return true; }
};

}

class TestStability : public QObject
{
    Q_OBJECT

private slots:
    void everyMethodReportsItsBound();
    void sceneWithoutSpringsHasNoLimit();
    void bucklingIsNotCountedAsInstability();
    void theStiffestSpringIsNamed();
    void stiffestPointSpringIsNamed();
    void ignoredContactsAreNamed();
    void forcesWithoutJacobianAreDifferenced();
    void bucklingIsIgnoredInDifferencesToo();
    void heldBodyIsFixed();
    void largestEigenvalueOfALargeMatrixIsFound();
    void nonFiniteForcesAreReported();
    void forcesThatDependOnVelocitiesHaveNoKnownLimit();
    void extremeParametersGiveAResult_data();
    void extremeParametersGiveAResult();
};

void TestStability::everyMethodReportsItsBound()
{
    const Scene scene = chain(3, 0.2, 0.9).scene;
    for (const MethodPtr &method : allMethods()) {
        const Bound bound = stabilityOf(scene, scene.start, *method, 1.0).bound;
        if (method->stepping() == Stepping::adaptive)
            QCOMPARE(bound, Bound::tolerance);
        else if (method->requirements() == std::vector<std::string>{"jacobian"})
            QCOMPARE(bound, Bound::none);
        else
            QCOMPARE(bound, Bound::stiffness);
    }
}

void TestStability::sceneWithoutSpringsHasNoLimit()
{
    Scene scene = scenes::creature(2);
    scene.effects = {make_shared<Gravity>(0.5), make_shared<Damping>(0.9)};
    QCOMPARE(predicted(scene, "explicit_euler").bound, Bound::noSprings);
    QCOMPARE(growthOf(scene, scene.start, *findMethod("published"), 1.0), 1.0);
}

void TestStability::bucklingIsNotCountedAsInstability()
{
    // Compressed springs buckle sideways at any step. Along the springs the limit is that of uncompressed
    // springs.
    Scene scene = creature(3, 0.2, 0.9).scene;
    const Stability unloaded = predicted(scene, "semi_implicit_euler", 0.1);
    for (int i = 0; i < 3; ++i)
        scene.start.place(i, scene.start.positionOf(3) +
                                 0.4 * (scene.start.positionOf(i) - scene.start.positionOf(3)));
    const Stability compressed = predicted(scene, "semi_implicit_euler", 0.1);
    QVERIFY(compressed.holds());
    QVERIFY(std::abs(compressed.limit - unloaded.limit) < 1e-9);
    const Stability published = predicted(scene, "published", 0.1);
    QVERIFY(published.holds());
}

void TestStability::theStiffestSpringIsNamed()
{
    Scene scene = chain(6, 0.05, 0.95).scene;
    const auto stiff = make_shared<BodySpring>(std::vector<Link>{{3, 4}, {4, 3}}, 0.9);
    scene.effects.push_back(stiff);
    for (const char *method : {"semi_implicit_euler", "rk4", "published"}) {
        const Stability found = predicted(scene, method, 3.0);
        QCOMPARE(found.dominant.effect, stiff);
        QCOMPARE(found.dominant.point, 3);
        QCOMPARE(found.dominant.other, 4);
        QCOMPARE(found.points.size(), std::size_t(2));
    }
}

void TestStability::stiffestPointSpringIsNamed()
{
    Scene scene = chain(6, 0.05, 0.95).scene;
    const auto stiff = make_shared<PointSpring>(2, Vec2{0, 0}, 0.9);
    scene.effects.push_back(stiff);
    const Stability found = predicted(scene, "velocity_verlet", 1.0);
    QCOMPARE(found.dominant.effect, stiff);
    QCOMPARE(found.dominant.point, 2);
    QCOMPARE(found.dominant.other, -1);
    QCOMPARE(found.points.front(), 2);
}

void TestStability::ignoredContactsAreNamed()
{
    const support::Sample &room = support::sample("creature in a room");
    const Scene scene = room.build(room.values);
    const Stability found = predicted(scene, "semi_implicit_euler");
    QCOMPARE(found.bound, Bound::stiffness);
    QCOMPARE(found.ignored.size(), std::size_t(1));
    QCOMPARE(found.ignored.front()->id(), "walls");
}

void TestStability::forcesWithoutJacobianAreDifferenced()
{
    Scene scene = creature(4, 0.2, 0.9).scene;
    for (const char *method : {"rk4", "published"}) {
        const double exact = predicted(scene, method).limit;
        Scene withoutJacobian = scene;
        withoutJacobian.effects.front() =
            make_shared<ForceWithoutJacobian>(std::dynamic_pointer_cast<const Force>(scene.effects.front()));
        const double found = predicted(withoutJacobian, method).limit;
        QVERIFY2(std::abs(exact - found) < 1e-3 * exact, qPrintable(QString("%1 %2").arg(exact).arg(found)));
    }
}

void TestStability::bucklingIsIgnoredInDifferencesToo()
{
    // Only one spring, because differences cannot separate several springs of one point.
    Scene scene = creature(1, 0.2, 0.9).scene;
    scene.start.place(0, scene.start.positionOf(1) + Vec2{12.0, 17.0});
    Scene withoutJacobian = scene;
    withoutJacobian.effects.front() =
        make_shared<ForceWithoutJacobian>(std::dynamic_pointer_cast<const Force>(scene.effects.front()));
    for (const char *method : {"semi_implicit_euler", "rk4", "published"}) {
        const Stability exact = predicted(scene, method, 0.1),
                        found = predicted(withoutJacobian, method, 0.1);
        QVERIFY(found.holds());
        QVERIFY2(std::abs(exact.limit - found.limit) < 1e-3 * exact.limit,
                 qPrintable(QString("%1: %2 %3").arg(method).arg(exact.limit).arg(found.limit)));
    }
}

void TestStability::heldBodyIsFixed()
{
    // The pair is then one foot on a spring to a fixed position.
    Scene scene = creature(1, 0.3, 1.0).scene;
    scene.start.inverseMass[1] = 0.0;
    const double limit = 2.0 / std::sqrt(0.3);
    for (const char *method : {"semi_implicit_euler", "published"})
        QVERIFY(std::abs(predicted(scene, method).limit - limit) < 2e-4 * limit);
}

void TestStability::largestEigenvalueOfALargeMatrixIsFound()
{
    const int size = 300;
    support::Dice dice(3);
    Eigen::MatrixXd matrix(size, size);
    for (int i = 0; i < size; ++i) {
        for (int j = 0; j <= i; ++j)
            matrix(i, j) = matrix(j, i) = dice.real(-1, 1);
    }
    const Spectrum found(size, [&](const Eigen::VectorXd &in, Eigen::VectorXd &out) { out = matrix * in; });
    const Eigen::VectorXd all = Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix).eigenvalues();
    const double largest = all.cwiseAbs().maxCoeff();
    QVERIFY(std::abs(std::abs(found.values().front()) - largest) < 1e-6 * largest);
    const Eigen::VectorXcd vector = found.vector(0);
    QVERIFY((matrix * vector - found.values().front() * vector).norm() < 1e-4 * largest);
}

void TestStability::nonFiniteForcesAreReported()
{
    Scene scene = creature(1, 0.3, 0.9).scene;
    scene.start.place(0, {std::nan(""), 0.0});
    const Stability found = predicted(scene, "semi_implicit_euler");
    QCOMPARE(found.bound, Bound::unknown);
    QVERIFY(!found.holds());
}

void TestStability::forcesThatDependOnVelocitiesHaveNoKnownLimit()
{
    Scene scene = creature(1, 0.3, 0.9).scene;
    for (EffectPtr &effect : scene.effects) {
        if (const auto force = std::dynamic_pointer_cast<const Force>(effect))
            effect = make_shared<VelocityForce>(force);
    }
    const Stability found = predicted(scene, "semi_implicit_euler");
    QCOMPARE(found.bound, Bound::velocity);
    QVERIFY(!found.holds());
    QCOMPARE(predicted(scene, "backward_euler").bound, Bound::none);
}

void TestStability::extremeParametersGiveAResult_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("damp");
    QTest::addColumn<double>("inverse");
    for (const double k : {1e-12, 1.0, 1e9}) {
        for (const double damp : {0.0, 1e-300, 0.5, 1.0}) {
            for (const double inverse : {1e-9, 1.0, 1e9})
                QTest::addRow("k %g, damp %g, mass 1 : %g", k, damp, inverse) << k << damp << inverse;
        }
    }
}

void TestStability::extremeParametersGiveAResult()
{
    QFETCH(double, k);
    QFETCH(double, damp);
    QFETCH(double, inverse);
    Scene scene = creature(3, k, damp).scene;
    scene.start.inverseMass[0] = inverse;
    scene.start.place(1, {1e9, -1e9});
    for (const char *method : explicitMethods()) {
        for (const double h : {1e-6, 1.0, 100.0}) {
            const Stability found = predicted(scene, method, h);
            QCOMPARE(found.bound, Bound::stiffness);
            QVERIFY(found.limit >= 0.0);
            QVERIFY(found.growth >= 0.0);
            // A step below its limit is stable.
            if (found.limit > 0.0 && found.share() < 0.9)
                QVERIFY(found.holds());
        }
    }
}

SUITE(tst_stability, TestStability)
#include "tst_stability.moc"

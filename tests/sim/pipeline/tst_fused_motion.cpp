#include "tests/sim/support/support.h"

#include "tests/bench/scenes/crowd.h"

#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/room_limits.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/run_step.h"
#include "sim/simd/flush_denormals.h"
#include "tests/suite.h"

#include <QTest>

#include <numeric>

namespace {

using std::make_shared;

/// Returns creatures in a room. The first body is held, some points start at -0, and some velocities become
/// denormal.
sim::Scene inTheRoom(int creatures)
{
    sim::Scene scene = bench::crowd::inTheRoom(creatures);
    scene.start.inverseMass[0] = 0.0;
    scene.start.setVelocity(0, {1.0, -2.0});
    scene.start.setVelocity(1, {-0.0, -0.0});
    scene.start.setVelocity(2, {1e-300, -1e-307});
    scene.start.place(3, {-0.0, bench::crowd::floor});
    return scene;
}

sim::Scene inTheAir(int creatures)
{
    return bench::crowd::inTheAir(creatures);
}

std::vector<int> indices(int first, int count)
{
    std::vector<int> all(static_cast<std::size_t>(count));
    std::iota(all.begin(), all.end(), first);
    return all;
}

/// Returns creatures above a ground that stops only bodies and the first `feet` feet.
sim::Scene onGround(int creatures, int feet)
{
    sim::Scene scene = bench::crowd::inTheAir(creatures);
    scene.effects.push_back(make_shared<sim::Gravity>(0.5));
    scene.effects.push_back(make_shared<sim::Ground>(indices(0, (feet + 1) * creatures),
                                                     sim::GroundPlane{300.0, 0.2, sim::Traction::full}));
    return scene;
}

sim::Scene allPointsOnGround(int creatures)
{
    return onGround(creatures, bench::crowd::feet);
}

/// Returns creatures in a room that acts as a constraint. Only two points are damped.
sim::Scene withFriction(int creatures)
{
    sim::Scene scene = onGround(creatures, 2);
    scene.effects[1] = make_shared<sim::Damping>(0.9, sim::PointRange{0, 2});
    const Eigen::ArrayXd half = Eigen::ArrayXd::Constant(scene.start.pointCount(), 5.0);
    scene.effects.push_back(make_shared<sim::RoomLimits>(sim::Room{50.0, 500.0, 290.0, 0.0}, half, 0.4));
    return scene;
}

sim::Pipeline pipelineOf(const sim::Scene &scene, const char *method, double h = 1.0)
{
    return sim::compose(scene, *sim::findMethod(method), sim::StepSize::ofLength(h));
}

/// Returns the number of kernels in a step before and after fusing, as "7 to 4".
std::string kernelCounts(const sim::Scene &scene, const char *method)
{
    const sim::Pipeline pipeline = pipelineOf(scene, method);
    std::size_t all = 0;
    for (const sim::Phase &phase : pipeline.phases)
        all += phase.kernels.size();
    return std::to_string(all) + " to " + std::to_string(pipeline.kernels.size());
}

}

/// Fusing gravity, kick, damping and move into one kernel gives the same bits.
class TestFusedMotion : public QObject
{
    Q_OBJECT

private slots:
    void gravityKickDampingAndMoveBecomeOneKernel_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<QString>("room");
        QTest::addColumn<QString>("air");
        // the counts include the kernel that clears the accelerations
        QTest::newRow("semi-implicit Euler") << "semi_implicit_euler"
                                             << "7 to 4"
                                             << "5 to 3";
        QTest::newRow("published, whose forces act immediately") << "published"
                                                                 << "10 to 10"
                                                                 << "6 to 6";
        QTest::newRow("explicit Euler, which moves first") << "explicit_euler"
                                                           << "7 to 7"
                                                           << "5 to 5";
        QTest::newRow("position Verlet, half a move last") << "position_verlet"
                                                           << "9 to 6"
                                                           << "7 to 5";
        QTest::newRow("velocity Verlet, half a kick last") << "velocity_verlet"
                                                           << "12 to 9"
                                                           << "9 to 7";
    }
    void gravityKickDampingAndMoveBecomeOneKernel()
    {
        QFETCH(QString, method);
        QFETCH(QString, room);
        QFETCH(QString, air);
        const QByteArray id = method.toUtf8();
        QCOMPARE(kernelCounts(bench::crowd::inTheRoom(3), id), room.toStdString());
        QCOMPARE(kernelCounts(inTheAir(3), id), air.toStdString());
    }

    void effectsOnSomePointsAreNotFused()
    {
        sim::Scene scene = bench::crowd::inTheRoom(3);
        scene.effects[2] = make_shared<sim::Damping>(0.9, sim::PointRange{0, 17});
        QCOMPARE(kernelCounts(scene, "semi_implicit_euler"), std::string("7 to 7"));
        scene = bench::crowd::inTheRoom(3);
        scene.groups[1].motion = sim::Motion::prescribed; // bodies move along a prescribed path
        QCOMPARE(kernelCounts(scene, "semi_implicit_euler"), std::string("7 to 7"));
        scene = bench::crowd::inTheRoom(3);
        scene.effects.push_back(make_shared<sim::Gravity>(-0.2)); // of two gravities only the second is fused
        QCOMPARE(kernelCounts(scene, "semi_implicit_euler"), std::string("8 to 5"));
        // Constraints need the positions before the move.
        QCOMPARE(kernelCounts(withFriction(3), "semi_implicit_euler"), std::string("10 to 10"));
    }

    void fusedKernelGivesTheSameBits_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<int>("creatures");
        QTest::addColumn<double>("h");
        for (const char *method :
             {"semi_implicit_euler", "published", "explicit_euler", "position_verlet", "velocity_verlet"}) {
            for (const int creatures : {1, 7, 60}) {
                for (const double h : {1.0, 0.25})
                    QTest::addRow("%s, %d creatures, h = %g", method, creatures, h)
                        << QString(method) << creatures << h;
            }
        }
    }
    void fusedKernelGivesTheSameBits()
    {
        QFETCH(QString, method);
        QFETCH(int, creatures);
        QFETCH(double, h);
        const sim::FlushDenormals flush;
        for (const auto &scene : {inTheRoom, inTheAir, allPointsOnGround, withFriction}) {
            const sim::Scene chosen = scene(creatures);
            const sim::Pipeline pipeline = pipelineOf(chosen, method.toUtf8(), h);
            sim::State plain = chosen.start;
            sim::findMethod(method.toStdString())->prepareState(plain);
            sim::State state = plain;
            for (int step = 0; step < 300; ++step) {
                if (step == 100 || step == 150) { // a foot is grabbed, and released later
                    for (sim::State *run : {&plain, &state})
                        run->inverseMass[creatures] = step == 100 ? 0.0 : 1.0;
                }
                for (const sim::Phase &phase : pipeline.phases)
                    phase.run(plain);
                sim::runStep(pipeline, state);
                QVERIFY2(sim::sameBits(state, plain), support::difference(state, plain).c_str());
            }
        }
    }
};

SUITE(tst_fused_motion, TestFusedMotion)
#include "tst_fused_motion.moc"

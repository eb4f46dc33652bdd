// Idle effects, whose parameters make them change nothing, get no phase.

#include "sim/run/script/composed_interval.h"
#include "tests/sim/support/support.h"

#include "sim/effects/contacts/ground.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/motor.h"
#include "sim/effects/drivers/turn_round.h"
#include "sim/effects/fields/breeze.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/offset_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/push.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/effects/springs/springs.h"
#include "sim/effects/tree/return_to_rest.h"
#include "sim/effects/tree/torsion.h"
#include "sim/effects/tree/wind_torque.h"
#include "sim/methods/methods.h"
#include "sim/scenes/trees.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <limits>

using namespace sim;
using std::make_shared;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr int feet = 3;
constexpr int frames = 60;

/// An effect that never says that it is idle.
template <class Type>
class NeverIdle : public Type
{
public:
    using Type::Type;
    bool isIdle() const override { return false; }
};

struct Case
{
    std::string name;
    EffectPtr idle;
    EffectPtr neverIdle; ///< as `idle`, but computed
    EffectPtr active;    ///< as `idle`, with parameters that change something
    bool inTree = false;
};

template <class Type, class... Rest>
std::pair<EffectPtr, EffectPtr> idlePair(Rest... rest)
{
    return {make_shared<Type>(rest...), make_shared<NeverIdle<Type>>(rest...)};
}

TreePtr smallTree()
{
    return make_shared<const Tree>(scenes::bush());
}

/// Returns the idle effects. Those of walkers use gait clock 0.
std::vector<Case> cases()
{
    const std::vector<Link> links = scenes::legs(feet);
    const std::vector<Link> oneWay = {{0, feet}, {1, feet}};
    const Eigen::ArrayXd half = Eigen::ArrayXd::Constant(feet + 1, 5.0);
    const std::vector<Leg> legs = {{0, feet, 0.3, 0}, {1, feet, 3.0, 0}};
    const std::vector<int> clocks(feet + 1, 0);
    const TreePtr tree = smallTree();
    const BranchMechanics mechanics = branchMechanicsOf(*tree, 0.1);
    const auto legRule = [](double k) { return LegRule{k, 50.0, 50.0, Aim::swing, Reaction::equal}; };
    const Room endless = {-infinity, infinity, infinity, 0.5}, sides = {20, 520, infinity, 0.5};
    std::vector<Case> all;
    const auto add = [&](std::string name, std::pair<EffectPtr, EffectPtr> pair, EffectPtr active,
                         bool inTree = false) {
        all.push_back({std::move(name), pair.first, pair.second, std::move(active), inTree});
    };
    add("gravity", idlePair<Gravity>(0.0), make_shared<Gravity>(1e-300));
    add("damping", idlePair<Damping>(1.0), make_shared<Damping>(std::nextafter(1.0, 0.0)));
    add("damping of some", idlePair<Damping>(1.0, PointRange{0, 2}),
        make_shared<Damping>(0.0, PointRange{0, 2}));
    add("body_spring", idlePair<BodySpring>(links, 0.0), make_shared<BodySpring>(links, 1e-9));
    add("offset_spring", idlePair<OffsetSpring>(oneWay, 0.0, 50.0),
        make_shared<OffsetSpring>(oneWay, 1e-9, 50.0));
    add("radial_spring", idlePair<RadialSpring>(links, 0.0, 50.0),
        make_shared<RadialSpring>(links, 1e-9, 50.0));
    add("springs", idlePair<Springs>(std::vector<Spring>{{0, feet, 0.0, 9.0}}, feet + 1),
        make_shared<Springs>(std::vector<Spring>{{0, feet, 1e-9, 9.0}}, feet + 1));
    add("breeze", idlePair<Breeze>(BreezeStrength{0.0, 0.5}, half, 0),
        make_shared<Breeze>(BreezeStrength{1e-9, 0.5}, half, 0));
    add("point_spring", idlePair<PointSpring>(1, Vec2{90, 90}, 0.0),
        make_shared<PointSpring>(1, Vec2{90, 90}, 1e-9));
    add("leg_spring", idlePair<LegSpring>(legs, legRule(0.0)), make_shared<LegSpring>(legs, legRule(1e-9)));
    add("push without force", idlePair<Push>(std::vector<int>{0, 1, 2}, 0.0, 90.0, Reaction::equal),
        make_shared<Push>(std::vector<int>{0, 1, 2}, 1e-9, 90.0, Reaction::equal));
    add("push without reach", idlePair<Push>(std::vector<int>{0, 1, 2}, 0.1, 0.0, Reaction::equal),
        make_shared<Push>(std::vector<int>{0, 1, 2}, 0.1, 1e-9, Reaction::equal));
    add("motor", idlePair<Motor>(0, 0.0, 0.25), make_shared<Motor>(0, 0.9, 0.25));
    add("motor without time", idlePair<Motor>(0, 0.9, 0.0), make_shared<Motor>(0, 0.9, 1e-3));
    add("ground", idlePair<Ground>(std::vector<int>{0, 1}, GroundPlane{infinity, 0.3, Traction::full}),
        make_shared<Ground>(std::vector<int>{0, 1}, GroundPlane{-infinity, 0.3, Traction::full}));
    add("walls", idlePair<Walls>(endless, half), make_shared<Walls>(sides, half));
    add("turn_round", idlePair<TurnRound>(endless, half, clocks),
        make_shared<TurnRound>(sides, half, clocks));
    add("torsion", idlePair<Torsion>(tree, branchMechanicsOf(*tree, 0.0)),
        make_shared<Torsion>(tree, mechanics), true);
    add("wind", idlePair<WindTorque>(tree, mechanics.inertia, 0.0, 0.5),
        make_shared<WindTorque>(tree, mechanics.inertia, 1e-9, 0.5), true);
    add("return_to_rest", idlePair<ReturnToRest>(tree, infinity), make_shared<ReturnToRest>(tree, 1e9), true);
    return all;
}

/// Returns damped points that fall on springs, or damped branches that turn.
Scene sceneOf(const Case &testCase)
{
    Scene scene;
    if (testCase.inTree) {
        scene = scenes::branchesOf(*smallTree());
        scenes::enableSpins(scene);
        scene.start.spin.setLinSpaced(-1.0, 2.0);
        scene.start.input.pointer = Vec2{100.0, 50.0};
        scene.start.gustExtent.front = 500.0;
        scenes::add<SpinDamping>(scene, 0.95);
    } else {
        scene = scenes::springCreature(feet, 0.2, 40.0);
        support::scatter(scene.start, 5, 200.0);
        scene.start.velocity.col(0).setLinSpaced(-1.0, 2.0);
        scene.start.gait.setConstant(1, 0.2);
        scene.start.gaitSpeed.setConstant(1, 0.1);
        scenes::add<Gravity>(scene, 0.5);
        scenes::add<Damping>(scene, 0.9);
    }
    return scene;
}

/// Returns `scene` with `effect` as its second effect. As the first effect it could change when drivers run.
Scene sceneWith(Scene scene, const EffectPtr &effect)
{
    scene.effects.insert(scene.effects.begin() + 1, effect);
    return scene;
}

Pipeline pipelineOf(const Scene &scene, const std::string &method)
{
    const MethodPtr rule = findMethod(method);
    return compose(scene, *rule, support::stepFor(*rule, 1.0));
}

/// Returns how far two arrays differ, or an empty string. 0 equals -0.
std::string differenceOf(const Eigen::ArrayXXd &a, const Eigen::ArrayXXd &b, const char *quantity)
{
    return (a == b).all() ? ""
                          : std::string(quantity) + " differ by " + std::to_string((a - b).abs().maxCoeff());
}

}

class TestIdle : public QObject
{
    Q_OBJECT

private slots:
    void idleEffectsAreRecognised_data() { addCases(); }
    void idleEffectsAreRecognised()
    {
        const Case testCase = current();
        QVERIFY(testCase.idle->isIdle());
        QVERIFY(!testCase.active->isIdle());
    }

    void idleEffectMakesNoPhaseAndIsListed_data() { addCases(); }
    void idleEffectMakesNoPhaseAndIsListed()
    {
        const Case testCase = current();
        const Scene scene = sceneWith(sceneOf(testCase), testCase.idle);
        int fitting = 0;
        for (const MethodPtr &method : allMethods()) {
            if (!support::fits(sceneOf(testCase), *method))
                continue;
            ++fitting;
            const Pipeline pipeline = pipelineOf(scene, method->id());
            QCOMPARE(pipeline.idleEffects, std::vector<EffectPtr>{testCase.idle});
            for (const Phase &phase : pipeline.phases)
                QVERIFY2(!computes(phase, testCase.idle), phase.id.c_str());
        }
        QVERIFY(fitting > 3);
        QVERIFY(pipelineOf(sceneWith(sceneOf(testCase), testCase.active), "semi_implicit_euler")
                    .idleEffects.empty());
    }

    void omittingAnIdleEffectChangesNoBit_data()
    {
        QTest::addColumn<int>("index");
        QTest::addColumn<QString>("method");
        const std::vector<Case> all = cases();
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (const MethodPtr &method : allMethods()) {
                if (support::fits(sceneWith(sceneOf(all[i]), all[i].neverIdle), *method))
                    QTest::addRow("%s, %s", all[i].name.c_str(), method->id().c_str())
                        << int(i) << QString::fromStdString(method->id());
            }
        }
    }
    void omittingAnIdleEffectChangesNoBit()
    {
        QFETCH(QString, method);
        const Case testCase = current();
        const std::string id = method.toStdString();
        const State without = support::plainRun(sceneOf(testCase), id, 1.0, frames);
        const State omitted = support::plainRun(sceneWith(sceneOf(testCase), testCase.idle), id, 1.0, frames);
        QVERIFY2(sameBits(omitted, without), support::difference(omitted, without).c_str());
        const State computed =
            support::plainRun(sceneWith(sceneOf(testCase), testCase.neverIdle), id, 1.0, frames);
        for (const std::string &found : {differenceOf(computed.position, without.position, "places"),
                                         differenceOf(computed.velocity, without.velocity, "velocities"),
                                         differenceOf(computed.angle, without.angle, "angles"),
                                         differenceOf(computed.spin, without.spin, "spins"),
                                         differenceOf(computed.gaitSpeed, without.gaitSpeed, "gait speeds")})
            QVERIFY2(found.empty(), found.c_str());
    }

    void idleContactDoesNotExcludeAMethod()
    {
        // Methods without contacts accept a contact that no point can reach.
        Scene scene = scenes::creature(feet);
        scene.effects = {make_shared<Gravity>(0.5)};
        const Eigen::ArrayXd half = Eigen::ArrayXd::Constant(feet + 1, 5.0);
        int fittingWithWalls = 0;
        for (const MethodPtr &method : allMethods()) {
            if (!support::fits(scene, *method))
                continue;
            fittingWithWalls +=
                support::fits(sceneWith(scene, make_shared<Walls>(Room{20, 520, 380, 0.5}, half)), *method);
            QVERIFY(support::fits(
                sceneWith(scene, make_shared<Walls>(Room{-infinity, infinity, infinity, 0.5}, half)),
                *method));
        }
        QVERIFY(fittingWithWalls > 0);
    }

    void parameterCanActivateAnIdleEffect()
    {
        // Gravity is 0, then 0.5 from the output step that ends at frame 11. By semi-implicit Euler the body
        // falls 0.5 (1 + 2 + ... + n) px in n frames.
        support::Sample sample{"fall",
                               [](const Values &values) {
                                   Scene scene = scenes::creature(1);
                                   scene.effects = {make_shared<Gravity>(values["gravity"])};
                                   return scene;
                               },
                               {}};
        sample.values.set("gravity", 0.0);
        Script script = support::script(sample, "semi_implicit_euler");
        script.input = {{11, Set{"gravity", 0.5}}, {21, Set{"gravity", 0.0}}};
        Track track(script, 1 << 20);
        track.seek({10, 0});
        QCOMPARE(track.state().positionOf(1).y, 200.0);
        QCOMPARE(track.interval().pipeline.idleEffects.size(), std::size_t(1));
        track.seek({20, 0});
        QCOMPARE(track.state().positionOf(1).y, 200.0 + 0.5 * 55);
        QVERIFY(track.interval().pipeline.idleEffects.empty());
        track.seek({30, 0});
        QCOMPARE(track.state().positionOf(1).y, 200.0 + 0.5 * 55 + 10 * 5.0);
        QCOMPARE(track.interval().pipeline.idleEffects.size(), std::size_t(1));
    }

private:
    static void addCases()
    {
        QTest::addColumn<int>("index");
        const std::vector<Case> all = cases();
        for (std::size_t i = 0; i < all.size(); ++i)
            QTest::addRow("%s", all[i].name.c_str()) << int(i);
    }
    static Case current()
    {
        QFETCH(int, index);
        return cases()[std::size_t(index)];
    }
};

SUITE(tst_idle, TestIdle)
#include "tst_idle.moc"

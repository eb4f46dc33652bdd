// What a scene lists although it can change nothing costs nothing: no phase computes it.

#include "sim/run/script/composed_interval.h"
#include "support.h"

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

#include <QTest>

#include <algorithm>
#include <limits>

using namespace sim;
using std::make_shared;

namespace {

constexpr double never = std::numeric_limits<double>::infinity();
constexpr int feet = 3;
constexpr int frames = 60;

/// The same effect, which does not know that it is idle.
template <class Type>
class Busy : public Type
{
public:
    using Type::Type;
    bool isIdle() const override { return false; }
};

struct Case
{
    std::string name;
    EffectPtr idle;
    EffectPtr busy;   ///< the same, computed all the same
    EffectPtr almost; ///< can change something
    bool inTree = false;
};

template <class Type, class... Rest>
std::pair<EffectPtr, EffectPtr> both(Rest... rest)
{
    return {make_shared<Type>(rest...), make_shared<Busy<Type>>(rest...)};
}

TreePtr smallTree()
{
    return make_shared<const Tree>(scenes::bush());
}

/// What hangs on the state of a walker: its gait clock is number 0.
std::vector<Case> cases()
{
    const std::vector<Link> links = scenes::legs(feet);
    const std::vector<Link> oneWay = {{0, feet}, {1, feet}};
    const Eigen::ArrayXd half = Eigen::ArrayXd::Constant(feet + 1, 5.0);
    const std::vector<Leg> legs = {{0, feet, 0.3, 0}, {1, feet, 3.0, 0}};
    const std::vector<int> clocks(feet + 1, 0);
    const TreePtr tree = smallTree();
    const BranchMechanics limbs = branchMechanicsOf(*tree, 0.1);
    const auto legRule = [](double k) { return LegRule{k, 50.0, 50.0, Aim::swing, Reaction::equal}; };
    const Room endless = {-never, never, never, 0.5}, sides = {20, 520, never, 0.5};
    std::vector<Case> all;
    const auto add = [&](std::string name, std::pair<EffectPtr, EffectPtr> pair, EffectPtr almost,
                         bool inTree = false) {
        all.push_back({std::move(name), pair.first, pair.second, std::move(almost), inTree});
    };
    add("gravity", both<Gravity>(0.0), make_shared<Gravity>(1e-300));
    add("damping", both<Damping>(1.0), make_shared<Damping>(std::nextafter(1.0, 0.0)));
    add("damping of some", both<Damping>(1.0, PointRange{0, 2}), make_shared<Damping>(0.0, PointRange{0, 2}));
    add("body_spring", both<BodySpring>(links, 0.0), make_shared<BodySpring>(links, 1e-9));
    add("offset_spring", both<OffsetSpring>(oneWay, 0.0, 50.0),
        make_shared<OffsetSpring>(oneWay, 1e-9, 50.0));
    add("radial_spring", both<RadialSpring>(links, 0.0, 50.0), make_shared<RadialSpring>(links, 1e-9, 50.0));
    add("springs", both<Springs>(std::vector<Spring>{{0, feet, 0.0, 9.0}}, feet + 1),
        make_shared<Springs>(std::vector<Spring>{{0, feet, 1e-9, 9.0}}, feet + 1));
    add("breeze", both<Breeze>(BreezeStrength{0.0, 0.5}, half, 0),
        make_shared<Breeze>(BreezeStrength{1e-9, 0.5}, half, 0));
    add("point_spring", both<PointSpring>(1, Vec2{90, 90}, 0.0),
        make_shared<PointSpring>(1, Vec2{90, 90}, 1e-9));
    add("leg_spring", both<LegSpring>(legs, legRule(0.0)), make_shared<LegSpring>(legs, legRule(1e-9)));
    add("push without force", both<Push>(std::vector<int>{0, 1, 2}, 0.0, 90.0, Reaction::equal),
        make_shared<Push>(std::vector<int>{0, 1, 2}, 1e-9, 90.0, Reaction::equal));
    add("push without reach", both<Push>(std::vector<int>{0, 1, 2}, 0.1, 0.0, Reaction::equal),
        make_shared<Push>(std::vector<int>{0, 1, 2}, 0.1, 1e-9, Reaction::equal));
    add("motor", both<Motor>(0, 0.0, 0.25), make_shared<Motor>(0, 0.9, 0.25));
    add("motor without time", both<Motor>(0, 0.9, 0.0), make_shared<Motor>(0, 0.9, 1e-3));
    add("ground", both<Ground>(std::vector<int>{0, 1}, GroundPlane{never, 0.3, Traction::full}),
        make_shared<Ground>(std::vector<int>{0, 1}, GroundPlane{-never, 0.3, Traction::full}));
    add("walls", both<Walls>(endless, half), make_shared<Walls>(sides, half));
    add("turn_round", both<TurnRound>(endless, half, clocks), make_shared<TurnRound>(sides, half, clocks));
    add("torsion", both<Torsion>(tree, branchMechanicsOf(*tree, 0.0)), make_shared<Torsion>(tree, limbs),
        true);
    add("wind", both<WindTorque>(tree, limbs.inertia, 0.0, 0.5),
        make_shared<WindTorque>(tree, limbs.inertia, 1e-9, 0.5), true);
    add("return_to_rest", both<ReturnToRest>(tree, never), make_shared<ReturnToRest>(tree, 1e9), true);
    return all;
}

/// Points on springs, which fall and are slowed; or branches that turn and are slowed.
Scene sceneOf(const Case &one)
{
    Scene scene;
    if (one.inTree) {
        scene = scenes::branchesOf(*smallTree());
        scenes::letSwing(scene);
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

/// With `effect` among the others: not the first, which would decide when a driver runs.
Scene with(Scene scene, const EffectPtr &effect)
{
    scene.effects.insert(scene.effects.begin() + 1, effect);
    return scene;
}

bool computes(const Phase &phase, const EffectPtr &effect)
{
    return phase.effect == effect || std::find(phase.innerEffects.begin(), phase.innerEffects.end(),
                                               effect) != phase.innerEffects.end();
}

Pipeline pipelineOf(const Scene &scene, const std::string &method)
{
    const MethodPtr rule = findMethod(method);
    return compose(scene, *rule, support::stepFor(*rule, 1.0));
}

/// Where two runs differ, 0 and -0 being one number.
std::string differs(const Eigen::ArrayXXd &a, const Eigen::ArrayXXd &b, const char *what)
{
    return (a == b).all() ? "" : std::string(what) + " differ by " + std::to_string((a - b).abs().maxCoeff());
}

}

class TestIdle : public QObject
{
    Q_OBJECT

private slots:
    void whatCanChangeNothingIsIdle_data() { addCases(); }
    void whatCanChangeNothingIsIdle()
    {
        const Case one = current();
        QVERIFY(one.idle->isIdle());
        QVERIFY(!one.almost->isIdle());
    }

    void whatIsIdleMakesNoPhaseAndIsTold_data() { addCases(); }
    void whatIsIdleMakesNoPhaseAndIsTold()
    {
        const Case one = current();
        const Scene scene = with(sceneOf(one), one.idle);
        int fitting = 0;
        for (const MethodPtr &method : allMethods()) {
            if (!support::fits(sceneOf(one), *method))
                continue;
            ++fitting;
            const Pipeline pipeline = pipelineOf(scene, method->id());
            QCOMPARE(pipeline.idleEffects, std::vector<EffectPtr>{one.idle});
            for (const Phase &phase : pipeline.phases)
                QVERIFY2(!computes(phase, one.idle), phase.id.c_str());
        }
        QVERIFY(fitting > 3);
        QVERIFY(pipelineOf(with(sceneOf(one), one.almost), "semi_implicit_euler").idleEffects.empty());
    }

    void leavingItOutChangesNoBit_data()
    {
        QTest::addColumn<int>("index");
        QTest::addColumn<QString>("method");
        const std::vector<Case> all = cases();
        for (std::size_t i = 0; i < all.size(); ++i) {
            for (const MethodPtr &method : allMethods()) {
                if (support::fits(with(sceneOf(all[i]), all[i].busy), *method))
                    QTest::addRow("%s, %s", all[i].name.c_str(), method->id().c_str())
                        << int(i) << QString::fromStdString(method->id());
            }
        }
    }
    void leavingItOutChangesNoBit()
    {
        QFETCH(QString, method);
        const Case one = current();
        const std::string id = method.toStdString();
        const State without = support::plainRun(sceneOf(one), id, 1.0, frames);
        const State leftOut = support::plainRun(with(sceneOf(one), one.idle), id, 1.0, frames);
        QVERIFY2(sameBits(leftOut, without), support::difference(leftOut, without).c_str());
        const State computed = support::plainRun(with(sceneOf(one), one.busy), id, 1.0, frames);
        for (const std::string &what :
             {differs(computed.position, without.position, "places"),
              differs(computed.velocity, without.velocity, "velocities"),
              differs(computed.angle, without.angle, "angles"), differs(computed.spin, without.spin, "spins"),
              differs(computed.gaitSpeed, without.gaitSpeed, "gait speeds")})
            QVERIFY2(what.empty(), what.c_str());
    }

    void aMethodMeetsNoneOfThem()
    {
        // A contact that cannot be met does not keep a method away that knows no contacts.
        Scene scene = scenes::creature(feet);
        scene.effects = {make_shared<Gravity>(0.5)};
        const Eigen::ArrayXd half = Eigen::ArrayXd::Constant(feet + 1, 5.0);
        int kept = 0;
        for (const MethodPtr &method : allMethods()) {
            if (!support::fits(scene, *method))
                continue;
            kept += support::fits(with(scene, make_shared<Walls>(Room{20, 520, 380, 0.5}, half)), *method);
            QVERIFY(support::fits(with(scene, make_shared<Walls>(Room{-never, never, never, 0.5}, half)),
                                  *method));
        }
        QVERIFY(kept > 0);
    }

    void aParameterBringsItBackInTheMiddleOfARun()
    {
        // From rest under gravity 0, then 0.5 from the row that ends at frame 11: by the rule of semi-implicit Euler
        // the body falls 0.5 (1 + 2 + ... + n) px in n frames.
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

QTEST_APPLESS_MAIN(TestIdle)
#include "tst_idle.moc"

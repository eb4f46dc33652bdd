// Each effect against its closed form, computed independently.

#include "tests/sim/support/support.h"

#include "sim/base/error.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/breeze.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/offset_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/effects/springs/springs.h"
#include "tests/suite.h"

#include <QTest>

#include <numbers>

#include <complex>

using namespace sim;
using support::Dice;

namespace {

constexpr int footCount = 3; // with the body: four points

using ForcePtr = std::shared_ptr<const Force>;

State randomMovingState(Dice &dice)
{
    State state = State::ofPoints(footCount + 1);
    for (int i = 0; i <= footCount; ++i) {
        state.place(i, {dice.real(-1000, 1000), dice.real(-1000, 1000)});
        state.setVelocity(i, {dice.real(-20, 20), dice.real(-20, 20)});
        state.inverseMass[i] = dice.chance(0.3) ? 0.0 : dice.chance(0.5) ? 1.0 : dice.real(0.1, 3.0);
    }
    return state;
}

Eigen::ArrayX2d accelerationsOfAll(const Force &force, const State &state, double scale,
                                   DirectionRule directionRule)
{
    Eigen::ArrayX2d accelerations = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
    force.add(state, {0, state.pointCount()}, scale, directionRule, accelerations);
    return accelerations;
}

bool near(Vec2 a, Vec2 b, double tolerance)
{
    return length(a - b) <= tolerance;
}

}

class TestEffects : public QObject
{
    Q_OBJECT

private:
    static constexpr double k = 0.23;

    static void addForceRows()
    {
        QTest::addColumn<ForcePtr>("force");
        QTest::addColumn<DirectionRule>("directionRule");
        const std::vector<std::pair<const char *, ForcePtr>> forces = {
            {"spring to a point", std::make_shared<PointSpring>(1, Vec2{270, 200}, k)},
            {"spring to a body", std::make_shared<BodySpring>(std::vector<Link>{{0, footCount}}, k)},
            {"springs to every foot", std::make_shared<BodySpring>(scenes::legs(footCount), k)},
            {"spring with an offset", std::make_shared<OffsetSpring>(scenes::legs(footCount), k, 50)},
            {"radial springs", std::make_shared<RadialSpring>(scenes::legs(footCount), k, 50)},
            {"radial spring of length 0", std::make_shared<RadialSpring>(std::vector<Link>{{2, 1}}, k, 0)},
            {"gravity", std::make_shared<Gravity>(0.5)},
            {"springs with individual stiffness",
             std::make_shared<Springs>(std::vector<Spring>{{0, 1, k, 50}, {2, 1, 0.4 * k, 20}},
                                       footCount + 1)},
        };
        for (const auto &[name, force] : forces) {
            QTest::addRow("%s, regularised", name) << force << DirectionRule::regularised;
            QTest::addRow("%s, as published", name) << force << DirectionRule::published;
        }
    }

private slots:
    void springsFollowHookesLaw_data()
    {
        QTest::addColumn<ForcePtr>("force");
        QTest::addColumn<std::function<Vec2(const State &)>>("target");
        using Target = std::function<Vec2(const State &)>;
        const std::vector<Link> link = {{1, 2}};
        QTest::newRow("to a point") << ForcePtr(std::make_shared<PointSpring>(1, Vec2{270, 200}, k))
                                    << Target([](const State &) {
                                           return Vec2{270, 200};
                                       });
        QTest::newRow("to a body") << ForcePtr(std::make_shared<BodySpring>(link, k))
                                   << Target([](const State &s) { return s.positionOf(2); });
        QTest::newRow("beside a body")
            << ForcePtr(std::make_shared<OffsetSpring>(link, k, -35.5)) << Target([](const State &s) {
                   return s.positionOf(2) + Vec2{-35.5, 0};
               });
    }
    void springsFollowHookesLaw()
    {
        QFETCH(ForcePtr, force);
        QFETCH(std::function<Vec2(const State &)>, target);
        Dice dice(1);
        for (int run = 0; run < 2000; ++run) {
            const State state = randomMovingState(dice);
            const Eigen::ArrayX2d accelerations =
                accelerationsOfAll(*force, state, 1.0, DirectionRule::regularised);
            const std::complex<double> from(state.positionOf(1).x, state.positionOf(1).y);
            const std::complex<double> to(target(state).x, target(state).y);
            const std::complex<double> expected = (to - from) * (k * state.inverseMass[1]);
            QVERIFY(near({accelerations(1, 0), accelerations(1, 1)}, {expected.real(), expected.imag()},
                         1e-12 * 1000));
            QVERIFY((accelerations.row(0) == 0.0).all() && (accelerations.row(2) == 0.0).all() &&
                    (accelerations.row(3) == 0.0).all());
        }
    }

    void radialForceIsProportionalToTheStretch_data()
    {
        QTest::addColumn<DirectionRule>("directionRule");
        QTest::newRow("regularised") << DirectionRule::regularised;
        QTest::newRow("as published") << DirectionRule::published;
    }
    void radialForceIsProportionalToTheStretch()
    {
        QFETCH(DirectionRule, directionRule);
        Dice dice(2);
        for (int run = 0; run < 5000; ++run) {
            const double radius = dice.real(0, 200);
            const RadialSpring force({{0, 1}}, k, radius);
            State state = randomMovingState(dice);
            state.inverseMass[0] = 1.0;
            const Eigen::ArrayX2d accelerations = accelerationsOfAll(force, state, 1.0, directionRule);
            const Vec2 d = state.positionOf(1) - state.positionOf(0);
            const double pull = k * (1.0 - radius / std::hypot(d.x, d.y));
            QVERIFY(near({accelerations(0, 0), accelerations(0, 1)}, pull * d, 1e-10));
        }
    }
    void radialForceIsTheSameForBothDirectionRules()
    {
        Dice dice(3);
        const RadialSpring force(scenes::legs(footCount), k, 50);
        for (int run = 0; run < 5000; ++run) {
            const State state = randomMovingState(dice);
            const Eigen::ArrayX2d a = accelerationsOfAll(force, state, 1.0, DirectionRule::regularised);
            const Eigen::ArrayX2d b = accelerationsOfAll(force, state, 1.0, DirectionRule::published);
            QVERIFY(((a - b).abs() < 1e-10).all());
        }
    }

    void springsEqualRadialSpringsThatActOnBothEnds()
    {
        Dice dice(31);
        for (int run = 0; run < 2000; ++run) {
            const double lengthA = dice.real(0, 200), lengthB = dice.real(0, 200);
            const Springs springs({{0, 1, k, lengthA}, {1, 2, 0.4 * k, lengthB}}, footCount + 1);
            const RadialSpring first({{0, 1}, {1, 0}}, k, lengthA);
            const RadialSpring second({{1, 2}, {2, 1}}, 0.4 * k, lengthB);
            const State state = randomMovingState(dice);
            const Eigen::ArrayX2d sum = accelerationsOfAll(first, state, 1.0, DirectionRule::regularised) +
                                        accelerationsOfAll(second, state, 1.0, DirectionRule::regularised);
            QVERIFY(
                ((accelerationsOfAll(springs, state, 1.0, DirectionRule::regularised) - sum).abs() < 1e-10)
                    .all());
            QCOMPARE(*springs.potentialEnergy(state) > 0.0,
                     state.isDynamic(0) || state.isDynamic(1) || state.isDynamic(2));
        }
    }

    void springWithoutAnEndIsRefused()
    {
        QVERIFY_THROWS_EXCEPTION(Error, Springs({{0, 4, k, 1.0}}, 4));
        QVERIFY_THROWS_EXCEPTION(Error, Springs({{-1, 0, k, 1.0}}, 4));
    }

    void gustsTravelAndAverageToZero()
    {
        Dice dice(32);
        constexpr double wind = 0.3, gusts = 0.8, wave = 2.0 * std::numbers::pi * 100.0;
        const Eigen::ArrayXd width = Eigen::ArrayXd::LinSpaced(footCount + 1, 5, 40);
        const Breeze breeze({wind, gusts}, width, 0);
        for (int run = 0; run < 200; ++run) {
            State state = randomMovingState(dice);
            state.gait.setConstant(1, dice.real(0, 7));
            const Eigen::ArrayX2d accelerationHere =
                accelerationsOfAll(breeze, state, 1.0, DirectionRule::regularised);
            const Eigen::ArrayXd steady = wind * width / 10.0 * state.inverseMass;
            // The crest travels a quarter of a wave while the phase turns by a quarter.
            State later = state;
            later.position.col(0) += wave / 4.0;
            later.gait[0] += std::numbers::pi / 2.0;
            const Eigen::ArrayX2d crest = accelerationsOfAll(breeze, later, 1.0, DirectionRule::regularised);
            QVERIFY(((accelerationHere - crest).abs() < 1e-12).all());
            later.position.col(0) -= wave / 2.0; // half a wave away is the trough
            const Eigen::ArrayX2d trough = accelerationsOfAll(breeze, later, 1.0, DirectionRule::regularised);
            QVERIFY(((0.5 * (crest + trough).col(0) - steady).abs() < 1e-12).all());
            QVERIFY((accelerationHere.col(1) == 0.0).all());
            QVERIFY(((accelerationHere.col(0) - steady).abs() <= gusts * steady + 1e-12).all());
        }
    }

    void steadyWindIsProportionalToTheWidth()
    {
        State state = State::ofPoints(2);
        state.gait.setZero(1);
        state.inverseMass << 1.0, 0.5;
        const Eigen::ArrayXd width = Eigen::ArrayXd::LinSpaced(2, 10.0, 40.0);
        const Eigen::ArrayX2d pull =
            accelerationsOfAll(Breeze({0.2, 0.0}, width, 0), state, 1.0, DirectionRule::regularised);
        QCOMPARE(pull(0, 0), 0.2);
        QCOMPARE(pull(1, 0), 0.4); // four times the width, twice the mass
    }

    void gravityIsTheSameForEveryMass()
    {
        Dice dice(4);
        const State state = randomMovingState(dice);
        const Eigen::ArrayX2d accelerations =
            accelerationsOfAll(Gravity(0.7), state, 2.0, DirectionRule::regularised);
        for (int i = 0; i < state.pointCount(); ++i) {
            QCOMPARE(accelerations(i, 0), 0.0);
            QCOMPARE(accelerations(i, 1), state.isDynamic(i) ? 2.0 * 0.7 : 0.0);
        }
    }

    void dampingFactorMatchesAnyStep_data()
    {
        QTest::addColumn<double>("damp");
        for (const double damp : {0.0, 0.5, 0.85, 0.9, 1.0})
            QTest::addRow("damp %g", damp) << damp;
    }
    void dampingFactorMatchesAnyStep()
    {
        QFETCH(double, damp);
        const Damping drag(damp);
        QCOMPARE(drag.velocityFactor(1.0), damp); // exactly, because tst_published_rule compares bits
        for (const double h : {0.001, 0.25, 1.0 / 3, 2.0, 10.0}) {
            const double closed = damp == 0.0 ? 0.0 : std::exp(h * std::log(damp));
            QVERIFY(std::abs(drag.velocityFactor(h) - closed) <= 1e-15);
            QVERIFY(std::abs(drag.velocityFactor(h) * drag.velocityFactor(h) - drag.velocityFactor(2 * h)) <=
                    1e-15);
        }
    }

    void explainedPullIsWhatIsAdded_data() { addForceRows(); }
    void explainedPullIsWhatIsAdded()
    {
        QFETCH(ForcePtr, force);
        QFETCH(DirectionRule, directionRule);
        Dice dice(5);
        for (int run = 0; run < 500; ++run) {
            const State state = randomMovingState(dice);
            const Eigen::ArrayX2d accelerations = accelerationsOfAll(*force, state, 1.0, directionRule);
            for (int i = 0; i < state.pointCount(); ++i) {
                const std::vector<LiveValue> live = force->explain(state, i, directionRule);
                if (live.empty()) {
                    QVERIFY((accelerations.row(i) == 0.0).all());
                    continue;
                }
                QCOMPARE(live.back().name, std::string("pull"));
                const Vec2 pull = std::get<Vec2>(live.back().value);
                QVERIFY2(pull == (Vec2{accelerations(i, 0), accelerations(i, 1)}),
                         qPrintable(QString("mass %1").arg(1.0 / state.inverseMass[i])));
            }
        }
    }

    void fixedPointsGetNoForce_data() { addForceRows(); }
    void fixedPointsGetNoForce()
    {
        QFETCH(ForcePtr, force);
        QFETCH(DirectionRule, directionRule);
        Dice dice(6);
        State state = randomMovingState(dice);
        state.inverseMass.setZero();
        QVERIFY((accelerationsOfAll(*force, state, 1.0, directionRule) == 0.0).all());
        QCOMPARE(force->count(state, {0, state.pointCount()}), 0);
        for (int i = 0; i < state.pointCount(); ++i)
            QVERIFY(force->explain(state, i, directionRule).empty());
    }

    void onlyTheRangeIsChangedAndScaleIsAFactor_data() { addForceRows(); }
    void onlyTheRangeIsChangedAndScaleIsAFactor()
    {
        QFETCH(ForcePtr, force);
        QFETCH(DirectionRule, directionRule);
        Dice dice(7);
        const State state = randomMovingState(dice);
        Eigen::ArrayX2d accelerations = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
        force->add(state, {1, 2}, 0.5, directionRule, accelerations);
        const Eigen::ArrayX2d all = accelerationsOfAll(*force, state, 0.5, directionRule);
        QVERIFY((accelerations.row(0) == 0.0).all() && (accelerations.row(3) == 0.0).all());
        QVERIFY((accelerations.middleRows(1, 2) == all.middleRows(1, 2)).all());
        const Eigen::ArrayX2d unscaled = accelerationsOfAll(*force, state, 1.0, directionRule);
        QVERIFY((0.5 * unscaled - all).abs().maxCoeff() <=
                1e-12); // halving is exact, but sums of forces are rounded
    }

    void countIsTheSumOverPoints_data() { addForceRows(); }
    void countIsTheSumOverPoints()
    {
        QFETCH(ForcePtr, force);
        QFETCH(DirectionRule, directionRule);
        State state = State::ofPoints(footCount + 1);
        int sum = 0;
        for (int i = 0; i <= footCount; ++i)
            sum += force->count(state, {i, 1});
        QCOMPARE(sum, force->count(state, {0, footCount + 1}));
        QVERIFY(sum > 0);
        QVERIFY(!force->regions(directionRule).empty());
    }
};

SUITE(tst_effects, TestEffects)
#include "tst_effects.moc"

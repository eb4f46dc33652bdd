// Effects that make creatures walk, each against its closed form, computed independently.

#include "tests/sim/support/support.h"

#include "sim/effects/contacts/ground.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/drivers/steering.h"
#include "sim/effects/drivers/turn_round.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/push.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <complex>

using namespace sim;
using support::Dice;
using Complex = std::complex<double>;

namespace {

using ForcePtr = std::shared_ptr<const Force>;

constexpr double legStiffness = 0.17;
const std::vector<Leg> twoCreatures = {{0, 2, 0.3, 0}, {1, 2, 2.0, 0}, {3, 5, -1.0, 1}, {4, 5, 4.0, 1}};

/// Returns two creatures with two feet and a body each. Some points are fixed.
State randomCreatures(Dice &dice)
{
    State state = State::ofPoints(6);
    for (int i = 0; i < 6; ++i) {
        state.place(i, {dice.real(-100, 100), dice.real(-100, 100)});
        state.setVelocity(i, {dice.real(-20, 20), dice.real(-20, 20)});
        state.inverseMass[i] = dice.chance(0.3) ? 0.0 : dice.chance(0.5) ? 1.0 : dice.real(0.1, 3.0);
    }
    state.gait.resize(2);
    state.gaitSpeed.resize(2);
    state.gait << dice.real(-10, 10), dice.real(-10, 10);
    state.gaitSpeed << dice.real(-0.2, 0.2), dice.real(-0.2, 0.2);
    return state;
}

LegRule rule(Aim aim, Reaction reaction)
{
    return {legStiffness, 40.0, 30.0, aim, reaction};
}

Eigen::ArrayX2d accelerationsOfMovers(const Force &force, const State &state, PointRange movers,
                                      double scale = 1.0)
{
    Eigen::ArrayX2d accelerations = Eigen::ArrayX2d::Zero(state.pointCount(), 2);
    force.add(state, movers, scale, DirectionRule::regularised, accelerations);
    return accelerations;
}

Complex complexRow(const Eigen::ArrayX2d &values, int i)
{
    return {values(i, 0), values(i, 1)};
}

Complex at(const State &state, int i)
{
    return {state.positionOf(i).x, state.positionOf(i).y};
}

}

class TestWalkingEffects : public QObject
{
    Q_OBJECT

    static void addForceRows()
    {
        QTest::addColumn<ForcePtr>("force");
        QTest::addColumn<bool>("isReciprocal");
        const std::vector<int> all = {0, 1, 2, 3, 4, 5};
        const auto legs = [](Aim aim, Reaction reaction) {
            return ForcePtr(std::make_shared<LegSpring>(twoCreatures, rule(aim, reaction)));
        };
        QTest::newRow("bones") << legs(Aim::bone, Reaction::none) << false;
        QTest::newRow("swinging legs") << legs(Aim::swing, Reaction::none) << false;
        QTest::newRow("swinging legs, felt by the body") << legs(Aim::swing, Reaction::equal) << true;
        QTest::newRow("push") << ForcePtr(std::make_shared<Push>(all, legStiffness, 90.0, Reaction::equal))
                              << true;
        QTest::newRow("push, felt by one")
            << ForcePtr(std::make_shared<Push>(all, legStiffness, 90.0, Reaction::none)) << false;
    }

private slots:
    void legPullsItsFootToItsTarget_data()
    {
        QTest::addColumn<Aim>("aim");
        QTest::newRow("bone") << Aim::bone;
        QTest::newRow("below") << Aim::below;
        QTest::newRow("swing") << Aim::swing;
    }
    void legPullsItsFootToItsTarget()
    {
        QFETCH(Aim, aim);
        Dice dice(1);
        const LegSpring springs(twoCreatures, rule(aim, Reaction::none));
        for (int run = 0; run < 1000; ++run) {
            const State state = randomCreatures(dice);
            const Eigen::ArrayX2d accelerations = accelerationsOfMovers(springs, state, {0, 6});
            for (const Leg &leg : twoCreatures) {
                const double angle = leg.angle + (aim == Aim::swing ? state.gait[leg.clock] : 0.0);
                const Complex drop(0.0, aim == Aim::bone ? 0.0 : 30.0);
                const Complex place = at(state, leg.body) + drop - std::polar(40.0, angle);
                const Complex pull =
                    state.inverseMass[leg.foot] * legStiffness * (place - at(state, leg.foot));
                QVERIFY(std::abs(complexRow(accelerations, leg.foot) - pull) < 1e-12);
            }
            QVERIFY((accelerations.row(2) == 0.0).all() && (accelerations.row(5) == 0.0).all());
        }
    }

    void forcesWithAReactionAddUpToZero_data() { addForceRows(); }
    void forcesWithAReactionAddUpToZero()
    {
        QFETCH(ForcePtr, force);
        QFETCH(bool, isReciprocal);
        Dice dice(2);
        double largest = 0.0;
        for (int run = 0; run < 200; ++run) {
            State state = randomCreatures(dice);
            for (int i = 0; i < 6; ++i)
                state.inverseMass[i] = dice.real(0.1, 3.0);
            Eigen::ArrayX2d accelerations = accelerationsOfMovers(*force, state, {0, 6});
            accelerations.colwise() /= state.inverseMass;
            largest = std::max(largest, accelerations.colwise().sum().abs().maxCoeff());
        }
        QVERIFY(isReciprocal ? largest < 1e-11 : largest > 1.0);
    }

    void groupsOneByOneAddTheSameAsAllAtOnce_data() { addForceRows(); }
    void groupsOneByOneAddTheSameAsAllAtOnce()
    {
        QFETCH(ForcePtr, force);
        Dice dice(3);
        for (int run = 0; run < 200; ++run) {
            const State state = randomCreatures(dice);
            const Eigen::ArrayX2d groupByGroup =
                accelerationsOfMovers(*force, state, {0, 2}) + accelerationsOfMovers(*force, state, {2, 1}) +
                accelerationsOfMovers(*force, state, {3, 2}) + accelerationsOfMovers(*force, state, {5, 1});
            const Eigen::ArrayX2d allAtOnce = accelerationsOfMovers(*force, state, {0, 6});
            QVERIFY(((groupByGroup - allAtOnce).abs() < 1e-12).all());
            QVERIFY(
                ((accelerationsOfMovers(*force, state, {0, 6}, 0.5) - 0.5 * allAtOnce).abs() < 1e-12).all());
            QCOMPARE(force->count(state, {0, 2}) + force->count(state, {2, 1}) + force->count(state, {3, 3}),
                     force->count(state, {0, 6}));
        }
    }

    void explainedPullIsWhatIsAdded_data() { addForceRows(); }
    void explainedPullIsWhatIsAdded()
    {
        QFETCH(ForcePtr, force);
        Dice dice(4);
        for (int run = 0; run < 300; ++run) {
            const State state = randomCreatures(dice);
            const Eigen::ArrayX2d accelerations = accelerationsOfMovers(*force, state, {0, 6});
            for (int i = 0; i < 6; ++i) {
                const std::vector<LiveValue> live = force->explain(state, i, DirectionRule::regularised);
                const Vec2 pull = live.empty() ? Vec2{} : std::get<Vec2>(live.back().value);
                QVERIFY(live.empty() || live.back().name == "pull");
                QVERIFY(std::abs(complexRow(accelerations, i) - Complex(pull.x, pull.y)) < 1e-12);
            }
        }
    }

    void fixedPointsGetNoForce_data() { addForceRows(); }
    void fixedPointsGetNoForce()
    {
        QFETCH(ForcePtr, force);
        Dice dice(5);
        for (int run = 0; run < 200; ++run) {
            State state = randomCreatures(dice);
            const Eigen::ArrayX2d accelerations = accelerationsOfMovers(*force, state, {0, 6});
            for (int i = 0; i < 6; ++i)
                QVERIFY(state.isDynamic(i) || (accelerations.row(i) == 0.0).all());
            state.inverseMass.setZero();
            QCOMPARE(force->count(state, {0, 6}), 0);
        }
    }

    void pushIsProportionalToTheOverlap()
    {
        const Push push({0, 1}, legStiffness, 60.0, Reaction::equal);
        for (const double distance : {0.5, 20.0, 59.9, 60.0, 61.0, 1000.0}) {
            State state = State::ofPoints(2);
            state.place(1, {0.6 * distance, 0.8 * distance});
            const Eigen::ArrayX2d accelerations = accelerationsOfMovers(push, state, {0, 2});
            const double expected = legStiffness * std::max(0.0, 60.0 - distance);
            QVERIFY(std::abs(complexRow(accelerations, 1) - expected * Complex(0.6, 0.8)) < 1e-12);
            QVERIFY(std::abs(complexRow(accelerations, 0) + complexRow(accelerations, 1)) < 1e-12);
        }
    }

    void coincidentPointsArePushedApart()
    {
        const State state = State::ofPoints(2);
        const Push push({0, 1}, legStiffness, 60.0, Reaction::equal);
        for (const DirectionRule directionRule : {DirectionRule::regularised, DirectionRule::published}) {
            Eigen::ArrayX2d accelerations = Eigen::ArrayX2d::Zero(2, 2);
            push.add(state, {0, 2}, 1.0, directionRule, accelerations);
            QVERIFY(std::abs(std::abs(complexRow(accelerations, 0)) - legStiffness * 60.0) < 1e-12);
            QVERIFY(std::abs(complexRow(accelerations, 0) + complexRow(accelerations, 1)) < 1e-12);
        }
    }

    void clocksRunAtTheirSpeedAtAnyStep()
    {
        Dice dice(6);
        const State start = randomCreatures(dice);
        for (const int parts : {1, 4, 10}) {
            State state = start;
            for (int i = 0; i < 7 * parts; ++i)
                GaitClock().drive(state, 1.0 / parts);
            QVERIFY(((state.gait - (start.gait + 7.0 * start.gaitSpeed)).abs() < 1e-12).all());
            QVERIFY((state.position == start.position).all() && (state.gaitSpeed == start.gaitSpeed).all());
        }
    }

    void steeringWithoutInputKeepsTheSpeed()
    {
        Dice dice(7);
        State state = randomCreatures(dice);
        state.gaitSpeed << 3.0, -4.0; // beyond the top speed
        const Steering steering(0, 2, {0.15, 0.004, 200.0});
        steering.drive(state, 1.0);
        QCOMPARE(state.gaitSpeed[0], 3.0);
        state.input.keys.right = true;
        steering.drive(state, 1.0);
        QCOMPARE(state.gaitSpeed[0], 0.15);
        QCOMPARE(state.gaitSpeed[1], -4.0);
    }

    void heldPointReversesNoClock()
    {
        State state = State::ofPoints(2);
        state.gait.setZero(2);
        state.gaitSpeed.setConstant(2, 0.1);
        state.place(0, {95, 0});
        state.place(1, {300, 0});
        state.inverseMass[1] = 0.0;
        const TurnRound turn({0.0, 100.0, 1e9, 0.0}, Eigen::ArrayXd::Constant(2, 5.0), {0, 1});
        turn.drive(state, 1.0);
        QCOMPARE(state.gaitSpeed[0], -0.1);
        QCOMPARE(state.gaitSpeed[1], 0.1);
        state.place(0, {5, 0});
        turn.drive(state, 1.0);
        QCOMPARE(state.gaitSpeed[0], 0.1);
        state.place(0, {50, 0});
        state.gaitSpeed[0] = -0.1;
        turn.drive(state, 1.0);
        QCOMPARE(state.gaitSpeed[0], -0.1);
    }

    void clocksOfOneCreatureReverseTogether()
    {
        State state = State::ofPoints(4);
        for (int i = 0; i < 4; ++i)
            state.place(i, {50, 0});
        state.gaitSpeed.setConstant(4, 0.1);
        // Points 0 and 1 are feet of one creature, point 2 is a foot of another one, point 3 belongs to none.
        const TurnRound turn({0.0, 100.0, 1e9, 0.0}, Eigen::ArrayXd::Constant(4, 5.0), {0, 1, 2, 3},
                             {{1}, {0}, {}, {}});
        state.place(1, {97, 0});
        turn.drive(state, 1.0);
        QCOMPARE(state.gaitSpeed[0], -0.1);
        QCOMPARE(state.gaitSpeed[1], -0.1);
        QCOMPARE(state.gaitSpeed[2], 0.1);
        QCOMPARE(state.gaitSpeed[3], 0.1);
    }

    void groundStopsOnlyItsPoints()
    {
        Dice dice(8);
        const Ground ground({4, 1}, {10.0, 0.4, Traction::none});
        for (int run = 0; run < 500; ++run) {
            const State before = randomCreatures(dice);
            State state = before;
            ground.resolve(state, {0, 5});
            for (int i = 0; i < 6; ++i) {
                const bool isBelow =
                    (i == 1 || i == 4) && before.isDynamic(i) && before.positionOf(i).y > 10.0;
                const Vec2 v = before.velocityOf(i);
                QCOMPARE(state.positionOf(i),
                         (isBelow ? Vec2{before.positionOf(i).x, 10.0} : before.positionOf(i)));
                QVERIFY(length(state.velocityOf(i) - (isBelow ? Vec2{v.x, -0.4 * v.y} : v)) < 1e-12);
            }
            state = before;
            ground.resolve(state, {2, 2});
            QVERIFY((state.position == before.position).all());
        }
    }
};

SUITE(tst_walking_effects, TestWalkingEffects)
#include "tst_walking_effects.moc"

// Constraints against closed forms, and in cases that cannot be satisfied: all points stay finite.

#include "tests/sim/support/support.h"

#include "sim/catalogue/scenes.h"
#include "sim/effects/constraints/angle_limits.h"
#include "sim/effects/constraints/area_stick.h"
#include "sim/effects/constraints/soft_sticks.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/contacts/room_limits.h"
#include "sim/methods/methods.h"
#include "sim/run/finite.h"
#include "sim/run/track.h"
#include "sim/scenes/sticks.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;
using support::Dice;

namespace {

State randomState(Dice &dice, int points)
{
    State state = State::ofPoints(points);
    for (int i = 0; i < points; ++i)
        state.place(i, {dice.real(-300, 300), dice.real(-300, 300)});
    return state;
}

PointRange allPoints(const State &state)
{
    return {0, state.pointCount()};
}

/// Returns points with sticks under gravity. The points in `pinned` are fixed.
Scene hanging(std::vector<Vec2> places, std::vector<Stick> sticks, const std::vector<int> &pinned,
              int iterations)
{
    return scenes::fallingSticks({.places = std::move(places),
                                  .sticks = std::move(sticks),
                                  .pinned = pinned,
                                  .gravity = 0.5,
                                  .damp = 0.99,
                                  .passes = iterations});
}

Scene longChain()
{
    std::vector<Vec2> places;
    for (int i = 0; i <= 1000; ++i)
        places.push_back({0.5 * i, 100});
    return hanging(places, scenes::chainOfSticks(1000, 0.5), {0, 1000}, 10);
}

double angleAt(const State &state, const AngleLimit &limit)
{
    const Vec2 a = state.positionOf(limit.a) - state.positionOf(limit.joint),
               b = state.positionOf(limit.b) - state.positionOf(limit.joint);
    const double angle = (std::atan2(b.y, b.x) - std::atan2(a.y, a.x)) * 180 / 3.14159265358979;
    return angle < 0 ? angle + 360 : angle;
}

}

class TestConstraints : public QObject
{
    Q_OBJECT

private slots:
    void stickHasItsLengthAfterwards_data()
    {
        QTest::addColumn<DirectionRule>("directionRule");
        QTest::newRow("regularised") << DirectionRule::regularised;
        QTest::newRow("as published") << DirectionRule::published;
    }
    /// The middle, weighted by the shares, does not move.
    void stickHasItsLengthAfterwards()
    {
        QFETCH(DirectionRule, directionRule);
        Dice dice(1);
        for (int run = 0; run < 5000; ++run) {
            State state = randomState(dice, 2);
            if (dice.chance(0.1))
                state.place(1, state.positionOf(0));
            const Stick stick = {0, 1, dice.real(0, 300), dice.chance(0.2) ? 1.0 : dice.real(0, 1)};
            const auto middle = [&] {
                return (1 - stick.share) * state.positionOf(0) + stick.share * state.positionOf(1);
            };
            const Vec2 before = middle();
            Sticks({stick}, 2).enforce(state, allPoints(state), directionRule, 1.0);
            QVERIFY(std::abs(length(state.positionOf(0) - state.positionOf(1)) - stick.length) <= 1e-11);
            QVERIFY(length(middle() - before) <= 1e-11);
        }
    }

    void sticksBetweenFixedEndsDoNothing()
    {
        Dice dice(2);
        State state = randomState(dice, 2);
        state.inverseMass.setZero();
        const Sticks sticks({{0, 1, 5, 0.5}}, 2);
        const State before = state;
        sticks.enforce(state, allPoints(state), DirectionRule::regularised, 1.0);
        QVERIFY(sameBits(state, before));
        QCOMPARE(sticks.count(state, allPoints(state)), 0);
    }

    void allPointsStayFinite_data()
    {
        QTest::addColumn<Scene>("scene");
        QTest::newRow("1000 links, pinned at both ends") << longChain();
        const std::vector<Vec2> three = {{0, 0}, {1, 0}, {0, 1}};
        QTest::newRow("a triangle of 1, 1 and 10 px")
            << hanging(three, {{0, 1, 1, 0.5}, {1, 2, 1, 0.5}, {0, 2, 10, 0.5}}, {}, 10);
        QTest::newRow("the same triangle, two corners pinned")
            << hanging(three, {{0, 1, 1, 0.5}, {1, 2, 1, 0.5}, {0, 2, 10, 0.5}}, {0, 2}, 10);
        QTest::newRow("sticks of length 0")
            << hanging(three, {{0, 1, 0, 0.5}, {1, 2, 0, 0.2}, {0, 2, 0, 1}}, {0}, 10);
        QTest::newRow("coincident points")
            << hanging({{5, 5}, {5, 5}, {5, 5}}, {{0, 1, 10, 0.5}, {1, 2, 10, 0.5}, {0, 2, 10, 0.5}}, {}, 3);
        QTest::newRow("the same stick three times, once with another length")
            << hanging(three, {{0, 1, 10, 0.5}, {1, 0, 10, 0.5}, {0, 1, 50, 0.5}}, {2}, 10);
        QTest::newRow("a huge length") << hanging(three, {{0, 1, 1e100, 0.5}}, {}, 2);
    }
    void allPointsStayFinite()
    {
        QFETCH(Scene, scene);
        for (const char *method : {"published", "semi_implicit_euler"}) {
            for (const double h : {1.0, 0.25})
                QCOMPARE(firstNonFinitePoint(support::plainRun(scene, method, h, 100)), -1);
        }
    }

    /// Contradictory sticks come to rest on one line, because 1 + 1 < 10. The last stick of the list gets its
    /// length.
    void contradictorySticksComeToRest()
    {
        Scene scene =
            hanging({{0, 0}, {1, 0}, {0, 1}}, {{0, 1, 1, 0.5}, {1, 2, 1, 0.5}, {0, 2, 10, 0.5}}, {}, 10);
        scene.effects.erase(scene.effects.begin()); // no gravity
        const State a = support::plainRun(scene, "semi_implicit_euler", 1.0, 2000);
        const State b = support::plainRun(scene, "semi_implicit_euler", 1.0, 2100);
        const double longest = length(a.positionOf(0) - a.positionOf(2));
        QVERIFY(std::abs(longest - 10.0) <= 1e-9);
        QVERIFY(std::abs(length(a.positionOf(0) - a.positionOf(1)) +
                         length(a.positionOf(1) - a.positionOf(2)) - longest) <= 1e-6);
        QVERIFY(std::abs(length(b.positionOf(0) - b.positionOf(2)) - longest) <= 1e-6);
    }

    void explainedStickIsTheLastOneThatMovedThePoint()
    {
        Dice dice(3);
        for (const DirectionRule directionRule : {DirectionRule::regularised, DirectionRule::published}) {
            State state = randomState(dice, 4);
            const Sticks sticks({{0, 1, 50, 0.3}, {1, 2, 60, 0.5}, {3, 1, 70, 0.5}}, 4, 2);
            const State before = state;
            sticks.enforce(state, allPoints(state), directionRule, 1.0);
            for (int point = 0; point < 4; ++point) {
                const std::vector<LiveValue> live = sticks.explain(before, state, point);
                QCOMPARE(live.size(), std::size_t{3});
                QVERIFY(std::get<Vec2>(live.back().value) == state.positionOf(point));
            }
        }
    }

    void softStickHasThreeCases_data()
    {
        QTest::addColumn<double>("length");
        QTest::addColumn<double>("wanted");
        QTest::newRow("pressed too far") << 5.0 << 20.0 + (5.0 - 20.0) * 0.2;
        QTest::newRow("at the minimum length") << 20.0 << 40.0 - 20.0 * 0.9;
        QTest::newRow("shorter than at rest") << 30.0 << 40.0 - 10.0 * 0.9;
        QTest::newRow("at rest") << 40.0 << 40.0;
        QTest::newRow("longer than at rest") << 50.0 << 40.0 + 10.0 * 0.9;
        QTest::newRow("pulled too far") << 90.0 << 60.0 + 30.0 * 0.2;
        QTest::newRow("length 0") << 0.0 << 20.0 * 0.8;
    }
    void softStickHasThreeCases()
    {
        QFETCH(double, length);
        QFETCH(double, wanted);
        State state = State::ofPoints(2);
        state.place(0, {100, 50});
        state.place(1, Vec2{100, 50} + length * Vec2{0.6, -0.8});
        SoftSticks({{0, 1, 20, 40, 60}}, {0.1, 0.8})
            .enforce(state, allPoints(state), DirectionRule::regularised, 1.0);
        QCOMPARE(state.positionOf(0), (Vec2{100, 50}));
        const Vec2 stickVector = state.positionOf(1) - state.positionOf(0);
        QVERIFY(std::abs(sim::length(stickVector) - wanted) <= 1e-12 * (1 + wanted));
        if (length > 0.0)
            QVERIFY(std::abs(stickVector.x * 0.8 + stickVector.y * 0.6) <= 1e-12);
    }

    /// The limbs keep their lengths, and the centre of the three points does not move.
    void jointIsBentToTheNearerLimit()
    {
        Dice dice(4);
        for (int run = 0; run < 5000; ++run) {
            State state = randomState(dice, 3);
            const AngleLimit limit = {0, 1, 2, dice.real(10, 120), dice.real(130, 350)};
            const State before = state;
            AngleLimits({limit}).enforce(state, allPoints(state), DirectionRule::regularised, 1.0);
            const double angleBefore = angleAt(before, limit), angleAfter = angleAt(state, limit);
            if (angleBefore >= limit.least && angleBefore <= limit.most) {
                QVERIFY(sameBits(state, before));
                continue;
            }
            const double over = std::fmod(angleBefore - limit.most + 360, 360);
            const double under = std::fmod(limit.least - angleBefore + 360, 360);
            QVERIFY(std::abs(angleAfter - (over < under ? limit.most : limit.least)) <= 1e-9);
            for (const int end : {0, 2})
                QVERIFY(std::abs(length(state.positionOf(end) - state.positionOf(1)) -
                                 length(before.positionOf(end) - before.positionOf(1))) <= 1e-10);
            const Eigen::Array2d moved = (state.position - before.position).colwise().sum();
            QVERIFY(moved.abs().maxCoeff() <= 1e-10);
        }
    }

    void underWeightSmallerStepsHelpMoreThanMoreIterations_data()
    {
        QTest::addColumn<int>("steps");
        QTest::addColumn<int>("iterations");
        QTest::newRow("one step") << 1 << 20;
        QTest::newRow("5 steps") << 5 << 4;
        QTest::newRow("20 steps") << 20 << 1;
    }
    /// Each row has 20 iterations per frame. The closed form is that of a flat arc whose links are stretched
    /// by the tension, see heavyError() of the hard cases. The error is proportional to the step to the power
    /// 2/3.
    void underWeightSmallerStepsHelpMoreThanMoreIterations()
    {
        QFETCH(int, steps);
        QFETCH(int, iterations);
        constexpr double gravity = 0.5, links = 100, restLength = 4.4;
        Script script;
        script.build = hard::stretchedChain;
        script.values = hard::valuesOf({{"links", links},
                                        {"stretched", 1},
                                        {"damp", 0.9},
                                        {"gravity", gravity},
                                        {"passes", double(iterations)}});
        script.method = findMethod("semi_implicit_euler");
        script.step = StepSize::ofLength(1.0 / steps);
        Track track(script, 0);
        track.seek({300, 0});
        double maxError = 0.0;
        for (int i = 0; i < links; ++i)
            maxError = std::max(
                maxError,
                std::abs(length(track.state().positionOf(i + 1) - track.state().positionOf(i)) - restLength));
        const double weight = links * gravity / (steps * steps);
        const double predicted =
            restLength * std::pow(weight / (4 * std::sqrt(3.0 / 8.0) * iterations * restLength), 2.0 / 3.0);
        QVERIFY2(maxError < predicted && maxError > 0.6 * predicted,
                 qPrintable(QString::number(maxError / predicted)));
    }

    void areaStickSetsTheArea()
    {
        Dice dice(5);
        const Quad quad = {0, 1, 2, 3};
        for (int run = 0; run < 2000; ++run) {
            State state = randomState(dice, 4);
            const double spine = length(state.positionOf(0) - state.positionOf(1));
            AreaStick(quad, 600, 10).enforce(state, allPoints(state), DirectionRule::regularised, 1.0);
            QVERIFY(std::abs(areaOf(state, quad) - 600 * std::min(1.0, spine / 10)) <= 1e-7);
        }
    }

    /// A push of 2 px into the floor with friction 0.5 stops a slide of up to 1 px, and shortens a longer
    /// slide by 1 px.
    void frictionIsLimitedByThePushIntoTheFloor_data()
    {
        QTest::addColumn<double>("slide");
        QTest::addColumn<double>("expected");
        QTest::newRow("none") << 0.0 << 0.0;
        QTest::newRow("stopped") << 0.9 << 0.0;
        QTest::newRow("too long") << 3.0 << 2.0;
        QTest::newRow("too long, to the left") << -3.0 << -2.0;
    }
    void frictionIsLimitedByThePushIntoTheFloor()
    {
        QFETCH(double, slide);
        QFETCH(double, expected);
        const Room room = {0, 500, 300, 0};
        const RoomLimits limits(room, Eigen::ArrayXd::Constant(1, 5.0), 0.5);
        State state = State::ofPoints(1);
        state.place(0, {100, 295});
        state.previous = state.position;
        state.place(0, {100 + slide, 297});
        limits.enforce(state, {0, 1}, DirectionRule::regularised, 1.0);
        QCOMPARE(state.positionOf(0), (Vec2{100 + expected, 295}));
    }
};

SUITE(tst_constraints, TestConstraints)
#include "tst_constraints.moc"

// State: comparison of bits, memory size and non-finite points.

#include "sim/run/finite.h"
#include "tests/sim/support/support.h"
#include "tests/suite.h"

#include <QTest>

#include <limits>

using namespace sim;

namespace {

constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();
constexpr double positiveInfinity = std::numeric_limits<double>::infinity();

State threePoints()
{
    State state = State::ofPoints(3);
    support::scatter(state, 1, 100.0);
    state.acceleration.setZero(3, 2);
    return state;
}

}

class TestState : public QObject
{
    Q_OBJECT

private slots:
    void everyMemberIsCompared_data()
    {
        QTest::addColumn<std::function<void(State &)>>("change");
        using Change = std::function<void(State &)>;
        QTest::newRow("position") << Change([](State &s) { s.position(2, 1) += 1e-12; });
        QTest::newRow("velocity") << Change([](State &s) { s.velocity(0, 0) = 1e-300; });
        QTest::newRow("minus zero") << Change([](State &s) { s.velocity(1, 1) = -0.0; });
        QTest::newRow("acceleration") << Change([](State &s) { s.acceleration(1, 0) = 1.0; });
        QTest::newRow("no acceleration") << Change([](State &s) { s.acceleration.resize(0, 2); });
        QTest::newRow("mass") << Change([](State &s) { s.inverseMass[0] = 0.0; });
        QTest::newRow("held point") << Change([](State &s) { s.hold.point = 0; });
        QTest::newRow("hand x") << Change([](State &s) { s.hold.hand.x = 1.0; });
        QTest::newRow("hand y") << Change([](State &s) { s.hold.hand.y = 1.0; });
        QTest::newRow("another number of points") << Change([](State &s) { s = State::ofPoints(2); });
    }
    void everyMemberIsCompared()
    {
        QFETCH(std::function<void(State &)>, change);
        State other = threePoints();
        QVERIFY(sameBits(other, threePoints()));
        change(other);
        QVERIFY(!sameBits(other, threePoints()));
        QVERIFY(!sameBits(threePoints(), other));
    }

    void notANumberEqualsItself()
    {
        State state = threePoints();
        state.position(0, 0) = notANumber;
        const State copy = state;
        QVERIFY(sameBits(state, copy));
    }

    void shapesWithTheSameNumbersDiffer()
    {
        State a = State::ofPoints(0), b = State::ofPoints(0);
        a.acceleration.setZero(2, 2);
        b.inverseMass.setZero(4);
        QVERIFY(!sameBits(a, b));
    }

    void memoryGrowsByTheSizeOfAPoint()
    {
        const std::size_t bytesPerPoint = byteSize(State::ofPoints(1001)) - byteSize(State::ofPoints(1000));
        QCOMPARE(bytesPerPoint, 5 * sizeof(double)); // x, y, vx, vy, mass
        QVERIFY(byteSize(threePoints()) >= sizeof(State) + 3 * 7 * sizeof(double));
    }

    void firstNonFinitePointIsFound_data()
    {
        QTest::addColumn<double>("number");
        QTest::newRow("not a number") << notANumber;
        QTest::newRow("infinity") << positiveInfinity;
        QTest::newRow("negative infinity") << -positiveInfinity;
    }
    void firstNonFinitePointIsFound()
    {
        QFETCH(double, number);
        QCOMPARE(firstNonFinitePoint(threePoints()), -1);
        for (int point = 0; point < 3; ++point) {
            for (int axis = 0; axis < 2; ++axis) {
                State x = threePoints(), v = threePoints(), a = threePoints();
                x.position(point, axis) = number;
                v.velocity(point, axis) = number;
                a.acceleration(point, axis) = number;
                QCOMPARE(firstNonFinitePoint(x), point);
                QCOMPARE(firstNonFinitePoint(v), point);
                QCOMPARE(firstNonFinitePoint(a), point);
            }
        }
        State large = threePoints();
        large.position.setConstant(std::numeric_limits<double>::max());
        large.velocity.setConstant(-std::numeric_limits<double>::denorm_min());
        QCOMPARE(firstNonFinitePoint(large), -1);
    }
};

SUITE(tst_state, TestState)
#include "tst_state.moc"

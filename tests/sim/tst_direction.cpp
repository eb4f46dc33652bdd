// The direction between two points, and the rule for two points in one place.

#include "sim/run/finite.h"
#include "sim/scene/scene.h"
#include "support.h"

#include "sim/effects/drags/damping.h"

#include <QTest>

using namespace sim;
using support::Dice;

namespace {

double nearestTwo(const State &state)
{
    double nearest = 1e300;
    for (int i = 0; i < state.pointCount(); ++i) {
        for (int j = 0; j < i; ++j)
            nearest = std::min(nearest, length(state.positionOf(i) - state.positionOf(j)));
    }
    return nearest;
}

/// A creature whose points all start in one place, pushed by springs of 50 px both ways.
Scene crowd(int points)
{
    Scene scene = scenes::springCreature(points - 1, 0.2, 50.0);
    scenes::add<Damping>(scene, 0.9);
    return scene;
}

}

class TestDirection : public QObject
{
    Q_OBJECT

private slots:
    void directionHasLengthOneAtEveryScale()
    {
        Dice dice(1);
        for (int run = 0; run < 20'000; ++run) {
            const double scale = std::pow(10.0, dice.real(-200.0, 150.0));
            const Vec2 d = {scale * dice.real(-1, 1), scale * dice.real(-1, 1)};
            const Direction heading = direction(d, dice.whole(0, 99), dice.whole(0, 99));
            QVERIFY2(std::abs(length(heading.out) - 1.0) < 1e-15 * 4,
                     qPrintable(QString("(%1, %2)").arg(d.x).arg(d.y)));
        }
    }

    void directionPointsAlongTheDistance()
    {
        Dice dice(2);
        for (int run = 0; run < 5000; ++run) {
            const Vec2 d = {dice.real(-1e3, 1e3), dice.real(-1e3, 1e3)};
            const Direction found = direction(d, 0, 1);
            const PublishedDirection published = publishedDirection(d);
            QVERIFY(length(found.out - published.out) < 1e-15 * 4);
            QVERIFY(std::abs(found.length - std::hypot(d.x, d.y)) <= 1e-12);
        }
    }

    void endsOfADistanceHaveOppositeDirections()
    {
        Dice dice(3);
        for (int run = 0; run < 5000; ++run) {
            const Vec2 d = {dice.real(-10, 10), dice.real(-10, 10)};
            const int a = dice.whole(0, 50);
            const int b = a + dice.whole(1, 50);
            for (const Vec2 one : {d, Vec2{0, 0}}) {
                const Vec2 there = direction(one, a, b).out;
                const Vec2 back = direction({-one.x, -one.y}, b, a).out;
                QVERIFY(there == (Vec2{-back.x, -back.y})); // exactly: or a pair makes momentum
            }
        }
    }

    void partingDirectionsOfACrowdAreAllDifferent()
    {
        std::vector<Vec2> seen;
        for (int foot = 0; foot < 100; ++foot) {
            const Vec2 out = fallbackDirection(100, foot);
            QVERIFY(std::abs(length(out) - 1.0) < 1e-15 * 4);
            for (const Vec2 other : seen)
                QVERIFY(length(out - other) > 0.01);
            seen.push_back(out);
        }
    }

    void publishedKeepsTheDirectionOfTheTutorials()
    {
        QCOMPARE(publishedDirection({0, 0}).out.x, 1.0);
        QCOMPARE(publishedDirection({0, 0}).out.y, 0.0);
        const State end = support::plainRun(crowd(2), "published", 1.0, 60);
        QCOMPARE(end.positionOf(0).y, 200.0); // along x and nowhere else
        QCOMPARE(end.positionOf(1).y, 200.0);
        QVERIFY(end.positionOf(0).x > end.positionOf(1).x + 40);
    }

    void pointsInOnePlacePart_data()
    {
        QTest::addColumn<int>("points");
        QTest::addColumn<double>("h");
        QTest::newRow("two points") << 2 << 1.0;
        QTest::newRow("six points") << 6 << 0.5;
        // 59 springs pull the body: it needs 59 k h^2 well under 4.
        QTest::newRow("sixty points") << 60 << 0.125;
    }
    void pointsInOnePlacePart()
    {
        QFETCH(int, points);
        QFETCH(double, h);
        const State end = support::plainRun(crowd(points), "semi_implicit_euler", h, 300);
        QCOMPARE(firstNonFinitePoint(end), -1);
        // The feet do not push each other and the body recoils among them, so two of sixty may end up close.
        QVERIFY2(nearestTwo(end) > 1e-6, qPrintable(QString::number(nearestTwo(end))));
        const int body = points - 1;
        for (int foot = 0; foot < body; ++foot)
            QVERIFY(std::abs(length(end.positionOf(foot) - end.positionOf(body)) - 50.0) < 1e-3);
    }

    void aCrowdAroundAHandleSpreadsEvenly()
    {
        Scene scene = crowd(60);
        scene.start.inverseMass[59] = 0.0;
        const State end = support::plainRun(scene, "semi_implicit_euler", 1.0, 400);
        // Sixty turns of the golden angle leave gaps of one of three sizes, the least 0.61 of the even share or so.
        const double evenShare = 2 * 3.141592653589793 * 50.0 / 59;
        QVERIFY2(nearestTwo(end) > 0.3 * evenShare, qPrintable(QString::number(nearestTwo(end) / evenShare)));
    }

    void partingMakesNoMomentum()
    {
        const State end = support::plainRun(crowd(6), "semi_implicit_euler", 0.5, 300);
        QVERIFY(std::abs(end.velocity.col(0).sum()) < 1e-12);
        QVERIFY(std::abs(end.velocity.col(1).sum()) < 1e-12);
        QVERIFY(std::abs(end.position.col(0).mean() - 270.0) < 1e-9);
    }

    void pointsThatMeetOnTheWayPartAgain()
    {
        Scene scene = crowd(2);
        scene.start.place(0, {260, 200});
        scene.start.place(1, {280, 200});
        scene.start.setVelocity(
            0, {10 / 0.9 + 6, 0}); // with the first kick of -6 and damping they meet in one frame
        scene.start.setVelocity(1, {-10 / 0.9 - 6, 0});
        const State met = support::plainRun(scene, "semi_implicit_euler", 1.0, 1);
        QVERIFY(length(met.positionOf(0) - met.positionOf(1)) < 1e-9);
        // What is left of the swing shrinks as damp^(t/2): 1e-9 after 400 frames.
        const State end = support::plainRun(scene, "semi_implicit_euler", 1.0, 400);
        QVERIFY(std::abs(length(end.positionOf(0) - end.positionOf(1)) - 50.0) < 1e-6);
    }
};

QTEST_APPLESS_MAIN(TestDirection)
#include "tst_direction.moc"

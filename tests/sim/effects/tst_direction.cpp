// The direction between two points, and the fallback direction of coincident points.

#include "sim/run/finite.h"
#include "sim/scene/scene.h"
#include "tests/sim/support/support.h"

#include "sim/effects/drags/damping.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;
using support::Dice;

namespace {

double minDistance(const State &state)
{
    double nearest = 1e300;
    for (int i = 0; i < state.pointCount(); ++i) {
        for (int j = 0; j < i; ++j)
            nearest = std::min(nearest, length(state.positionOf(i) - state.positionOf(j)));
    }
    return nearest;
}

/// Returns a creature whose points all start at the same position, on springs of length 50 px.
Scene coincidentCreature(int points)
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
            const Direction found = direction(d, dice.whole(0, 99), dice.whole(0, 99));
            QVERIFY2(std::abs(length(found.out) - 1.0) < 1e-15 * 4,
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
            for (const Vec2 vector : {d, Vec2{0, 0}}) {
                const Vec2 forward = direction(vector, a, b).out;
                const Vec2 back = direction({-vector.x, -vector.y}, b, a).out;
                QVERIFY(forward == (Vec2{-back.x, -back.y})); // exactly, or momentum would not be conserved
            }
        }
    }

    void fallbackDirectionsOfACreatureDiffer()
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
        const State end = support::plainRun(coincidentCreature(2), "published", 1.0, 60);
        QCOMPARE(end.positionOf(0).y, 200.0); // the motion is along x only
        QCOMPARE(end.positionOf(1).y, 200.0);
        QVERIFY(end.positionOf(0).x > end.positionOf(1).x + 40);
    }

    void coincidentPointsSeparate_data()
    {
        QTest::addColumn<int>("points");
        QTest::addColumn<double>("h");
        QTest::newRow("two points") << 2 << 1.0;
        QTest::newRow("six points") << 6 << 0.5;
        // 59 springs act on the body, so 59 k h^2 must be well below 4.
        QTest::newRow("sixty points") << 60 << 0.125;
    }
    void coincidentPointsSeparate()
    {
        QFETCH(int, points);
        QFETCH(double, h);
        const State end = support::plainRun(coincidentCreature(points), "semi_implicit_euler", h, 300);
        QCOMPARE(firstNonFinitePoint(end), -1);
        // Feet do not repel each other and the body recoils, so two feet may end up close together.
        QVERIFY2(minDistance(end) > 1e-6, qPrintable(QString::number(minDistance(end))));
        const int body = points - 1;
        for (int foot = 0; foot < body; ++foot)
            QVERIFY(std::abs(length(end.positionOf(foot) - end.positionOf(body)) - 50.0) < 1e-3);
    }

    void feetAroundAHandleSpreadEvenly()
    {
        Scene scene = coincidentCreature(60);
        scene.start.inverseMass[59] = 0.0;
        const State end = support::plainRun(scene, "semi_implicit_euler", 1.0, 400);
        // Multiples of the golden angle leave gaps of three sizes. The smallest is about 0.61 of the mean
        // gap.
        const double meanGap = 2 * 3.141592653589793 * 50.0 / 59;
        QVERIFY2(minDistance(end) > 0.3 * meanGap, qPrintable(QString::number(minDistance(end) / meanGap)));
    }

    void separationConservesMomentum()
    {
        const State end = support::plainRun(coincidentCreature(6), "semi_implicit_euler", 0.5, 300);
        QVERIFY(std::abs(end.velocity.col(0).sum()) < 1e-12);
        QVERIFY(std::abs(end.velocity.col(1).sum()) < 1e-12);
        QVERIFY(std::abs(end.position.col(0).mean() - 270.0) < 1e-9);
    }

    void pointsThatMeetLaterSeparate()
    {
        Scene scene = coincidentCreature(2);
        scene.start.place(0, {260, 200});
        scene.start.place(1, {280, 200});
        // After the first kick of -6 and the damping they meet in one frame.
        scene.start.setVelocity(0, {10 / 0.9 + 6, 0});
        scene.start.setVelocity(1, {-10 / 0.9 - 6, 0});
        const State meeting = support::plainRun(scene, "semi_implicit_euler", 1.0, 1);
        QVERIFY(length(meeting.positionOf(0) - meeting.positionOf(1)) < 1e-9);
        // The oscillation decays as damp^(t/2), to 1e-9 after 400 frames.
        const State end = support::plainRun(scene, "semi_implicit_euler", 1.0, 400);
        QVERIFY(std::abs(length(end.positionOf(0) - end.positionOf(1)) - 50.0) < 1e-6);
    }
};

SUITE(tst_direction, TestDirection)
#include "tst_direction.moc"

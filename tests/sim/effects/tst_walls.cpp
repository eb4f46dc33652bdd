// The room with two walls and a floor.

#include "tests/sim/support/support.h"

#include "sim/effects/contacts/walls.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>

using namespace sim;

class TestWalls : public QObject
{
    Q_OBJECT

private slots:
    void bodiesBounceAtHalfTheirWidth_data()
    {
        QTest::addColumn<Room>("room");
        QTest::addColumn<PointMotion>("before");
        QTest::addColumn<PointMotion>("after");
        const Room full = {20, 520, 380, 1.0};
        const Room half = {20, 520, 380, 0.5};
        const Room inelastic = {20, 520, 380, 0.0};
        const auto addRow = [](const char *name, Room room, PointMotion before, PointMotion after) {
            QTest::newRow(name) << room << before << after;
        };
        addRow("inside", full, {{100, 100}, {3, 4}}, {{100, 100}, {3, 4}});
        addRow("touching the right wall", full, {{505, 100}, {3, 4}}, {{505, 100}, {3, 4}});
        addRow("past the right wall", full, {{505.5, 100}, {3, 4}}, {{505, 100}, {-3, 4}});
        addRow("past the left wall", full, {{30, 100}, {-3, 4}}, {{35, 100}, {3, 4}});
        addRow("past the floor", full, {{100, 400}, {3, 4}}, {{100, 365}, {3, -4}});
        addRow("far above, no ceiling", full, {{100, -1e6}, {3, -4}}, {{100, -1e6}, {3, -4}});
        addRow("half the speed is kept", half, {{600, 100}, {3, 4}}, {{505, 100}, {-1.5, 4}});
        addRow("no speed is kept", inelastic, {{100, 400}, {3, 4}}, {{100, 365}, {3, 0}});
        addRow("in the right corner", half, {{600, 400}, {3, 4}}, {{505, 365}, {-1.5, -2}});
        addRow("in the left corner", full, {{0, 400}, {-3, 4}}, {{35, 365}, {3, -4}});
        addRow("already moving back", full, {{600, 100}, {-3, 4}}, {{505, 100}, {3, 4}});
        addRow("walls closer than the body", {100, 110, 380, 0.5}, {{104, 0}, {8, 0}}, {{115, 0}, {2, 0}});
        addRow("walls in the wrong order", {500, 100, 380, 1.0}, {{300, 0}, {8, 0}}, {{515, 0}, {8, 0}});
    }
    void bodiesBounceAtHalfTheirWidth()
    {
        QFETCH(Room, room);
        QFETCH(PointMotion, before);
        QFETCH(PointMotion, after);
        State state = State::ofPoints(1);
        state.place(0, before.x);
        state.setVelocity(0, before.v);
        Walls(room, Eigen::ArrayXd::Constant(1, 15.0)).resolve(state, {0, 1});
        QCOMPARE(state.positionOf(0).x, after.x.x);
        QCOMPARE(state.positionOf(0).y, after.x.y);
        QCOMPARE(state.velocityOf(0).x, after.v.x);
        QCOMPARE(state.velocityOf(0).y, after.v.y);
    }

    void widthsOfBodiesAreRespected()
    {
        Eigen::ArrayXd half(2);
        half << 5.0, 15.0;
        State state = State::ofPoints(2);
        state.place(0, {0, 0});
        state.place(1, {0, 0});
        Walls({20, 520, 380, 1.0}, half).resolve(state, {0, 2});
        QCOMPARE(state.positionOf(0).x, 25.0);
        QCOMPARE(state.positionOf(1).x, 35.0);
    }

    void heldBodyPassesThroughWalls()
    {
        State state = State::ofPoints(2);
        state.inverseMass[0] = 0.0;
        const Walls walls({20, 520, 380, 1.0}, Eigen::ArrayXd::Constant(2, 5.0));
        walls.resolve(state, {0, 2});
        QCOMPARE(state.positionOf(0).x, 0.0);
        QCOMPARE(state.positionOf(1).x, 25.0);
        QCOMPARE(walls.count(state, {0, 2}), 1);
    }

    void aBodyStaysInTheRoom_data()
    {
        QTest::addColumn<double>("bounce");
        QTest::newRow("no bounce") << 0.0;
        QTest::newRow("half") << 0.5;
        QTest::newRow("full") << 1.0;
    }
    void aBodyStaysInTheRoom()
    {
        QFETCH(double, bounce);
        support::Dice dice(1);
        const Walls walls({20, 520, 380, bounce}, Eigen::ArrayXd::Constant(1, 5.0));
        State state = State::ofPoints(1);
        for (int run = 0; run < 10'000; ++run) {
            const Vec2 x = {dice.real(-1e4, 1e4), dice.real(-1e4, 1e4)};
            const Vec2 v = {dice.real(-1e3, 1e3), dice.real(-1e3, 1e3)};
            state.place(0, x);
            state.setVelocity(0, v);
            walls.resolve(state, {0, 1});
            const bool isPastWall = x.x < 25 || x.x > 515, isPastFloor = x.y > 375;
            QCOMPARE(state.positionOf(0), (Vec2{std::clamp(x.x, 25.0, 515.0), std::min(x.y, 375.0)}));
            QCOMPARE(state.velocityOf(0),
                     (Vec2{isPastWall ? -bounce * v.x : v.x, isPastFloor ? -bounce * v.y : v.y}));
        }
    }
};

SUITE(tst_walls, TestWalls)
#include "tst_walls.moc"

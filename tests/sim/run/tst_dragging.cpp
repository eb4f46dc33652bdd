// The rules for a dragged body. From the grab on it is at the position of the last move, and its velocity is
// its movement since the frame before. On release it is free in the same frame, and keeps that velocity.

#include "tests/sim/support/method_rows.h"
#include "tests/sim/support/support.h"

#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;

namespace {

/// Returns a foot and a body without effects. The foot starts at (100, 100) with velocity (3, 1).
Scene drifting()
{
    Scene scene = scenes::creature(1);
    scene.start.place(0, {100, 100});
    scene.start.setVelocity(0, {3, 1});
    return scene;
}

Track trackOf(const Scene &scene, const QString &method, std::vector<Event> input, double h = 1.0)
{
    Script script = support::script(scene, method.toStdString(), h);
    script.input = std::move(input);
    return Track(script, 100'000);
}

}

class TestDragging : public QObject
{
    Q_OBJECT

private:
    static void compare(const Track &track, Vec2 x, Vec2 v, int point = 0)
    {
        QCOMPARE(track.state().positionOf(point).x, x.x);
        QCOMPARE(track.state().positionOf(point).y, x.y);
        QCOMPARE(track.state().velocityOf(point).x, v.x);
        QCOMPARE(track.state().velocityOf(point).y, v.y);
    }

private slots:
    void bodyIsDraggedAndThrown_data() { support::addFixedMethodRows(); }
    void bodyIsDraggedAndThrown()
    {
        QFETCH(QString, method);
        Track track =
            trackOf(drifting(), method,
                    {{2, Grab{"foot0"}}, {3, Move{{110, 100}}}, {5, Move{{118, 96}}}, {6, Release{}}});
        track.seek({1, 0});
        compare(track, {103, 101}, {3, 1});
        track.seek({2, 0});
        compare(track, {103, 101}, {0, 0}); // no move yet
        track.seek({3, 0});
        compare(track, {110, 100}, {7, -1});
        track.seek({4, 0});
        compare(track, {110, 100}, {0, 0}); // no move in this frame
        track.seek({5, 0});
        compare(track, {118, 96}, {8, -4});
        track.seek({6, 0});
        compare(track, {126, 92}, {8, -4}); // free in the same frame
        track.seek({7, 0});
        compare(track, {134, 88}, {8, -4});
    }

    void lastMoveOfAFrameSetsThePosition()
    {
        Track track =
            trackOf(drifting(), "published",
                    {{1, Grab{"foot0"}}, {1, Move{{0, 0}}}, {1, Move{{50, 60}}}, {1, Move{{90, 105}}}});
        track.seek({1, 0});
        compare(track, {90, 105}, {-10, 5});
    }

    void moveAndReleaseInOneFrameFreeTheBodyAtTheNewPosition()
    {
        Track track =
            trackOf(drifting(), "published",
                    {{1, Grab{"foot0"}}, {2, Move{{104, 100}}}, {3, Move{{200, 50}}}, {3, Release{}}});
        track.seek({3, 0});
        compare(track, {204, 50}, {4, 0}); // keeps its velocity
    }

    void grabAndReleaseInOneFrameChangeNothing_data() { support::addFixedMethodRows(); }
    void grabAndReleaseInOneFrameChangeNothing()
    {
        QFETCH(QString, method);
        Track track = trackOf(drifting(), method, {{2, Grab{"foot0"}}, {2, Release{}}});
        Track free = trackOf(drifting(), method, {});
        for (int frame = 1; frame < 5; ++frame) {
            track.seek({frame, 0});
            free.seek({frame, 0});
            QVERIFY(sameBits(track.state(), free.state()));
        }
    }

    void handleHasNoVelocity_data() { support::addFixedMethodRows(); }
    void handleHasNoVelocity()
    {
        QFETCH(QString, method);
        Scene scene = drifting();
        scene.start.inverseMass[1] = 0.0;
        scene.effects = {std::make_shared<Gravity>(0.5)};
        Track track = trackOf(scene, method, {{1, Grab{"body"}}, {2, Move{{10, 20}}}, {3, Release{}}});
        track.seek({2, 0});
        compare(track, {10, 20}, {0, 0}, 1);
        track.seek({9, 0});
        compare(track, {10, 20}, {0, 0}, 1);
        QVERIFY(!track.state().isDynamic(1));
    }

    void heldBodyFeelsNothingAndPassesThroughWalls_data()
    {
        QTest::addColumn<QString>("method");
        for (const char *id : {"published", "semi_implicit_euler"}) // both apply the force before the damping
            QTest::newRow(id) << id;
    }
    void heldBodyFeelsNothingAndPassesThroughWalls()
    {
        QFETCH(QString, method);
        Scene scene = drifting();
        scene.effects = {std::make_shared<Gravity>(5), std::make_shared<Damping>(0.5),
                         std::make_shared<Walls>(Room{20, 520, 380, 1}, Eigen::ArrayXd::Constant(2, 5))};
        Track track = trackOf(scene, method, {{1, Grab{"foot0"}}, {1, Move{{600, 500}}}, {3, Release{}}});
        track.seek({1, 0});
        compare(track, {600, 500}, {500, 400});
        track.seek({2, 0});
        compare(track, {600, 500}, {0, 0});
        track.seek({3, 0});
        // Methods of first order damp after the kick: (0 + 5) 0.5. Methods of second order apply part of the
        // damping before the kick, so the body is faster. The floor reverses the velocity.
        const bool isFirstOrder = findMethod(method.toStdString())->order() == 1;
        const double velocityAfterBounce = track.state().velocityOf(0).y;
        compare(track, {515, 375}, {0, isFirstOrder ? -2.5 : velocityAfterBounce});
        QVERIFY(velocityAfterBounce <= -2.5 && velocityAfterBounce > -5.0);
    }

    void secondGrabReleasesTheFirstBody()
    {
        Track track =
            trackOf(drifting(), "published",
                    {{1, Grab{"foot0"}}, {1, Move{{103, 100}}}, {2, Grab{"body"}}, {3, Move{{0, 0}}}});
        track.seek({3, 0});
        compare(track, {109, 100}, {3, 0});
        compare(track, {0, 0}, {-270, -200}, 1);
        QVERIFY(track.state().isDynamic(0) && !track.state().isDynamic(1));
    }

    void eventsWithoutAHeldBodyDoNothing()
    {
        Track track = trackOf(drifting(), "published",
                              {{1, Move{{5, 5}}}, {1, Release{}}, {2, Grab{"nobody"}}, {3, Move{{5, 5}}}});
        track.seek({4, 0});
        compare(track, {112, 104}, {3, 1});
    }

    void eventsWithinALongStepApplyToThatStep()
    {
        // Output steps end at frames 2, 4, 6. Events of frames 3 and 4 belong to the second. Velocities are
        // per frame.
        Track track = trackOf(drifting(), "published",
                              {{0, Grab{"foot0"}}, {3, Move{{120, 100}}}, {6, Release{}}}, 2.0);
        track.seek({2, 0});
        compare(track, {100, 100}, {0, 0});
        track.seek({4, 0});
        compare(track, {120, 100}, {10, 0});
        track.seek({6, 0});
        compare(track, {140, 100}, {10, 0});
    }

    void eventsApplyOncePerFrameWithShortSteps()
    {
        Track track = trackOf(drifting(), "published",
                              {{1, Grab{"foot0"}}, {2, Move{{106, 100}}}, {3, Release{}}}, 0.25);
        track.seek({2, 0});
        compare(track, {106, 100}, {6, 0});
        track.seek({3, 0});
        compare(track, {112, 100}, {6, 0});
    }

    void otherBodiesFeelTheHeldBody()
    {
        Script script = support::script(support::sample("heavy pair"), "published");
        script.input = {{1, Grab{"foot0"}}, {1, Move{{5000, 200}}}};
        Track track(script, 0);
        track.seek({1, 0});
        QVERIFY(track.state().velocityOf(1).x > 50.0);
    }
};

SUITE(tst_dragging, TestDragging)
#include "tst_dragging.moc"

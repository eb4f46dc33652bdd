// The force snapshot within a step: the accelerations that effects have added and no move has consumed yet.

#include "sim/run/script/composed_interval.h"
#include "tests/sim/support/support.h"

#include "sim/analysis/force_snapshot.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;

namespace {

Eigen::ArrayX2d sumOf(const std::vector<ForceSnapshot> &all, int points)
{
    Eigen::ArrayX2d sum = Eigen::ArrayX2d::Zero(points, 2);
    for (const ForceSnapshot &snapshot : all)
        sum += snapshot.acceleration;
    return sum;
}

}

class TestForceSnapshot : public QObject
{
    Q_OBJECT

private slots:
    void snapshotsAddUpToTheAcceleration_data()
    {
        QTest::addColumn<QString>("scene");
        for (const support::Sample &sample : support::samples())
            QTest::newRow(sample.name.c_str()) << QString::fromStdString(sample.name);
    }
    void snapshotsAddUpToTheAcceleration()
    {
        QFETCH(QString, scene);
        Track track(support::script(support::sample(scene.toStdString()), "semi_implicit_euler", 0.5), 0);
        bool consumed = true;
        int compared = 0;
        for (int i = 0; i < 100; ++i) {
            track.seek({track.cursor().frame, track.cursor().phase + 1});
            const Pipeline &pipeline = track.interval().pipeline;
            const int done = track.cursor().phase % pipeline.phasesPerStep();
            consumed = done == 0 || pipeline.phaseAt(done - 1).consumesAcceleration || (consumed && done > 1);
            const std::vector<ForceSnapshot> snapshots = accumulatedForces(track);
            if (consumed) {
                QVERIFY(snapshots.empty());
                continue;
            }
            ++compared;
            QVERIFY(
                (sumOf(snapshots, track.state().pointCount()) - track.state().acceleration).abs().maxCoeff() <
                1e-12);
        }
        QVERIFY(compared > 0);
    }

    void publishedSnapshotsAddUpToTheVelocityChange()
    {
        Track track(support::script(support::sample("creature in a room"), "published"), 0);
        const State start = track.state();
        track.seek({0, 2}); // springs and gravity on the feet
        const std::vector<ForceSnapshot> snapshots = accumulatedForces(track);
        QCOMPARE(snapshots.size(), std::size_t(2));
        QCOMPARE(snapshots[0].effect->id(), std::string("radial_spring"));
        QCOMPARE(snapshots[1].effect->id(), std::string("gravity"));
        const Eigen::ArrayX2d velocityChange = track.state().velocity - start.velocity;
        QVERIFY((sumOf(snapshots, 6) - velocityChange).abs().maxCoeff() < 1e-12);
        QVERIFY((velocityChange.row(5) == 0.0).all());
    }

    void moveConsumesTheSnapshotsOfItsGroup()
    {
        Track track(support::script(support::sample("creature in a room"), "published"), 0);
        track.seek({0, 4}); // the feet have moved
        QVERIFY(accumulatedForces(track).empty());
        track.seek({0, 6}); // past the walls; springs on the body
        const std::vector<ForceSnapshot> snapshots = accumulatedForces(track);
        QCOMPARE(snapshots.size(), std::size_t(1));
        QVERIFY((snapshots[0].acceleration.topRows(5) == 0.0).all());
        QVERIFY((snapshots[0].acceleration.row(5) != 0.0).any());
        track.seek({1, 0});
        QVERIFY(accumulatedForces(track).empty());
    }

    void heldPointHasNoSnapshot()
    {
        Script script = support::script(support::sample("creature in a room"), "published");
        script.input = {{1, Grab{"foot2"}}};
        Track track(script, 0);
        track.seek({0, 2});
        const std::vector<ForceSnapshot> snapshots = accumulatedForces(track);
        QVERIFY((sumOf(snapshots, track.state().pointCount()) != 0.0).any());
        for (const ForceSnapshot &snapshot : snapshots)
            QVERIFY((snapshot.acceleration.row(2) == 0.0).all());
    }
};

SUITE(tst_force_snapshot, TestForceSnapshot)
#include "tst_force_snapshot.moc"

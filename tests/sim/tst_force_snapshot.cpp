// The arrows of a half-done step: what each effect has gathered and no move has spent yet.

#include "sim/run/script/composed_interval.h"
#include "support.h"

#include "sim/analysis/force_snapshot.h"
#include "sim/methods/methods.h"

#include <QTest>

using namespace sim;

namespace {

Eigen::ArrayX2d sumOf(const std::vector<ForceSnapshot> &all, int points)
{
    Eigen::ArrayX2d sum = Eigen::ArrayX2d::Zero(points, 2);
    for (const ForceSnapshot &one : all)
        sum += one.acceleration;
    return sum;
}

}

class TestGathered : public QObject
{
    Q_OBJECT

private slots:
    void arrowsAddUpToTheAccelerations_data()
    {
        QTest::addColumn<QString>("scene");
        for (const support::Sample &sample : support::samples())
            QTest::newRow(sample.name.c_str()) << QString::fromStdString(sample.name);
    }
    void arrowsAddUpToTheAccelerations()
    {
        QFETCH(QString, scene);
        Track track(support::script(support::sample(scene.toStdString()), "semi_implicit_euler", 0.5), 0);
        bool spent = true;
        for (int i = 0; i < 100; ++i) {
            track.seek({track.cursor().frame, track.cursor().phase + 1});
            const Pipeline &pipeline = track.interval().pipeline;
            const int done = track.cursor().phase % pipeline.phasesPerStep();
            spent = done == 0 || pipeline.phaseAt(done - 1).consumesAcceleration || (spent && done > 1);
            const std::vector<ForceSnapshot> arrows = accumulatedForces(track);
            if (spent)
                QVERIFY(arrows.empty());
            else
                QVERIFY((sumOf(arrows, track.state().pointCount()) - track.state().acceleration)
                            .abs()
                            .maxCoeff() < 1e-12);
        }
    }

    void publishedArrowsAreWhatChangedTheVelocity()
    {
        Track track(support::script(support::sample("creature in a room"), "published"), 0);
        const State start = track.state();
        track.seek({0, 2}); // springs and gravity on the feet
        const std::vector<ForceSnapshot> arrows = accumulatedForces(track);
        QCOMPARE(arrows.size(), std::size_t(2));
        QCOMPARE(arrows[0].effect->id(), std::string("radial_spring"));
        QCOMPARE(arrows[1].effect->id(), std::string("gravity"));
        const Eigen::ArrayX2d change = track.state().velocity - start.velocity;
        QVERIFY((sumOf(arrows, 6) - change).abs().maxCoeff() < 1e-12);
        QVERIFY((change.row(5) == 0.0).all());
    }

    void aMoveSpendsTheArrowsOfItsOwnGroup()
    {
        Track track(support::script(support::sample("creature in a room"), "published"), 0);
        track.seek({0, 4}); // the feet have moved
        QVERIFY(accumulatedForces(track).empty());
        track.seek({0, 6}); // past the walls; springs on the body
        const std::vector<ForceSnapshot> arrows = accumulatedForces(track);
        QCOMPARE(arrows.size(), std::size_t(1));
        QVERIFY((arrows[0].acceleration.topRows(5) == 0.0).all());
        QVERIFY((arrows[0].acceleration.row(5) != 0.0).any());
        track.seek({1, 0});
        QVERIFY(accumulatedForces(track).empty());
    }

    void whatIsHeldHasNoArrow()
    {
        Script script = support::script(support::sample("creature in a room"), "published");
        script.input = {{1, Grab{"foot2"}}};
        Track track(script, 0);
        track.seek({0, 2});
        for (const ForceSnapshot &one : accumulatedForces(track))
            QVERIFY((one.acceleration.row(2) == 0.0).all());
    }
};

QTEST_APPLESS_MAIN(TestGathered)
#include "tst_force_snapshot.moc"

// A run at rest sleeps: its output steps are not computed, and the run has the same bits.

#include "tests/sim/support/sleep_scenes.h"
#include "tests/sizes.h"
#include "tests/suite.h"

#include <QTest>

using namespace sleep_scenes;

class TestSleep : public QObject
{
    Q_OBJECT

private slots:
    void sleepingChangesNoBit_data()
    {
        QTest::addColumn<QString>("sample");
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("h");
        int fitting = 0;
        for (const support::Sample &sample : support::samples()) {
            for (const MethodPtr &method : allMethods()) {
                for (const double h : {1.0, 0.5, 2.0}) {
                    if (support::fits(sample.build(sample.values), *method) &&
                        fitting++ % tests::sized(1, 4) == 0)
                        QTest::addRow("%s, %s, h = %g", sample.name.c_str(), method->id().c_str(), h)
                            << QString::fromStdString(sample.name) << QString::fromStdString(method->id())
                            << h;
                }
            }
        }
    }
    void sleepingChangesNoBit()
    {
        QFETCH(QString, sample);
        QFETCH(QString, method);
        QFETCH(double, h);
        Script script = support::script(support::sample(sample.toStdString()), method.toStdString(), h);
        script.input = {{400, Grab{"foot0"}},
                        {402, Move{{300.0, 100.0}}},
                        {900, Release{}},
                        {1300, Grab{"foot"}},
                        {1310, Release{}}};
        const std::string difference = sleepDiffers(script, 2000);
        QVERIFY2(difference.empty(), difference.c_str());
    }

    void dampedScenesSleep_data()
    {
        QTest::addColumn<QString>("method");
        for (const MethodPtr &method : support::fixedMethods()) {
            if (method->id() != "explicit_euler" && support::fits(homing(scriptOf(homing).values), *method))
                QTest::addRow("%s", method->id().c_str()) << QString::fromStdString(method->id());
        }
    }
    void dampedScenesSleep()
    {
        QFETCH(QString, method);
        Track track(scriptOf(homing, method.toStdString()), budget);
        const std::int64_t from = sleepsFrom(track);
        QVERIFY2(from > 0, "the run never sleeps");
        QVERIFY(track.sleep()->isStill());
        QVERIFY(track.isFinished());
        const std::string difference = sleepDiffers(track.script(), from + 500);
        QVERIFY2(difference.empty(), difference.c_str());
    }

    void seekingInASleepingRunComputesNothing()
    {
        auto count = make_shared<std::int64_t>(0);
        Script script = scriptOf(homing);
        script.build = [count](const Values &values) {
            Scene scene = homing(values);
            scene.effects.push_back(make_shared<CountingForce>(count));
            return scene;
        };
        Track track(script, budget);
        const std::int64_t from = sleepsFrom(track);
        QVERIFY(from > 0);
        const std::int64_t computed = *count;
        const State rest = track.state();
        track.seek({from + 10'000'000, 0});
        QCOMPARE(track.cursor().frame, from + 10'000'000);
        QCOMPARE(track.state().frame, from + 10'000'000);
        QCOMPARE(track.computed(), from + 10'000'000);
        QVERIFY(continueIdentically(track.state(), rest));
        for (int i = 0; i < 1000; ++i)
            track.seek({from + i * 977, 0});
        QVERIFY(continueIdentically(track.stateAt(from + 123'456), rest));
        QCOMPARE(*count, computed); // no phase was computed
        // The same run without sleeping. It has fewer frames, because it is slow.
        Track reference(script, 0, Sleeping::never);
        reference.seek({from + 3000, 0});
        track.seek({from + 3000, 0});
        QVERIFY(sameBits(track.state(), reference.state()));
        // Seeking a phase within a frame computes the phases.
        const std::int64_t before = *count;
        track.seek({from + 3000, 3}); // two springs and the counting force
        QCOMPARE(*count, before + 2);
        track.seek({from + 3001, 0});
        reference.seek({from + 3001, 0});
        QVERIFY(sameBits(track.state(), reference.state()));
    }

    void sleepingRunTakesConstantMemory()
    {
        Track track(scriptOf(homing), budget);
        const std::int64_t from = sleepsFrom(track);
        QVERIFY(from > 0);
        const std::size_t states = track.keyframeCount(), bytes = track.keyframeBytes() + track.sleepBytes();
        for (std::int64_t frame = from; frame <= 10'000'000; frame += 9973)
            track.seek({frame, 0});
        for (int i = 0; i < 100; ++i) {
            track.seek({5'000'000 + i, 2}); // also within frames
            track.seek({5'000'000 + i + 1, 0});
        }
        QCOMPARE(track.keyframeCount(), states);
        QCOMPARE(track.keyframeBytes() + track.sleepBytes(), bytes);
        QVERIFY(track.sleepBytes() <= CycleDetector::longest * byteSize(track.state()));
    }

    void cycleOfStatesSleepsButIsNotFinished()
    {
        // With k = 1 and h = 1 the states of semi-implicit Euler, v' = v - x, x' = x + v', repeat exactly
        // after 6 frames.
        Scene scene = scenes::creature(1);
        scene.start.place(0, {16.0, 0.0});
        scene.start.place(1, {0.0, 0.0});
        scene.effects = {make_shared<PointSpring>(0, Vec2{0.0, 0.0}, 1.0)};
        const Script script = support::script(scene, "semi_implicit_euler");
        Track track(script, budget);
        const std::int64_t from = sleepsFrom(track, 200);
        QVERIFY(from > 0);
        QCOMPARE(track.sleep()->period(), 6);
        QVERIFY(!track.sleep()->isStill());
        QVERIFY(!track.isFinished());
        const double positions[] = {16.0, 0.0, -16.0, -16.0, 0.0, 16.0};
        for (std::int64_t frame = 1'000'000; frame < 1'000'020; ++frame) {
            track.seek({frame, 0});
            QCOMPARE(track.state().positionOf(0).x, positions[frame % 6]);
        }
        const std::string difference = sleepDiffers(script, from + 100);
        QVERIFY2(difference.empty(), difference.c_str());
    }

    void evaluationsAreCountedWhileSleeping()
    {
        for (const char *method : {"backward_euler", "implicit_midpoint"}) {
            Track track(scriptOf(homing, method), budget);
            const std::int64_t from = sleepsFrom(track);
            QVERIFY(from > 0);
            Track reference(track.script(), 0, Sleeping::never);
            reference.seek({from + 777, 0});
            track.seek({from + 777, 0});
            QVERIFY(reference.state().pointEvaluations > 0);
            QCOMPARE(track.state().pointEvaluations, reference.state().pointEvaluations);
        }
    }

    void manySleepsStayWithinTheBudget()
    {
        Script script = scriptOf(homing);
        for (int i = 1; i <= 200; ++i) {
            script.input.push_back({i * 500, Grab{"foot0"}});
            script.input.push_back({i * 500 + 1, Move{{double(i), 50.0}}});
            script.input.push_back({i * 500 + 2, Release{}});
        }
        const std::size_t small = 40 * byteSize(Track(script, 0).state());
        Track track(script, small), reference(script, 0, Sleeping::never);
        support::Dice dice(3);
        for (int i = 0; i < 200; ++i) {
            const std::int64_t frame = dice.whole(0, 100'500);
            track.seek({frame, 0});
            QVERIFY(track.sleepBytes() <= small + CycleDetector::longest * byteSize(track.state()));
            QVERIFY(track.keyframeBytes() <= small);
            if (i % 40 == 0) {
                reference.seek({frame, 0});
                QVERIFY(sameBits(track.state(), reference.state()));
            }
        }
    }
};

SUITE(tst_sleep, TestSleep)
#include "tst_sleep.moc"

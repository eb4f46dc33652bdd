// What has come to rest sleeps: its rows are not computed, and no bit of the run differs.

#include "sleep_scenes.h"

#include <QTest>

using namespace sleep_bench;

class TestSleep : public QObject
{
    Q_OBJECT

private slots:
    void sleepingChangesNoBit_data()
    {
        QTest::addColumn<QString>("sample");
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("h");
        for (const support::Sample &sample : support::samples()) {
            for (const MethodPtr &method : allMethods()) {
                for (const double h : {1.0, 0.5, 2.0}) {
                    if (support::fits(sample.build(sample.values), *method))
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
        const std::string what = sleepDiffers(script, 2000);
        QVERIFY2(what.empty(), what.c_str());
    }

    void whatIsDampedFallsAsleep_data()
    {
        QTest::addColumn<QString>("method");
        for (const MethodPtr &method : support::fixedMethods()) {
            if (method->id() != "explicit_euler" && support::fits(homing(scriptOf(homing).values), *method))
                QTest::addRow("%s", method->id().c_str()) << QString::fromStdString(method->id());
        }
    }
    void whatIsDampedFallsAsleep()
    {
        QFETCH(QString, method);
        Track track(scriptOf(homing, method.toStdString()), budget);
        const std::int64_t from = sleepsFrom(track);
        QVERIFY2(from > 0, "it never sleeps");
        QVERIFY(track.sleep()->isStill());
        QVERIFY(track.isFinished());
        const std::string what = sleepDiffers(track.script(), from + 500);
        QVERIFY2(what.empty(), what.c_str());
    }

    void aFarFrameOfASleepingRunIsThereAtOnce()
    {
        auto count = make_shared<std::int64_t>(0);
        Script script = scriptOf(homing);
        script.build = [count](const Values &values) {
            Scene scene = homing(values);
            scene.effects.push_back(make_shared<Counting>(count));
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
        QCOMPARE(*count, computed); // no phase ran
        // The same run awake, as far as a test can wait for it.
        Track waker(script, 0, Sleeping::never);
        waker.seek({from + 3000, 0});
        track.seek({from + 3000, 0});
        QVERIFY(sameBits(track.state(), waker.state()));
        // Inside a frame its phases run, as always.
        const std::int64_t before = *count;
        track.seek({from + 3000, 3}); // two springs, and the one that counts
        QCOMPARE(*count, before + 2);
        track.seek({from + 3001, 0});
        waker.seek({from + 3001, 0});
        QVERIFY(sameBits(track.state(), waker.state()));
    }

    void aSleepingRunTakesNoMoreMemoryTheLongerItIs()
    {
        Track track(scriptOf(homing), budget);
        const std::int64_t from = sleepsFrom(track);
        QVERIFY(from > 0);
        const std::size_t states = track.keyframeCount(), bytes = track.keyframeBytes() + track.sleepBytes();
        for (std::int64_t frame = from; frame <= 10'000'000; frame += 9973)
            track.seek({frame, 0});
        for (int i = 0; i < 100; ++i) {
            track.seek({5'000'000 + i, 2}); // into frames, too
            track.seek({5'000'000 + i + 1, 0});
        }
        QCOMPARE(track.keyframeCount(), states);
        QCOMPARE(track.keyframeBytes() + track.sleepBytes(), bytes);
        QVERIFY(track.sleepBytes() <= CycleDetector::longest * byteSize(track.state()));
    }

    void aRoundOfAFewStatesSleepsTooButIsNotOver()
    {
        // x' = x + v', v' = v - x: with k = 1 and h = 1 semi-implicit Euler comes back after 6 frames, exactly.
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
        const double round[] = {16.0, 0.0, -16.0, -16.0, 0.0, 16.0};
        for (std::int64_t frame = 1'000'000; frame < 1'000'020; ++frame) {
            track.seek({frame, 0});
            QCOMPARE(track.state().positionOf(0).x, round[frame % 6]);
        }
        const std::string what = sleepDiffers(script, from + 100);
        QVERIFY2(what.empty(), what.c_str());
    }

    void whatWasComputedIsCountedOn()
    {
        // A method that counts its own evaluations tells the same number asleep.
        for (const char *method : {"backward_euler", "implicit_midpoint"}) {
            Track track(scriptOf(homing, method), budget);
            const std::int64_t from = sleepsFrom(track);
            QVERIFY(from > 0);
            Track waker(track.script(), 0, Sleeping::never);
            waker.seek({from + 777, 0});
            track.seek({from + 777, 0});
            QVERIFY(waker.state().pointEvaluations > 0);
            QCOMPARE(track.state().pointEvaluations, waker.state().pointEvaluations);
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
        Track track(script, small), straight(script, 0, Sleeping::never);
        support::Dice dice(3);
        for (int i = 0; i < 200; ++i) {
            const std::int64_t frame = dice.whole(0, 100'500);
            track.seek({frame, 0});
            QVERIFY(track.sleepBytes() <= small + CycleDetector::longest * byteSize(track.state()));
            QVERIFY(track.keyframeBytes() <= small);
            if (i % 40 == 0) {
                straight.seek({frame, 0});
                QVERIFY(sameBits(track.state(), straight.state()));
            }
        }
    }
};

QTEST_APPLESS_MAIN(TestSleep)
#include "tst_sleep.moc"

// Input wakes a sleeping run. Some effects prevent sleep.

#include "sim/run/script/composed_interval.h"
#include "tests/sim/support/sleep_scenes.h"
#include "tests/suite.h"

#include <QTest>

using namespace sleep_scenes;

class TestSleepWakes : public QObject
{
    Q_OBJECT

private slots:
    void everyKindOfInputWakesTheRun_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < wakingInputs().size(); ++i)
            QTest::addRow("%s", wakingInputs()[i].name) << int(i);
    }
    void everyKindOfInputWakesTheRun()
    {
        QFETCH(int, index);
        const WakingInput input = wakingInputs()[std::size_t(index)];
        Track undisturbed(scriptOf(input.build), budget);
        const std::int64_t from = sleepsFrom(undisturbed);
        QVERIFY(from > 0);
        Script script = scriptOf(input.build);
        for (std::int64_t frame : {from + 200, from + 201, from + 900})
            script.input.push_back({frame, input.event});
        script.input.push_back({from + 901, Release{}});
        Track track(script, budget);
        track.seek({from + 100, 0});
        QVERIFY(track.sleep());
        QVERIFY(!track.isFinished()); // input is still to come
        track.seek({from + 210, 0});
        QCOMPARE(!continueIdentically(track.state(), undisturbed.state()), input.changes);
        const std::string difference = sleepDiffers(script, from + 1500);
        QVERIFY2(difference.empty(), difference.c_str());
        // Seek far forward and back across all the input.
        Track reference(script, 0, Sleeping::never);
        reference.seek({from + 1200, 0});
        track.seek({from + 100'000, 0});
        track.seek({3, 1});
        track.seek({from + 1200, 0});
        QVERIFY(sameBits(track.state(), reference.state()));
    }

    void inputDuringSleepGivesTheSameRun()
    {
        Timeline timeline(scriptOf(homing));
        timeline.seek({5000, 0});
        QVERIFY(timeline.isFinished());
        timeline.seek({100'000, 0});
        timeline.seek({3000, 0});
        QVERIFY(!timeline.isFinished()); // the run is computed up to frame 100,000
        timeline.applyInput(Grab{"foot0"});
        timeline.applyInput(Move{{20.0, 20.0}});
        QVERIFY(!timeline.isFinished());
        timeline.seek({3005, 0});
        timeline.applyInput(Release{});
        timeline.seek({3200, 0});
        Track reference(timeline.script(), 0, Sleeping::never);
        reference.seek({3200, 0});
        QVERIFY(sameBits(timeline.state(), reference.state()));
        QVERIFY(timeline.comparison());
        Track before(scriptOf(homing), 0, Sleeping::never);
        before.seek({3200, 0});
        QVERIFY(sameBits(timeline.comparison()->state(), before.state()));
    }

    void effectThatDependsOnTimePreventsSleep()
    {
        auto count = make_shared<std::int64_t>(0);
        const auto with = [&](Dependence dependence) {
            Script script = scriptOf(homing);
            const EffectPtr counting = make_shared<CountingForce>(count, dependence);
            script.build = [counting](const Values &values) {
                Scene scene = homing(values);
                scene.effects.push_back(counting);
                return scene;
            };
            return Track(script, budget);
        };
        Track asleep = with(Dependence::scene), awake = with(Dependence::time);
        const std::int64_t from = sleepsFrom(asleep);
        QVERIFY(from > 0);
        QCOMPARE(sleepsFrom(awake, from + 500), std::int64_t(-1));
        const EffectPtr why = preventsSleep(awake.interval().pipeline, awake.state());
        QVERIFY(why);
        QCOMPARE(why->id(), std::string("counting"));
        QVERIFY(!preventsSleep(asleep.interval().pipeline, asleep.state()));
    }

    void sleepBlockerIsReported()
    {
        const auto why = [](const Script &script) {
            const Track track(script, 0);
            return sleepBlockerOf(track.interval().pipeline, track.state());
        };
        QCOMPARE(why(scriptOf(homing)).reason, SleepBlocker::Reason::nothing);
        QCOMPARE(why(scriptOf(homing, "dormand_prince")).reason, SleepBlocker::Reason::adaptiveSteps);
        QCOMPARE(why(scriptOf(windy)).reason, SleepBlocker::Reason::nothing); // the wind does not blow yet
        Script script = scriptOf(windy);
        script.input = {{1, Pointer{{50.0, 300.0}, true}}};
        Track track(script, 0);
        track.seek({5, 0});
        const SleepBlocker awake = sleepBlockerOf(track.interval().pipeline, track.state());
        QCOMPARE(awake.reason, SleepBlocker::Reason::time);
        QCOMPARE(awake.effect->id(), std::string("wind"));
    }

    void randomWindPreventsSleepOnlyWhileItBlows()
    {
        Script script = scriptOf(windy);
        script.input = {{300, Pointer{{50.0, 300.0}, true}}, {400, Pointer{{50.0, 300.0}, false}}};
        Track track(script, budget);
        track.seek({200, 0});
        QVERIFY(track.sleep());
        for (int frame = 301; frame < 400; ++frame) {
            track.seek({frame, 0});
            QVERIFY(!track.sleep());
        }
        QCOMPARE(preventsSleep(track.interval().pipeline, track.state())->id(), std::string("wind"));
        track.seek({600, 0});
        QVERIFY(track.sleep());
        const std::string difference = sleepDiffers(script, 700);
        QVERIFY2(difference.empty(), difference.c_str());
    }

    void removedInputInTheFirstCycleLeavesNoTrace_data()
    {
        QTest::addColumn<QString>("parameter");
        QTest::newRow("another stiffness") << "k";
        QTest::newRow("another scene, with more points") << "more";
    }
    void removedInputInTheFirstCycleLeavesNoTrace()
    {
        // A cycle of 6 frames. An event within the first cycle that is removed again must change nothing.
        QFETCH(QString, parameter);
        support::Sample sample;
        sample.values.set("k", 1.0);
        sample.values.set("more", 0.0);
        sample.build = [](const Values &values) {
            Scene scene = scenes::creature(1 + values.integer("more"));
            scene.start.place(0, {16.0, 0.0});
            scene.effects = {make_shared<PointSpring>(0, Vec2{0.0, 0.0}, values["k"])};
            return scene;
        };
        const Script withoutInput = support::script(sample, "semi_implicit_euler");
        Track undisturbed(withoutInput, budget);
        const std::int64_t from = sleepsFrom(undisturbed, 200);
        QVERIFY(from > 0);

        Script script = withoutInput;
        script.input = {{from + 3, Set{parameter.toStdString(), 2.0}}};
        const std::string difference = sleepDiffers(script, from + 100);
        QVERIFY2(difference.empty(), difference.c_str());
        Track track(script, budget);
        track.seek({from + 20, 0});
        track.seek({from, 0});
        track.replaceInput(track.prepareInput({}, from + 3));
        Track reference(withoutInput, 0, Sleeping::never);
        for (std::int64_t frame = from; frame < from + 20; ++frame) {
            track.seek({frame, 0});
            reference.seek({frame, 0});
            QVERIFY2(sameBits(track.state(), reference.state()), qPrintable(QString::number(frame)));
        }
    }

private:
    struct WakingInput
    {
        const char *name;
        Scene (*build)(const Values &);
        decltype(Event::what) event;
        bool changes; ///< whether the input changes the motion
    };
    static std::vector<WakingInput> wakingInputs()
    {
        return {{"grab", homing, Grab{"foot0"}, true},
                {"set", homing, Set{"k", 0.15}, true},
                {"key", waiting, Key{&Keys::right, true}, true},
                {"target", waiting, Target{{300.0, 50.0}}, true},
                {"pointer", waiting, Pointer{{12.0, 34.0}, false}, true},
                {"gust", windy, Gust{15.0}, false}};
    }
};

SUITE(tst_sleep_wakes, TestSleepWakes)
#include "tst_sleep_wakes.moc"

// What has come to rest sleeps: its rows are not computed, and no bit of the run differs.

#include "counting.h"
#include "support.h"

#include "sim/awake.h"
#include "sim/effects/body_spring.h"
#include "sim/effects/damping.h"
#include "sim/effects/gait_clock.h"
#include "sim/effects/gravity.h"
#include "sim/effects/leg_spring.h"
#include "sim/effects/motor.h"
#include "sim/effects/point_spring.h"
#include "sim/effects/pointer.h"
#include "sim/effects/radial_spring.h"
#include "sim/effects/steering.h"
#include "sim/effects/tree_wind.h"
#include "sim/methods/methods.h"
#include "sim/sleep.h"

#include <QTest>

using namespace sim;
using std::make_shared;
using support::Counting;

namespace {

constexpr std::size_t budget = std::size_t{1} << 24;

/// A point that a spring pulls home, to a place that a parameter decides, and one that hangs on it.
Scene homing(const Values &values)
{
    Scene scene = support::pointsOf(1);
    scene.start.place(0, {100.0, 90.0});
    scene.effects = {make_shared<PointSpring>(0, Vec2{260.0 + 100.0 * values["k"], 200.0}, 0.2),
                     make_shared<RadialSpring>(support::legs(1), values["k"], 50.0),
                     make_shared<Damping>(0.5)};
    return scene;
}

/// Legs that a key may set in motion, a point that follows the target, and one that follows the pointer.
Scene waiting(const Values &)
{
    Scene scene = support::pointsOf(3);
    scene.start.gait.setConstant(1, 0.3);
    scene.start.gaitSpeed.setConstant(1, 0.0);
    scene.start.outside.target = {100.0, 100.0};
    const LegRule rule{0.2, 50.0, 50.0, Aim::swing, Reaction::none};
    scene.effects = {make_shared<CarriedByPointer>(2),
                     make_shared<Steering>(0, 3, Reins{}),
                     make_shared<LegSpring>(std::vector<Leg>{{0, 3, 0.3, 0}}, rule),
                     make_shared<Motor>(1, 0.9, 0.25),
                     make_shared<PointSpring>(3, Vec2{200.0, 200.0}, 0.2),
                     make_shared<Damping>(0.5),
                     make_shared<GaitClock>()};
    return scene;
}

TreePtr bush()
{
    auto tree = make_shared<Tree>(Tree::ofTrunk(100.0));
    tree->sprout(0, -30.0, 0.8);
    tree->sprout(0, 30.0, 0.7);
    return tree;
}

/// A tree in wind whose turbulence is random.
Scene windy(const Values &)
{
    Scene scene;
    const TreePtr tree = bush();
    scene.start = State::ofPoints(tree->branches());
    scene.start.angle = Eigen::Map<const Eigen::ArrayXd>(tree->rest.data(), tree->branches());
    scene.names = {"trunk", "left", "right"};
    scene.groups = {{"branches", {0, tree->branches()}, Inertia::none}};
    scene.effects = {make_shared<TreeWind>(tree, TreeFormula::corrected, Resistance{}, Turbulence{20.0, 7})};
    return scene;
}

Script scriptOf(Scene (*build)(const Values &), const std::string &method = "semi_implicit_euler",
                double h = 1.0)
{
    Values values;
    values.set("k", 0.1);
    return support::script(support::Sample{{}, build, values}, method, h);
}

/// The first frame at which `track` is asleep.
std::int64_t sleepsFrom(Track &track, std::int64_t latest = 20'000)
{
    for (std::int64_t frame = 0; frame < latest; frame += track.rowFrames()) {
        track.seek({frame, 0});
        if (track.sleep())
            return frame;
    }
    return -1;
}

/// What differs first between a run that may sleep and one that never does, in `frames` frames.
std::string sleepDiffers(const Script &script, std::int64_t frames)
{
    Track sleeper(script, budget), waker(script, budget, Sleeping::never);
    for (std::int64_t frame = 0; frame <= frames; frame += sleeper.rowFrames()) {
        sleeper.seek({frame, 0});
        waker.seek({frame, 0});
        if (waker.sleep())
            return "the waker sleeps";
        const std::string what = support::difference(sleeper.now(), waker.now());
        if (!what.empty() || !sameBits(sleeper.now(), waker.now()))
            return "frame " + std::to_string(frame) + ": " + what;
    }
    return {};
}

}

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
        QVERIFY(track.isOver());
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
        const State rest = track.now();
        track.seek({from + 10'000'000, 0});
        QCOMPARE(track.at().frame, from + 10'000'000);
        QCOMPARE(track.now().frame, from + 10'000'000);
        QCOMPARE(track.computed(), from + 10'000'000);
        QVERIFY(runOnAlike(track.now(), rest));
        for (int i = 0; i < 1000; ++i)
            track.seek({from + i * 977, 0});
        QVERIFY(runOnAlike(track.stateAt(from + 123'456), rest));
        QCOMPARE(*count, computed); // no phase ran
        // The same run awake, as far as a test can wait for it.
        Track waker(script, 0, Sleeping::never);
        waker.seek({from + 3000, 0});
        track.seek({from + 3000, 0});
        QVERIFY(sameBits(track.now(), waker.now()));
        // Inside a frame its phases run, as always.
        const std::int64_t before = *count;
        track.seek({from + 3000, 3}); // two springs, and the one that counts
        QCOMPARE(*count, before + 2);
        track.seek({from + 3001, 0});
        waker.seek({from + 3001, 0});
        QVERIFY(sameBits(track.now(), waker.now()));
    }

    void aSleepingRunTakesNoMoreMemoryTheLongerItIs()
    {
        Track track(scriptOf(homing), budget);
        const std::int64_t from = sleepsFrom(track);
        QVERIFY(from > 0);
        const std::size_t states = track.keptStates(), bytes = track.keptBytes() + track.sleepBytes();
        for (std::int64_t frame = from; frame <= 10'000'000; frame += 9973)
            track.seek({frame, 0});
        for (int i = 0; i < 100; ++i) {
            track.seek({5'000'000 + i, 2}); // into frames, too
            track.seek({5'000'000 + i + 1, 0});
        }
        QCOMPARE(track.keptStates(), states);
        QCOMPARE(track.keptBytes() + track.sleepBytes(), bytes);
        QVERIFY(track.sleepBytes() <= SleepWatch::longest * memoryOf(track.now()));
    }

    void everyKindOfInputWakes_data()
    {
        QTest::addColumn<int>("index");
        for (std::size_t i = 0; i < wakers().size(); ++i)
            QTest::addRow("%s", wakers()[i].name) << int(i);
    }
    void everyKindOfInputWakes()
    {
        QFETCH(int, index);
        const Waker waker = wakers()[std::size_t(index)];
        Track alone(scriptOf(waker.build), budget);
        const std::int64_t from = sleepsFrom(alone);
        QVERIFY(from > 0);
        Script script = scriptOf(waker.build);
        for (std::int64_t frame : {from + 200, from + 201, from + 900})
            script.input.push_back({frame, waker.what});
        script.input.push_back({from + 901, Release{}});
        Track track(script, budget);
        track.seek({from + 100, 0});
        QVERIFY(track.sleep());
        QVERIFY(!track.isOver()); // something is still to come
        track.seek({from + 210, 0});
        QCOMPARE(!runOnAlike(track.now(), alone.now()), waker.changes);
        const std::string what = sleepDiffers(script, from + 1500);
        QVERIFY2(what.empty(), what.c_str());
        // A far way back and forth, over both of what wakes it.
        Track straight(script, 0, Sleeping::never);
        straight.seek({from + 1200, 0});
        track.seek({from + 100'000, 0});
        track.seek({3, 1});
        track.seek({from + 1200, 0});
        QVERIFY(sameBits(track.now(), straight.now()));
    }

    void aHandInTheMiddleOfASleepIsTheSameRun()
    {
        Timeline timeline(scriptOf(homing));
        timeline.seek({5000, 0});
        QVERIFY(timeline.isOver());
        timeline.seek({100'000, 0});
        timeline.seek({3000, 0});
        QVERIFY(!timeline.isOver()); // what was computed goes on to 100,000
        timeline.hand(Grab{"foot0"});
        timeline.hand(Move{{20.0, 20.0}});
        QVERIFY(!timeline.isOver());
        timeline.seek({3005, 0});
        timeline.hand(Release{});
        timeline.seek({3200, 0});
        Track straight(timeline.script(), 0, Sleeping::never);
        straight.seek({3200, 0});
        QVERIFY(sameBits(timeline.now(), straight.now()));
        QVERIFY(timeline.ghost());
        Track before(scriptOf(homing), 0, Sleeping::never);
        before.seek({3200, 0});
        QVERIFY(sameBits(timeline.ghost()->now(), before.now()));
    }

    void whatSeesTimeKeepsAwake()
    {
        auto count = make_shared<std::int64_t>(0);
        const auto with = [&](Sees sees) {
            Script script = scriptOf(homing);
            const EffectPtr counting = make_shared<Counting>(count, sees);
            script.build = [counting](const Values &values) {
                Scene scene = homing(values);
                scene.effects.push_back(counting);
                return scene;
            };
            return Track(script, budget);
        };
        Track asleep = with(Sees::scene), awake = with(Sees::time);
        const std::int64_t from = sleepsFrom(asleep);
        QVERIFY(from > 0);
        QCOMPARE(sleepsFrom(awake, from + 500), std::int64_t(-1));
        const EffectPtr why = keepsAwake(awake.shown().pipeline, awake.now());
        QVERIFY(why);
        QCOMPARE(why->id(), std::string("counting"));
        QVERIFY(!keepsAwake(asleep.shown().pipeline, asleep.now()));
    }

    void itIsToldWhatKeepsAwake()
    {
        const auto why = [](const Script &script) {
            const Track track(script, 0);
            return awakeBy(track.shown().pipeline, track.now());
        };
        QCOMPARE(why(scriptOf(homing)).why, Awake::Why::nothing);
        QCOMPARE(why(scriptOf(homing, "dormand_prince")).why, Awake::Why::ownSteps);
        QCOMPARE(why(scriptOf(windy)).why, Awake::Why::nothing); // no wind yet
        Script blown = scriptOf(windy);
        blown.input = {{1, Pointer{{50.0, 300.0}, true}}};
        Track track(blown, 0);
        track.seek({5, 0});
        const Awake awake = awakeBy(track.shown().pipeline, track.now());
        QCOMPARE(awake.why, Awake::Why::time);
        QCOMPARE(awake.effect->id(), std::string("wind"));
    }

    void randomWindKeepsAwakeOnlyWhileItBlows()
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
        QCOMPARE(keepsAwake(track.shown().pipeline, track.now())->id(), std::string("wind"));
        track.seek({600, 0});
        QVERIFY(track.sleep());
        const std::string what = sleepDiffers(script, 700);
        QVERIFY2(what.empty(), what.c_str());
    }

    void aRoundOfAFewStatesSleepsTooButIsNotOver()
    {
        // x' = x + v', v' = v - x: with k = 1 and h = 1 semi-implicit Euler comes back after 6 frames, exactly.
        Scene scene = support::pointsOf(1);
        scene.start.place(0, {16.0, 0.0});
        scene.start.place(1, {0.0, 0.0});
        scene.effects = {make_shared<PointSpring>(0, Vec2{0.0, 0.0}, 1.0)};
        const Script script = support::script(scene, "semi_implicit_euler");
        Track track(script, budget);
        const std::int64_t from = sleepsFrom(track, 200);
        QVERIFY(from > 0);
        QCOMPARE(track.sleep()->period(), 6);
        QVERIFY(!track.sleep()->isStill());
        QVERIFY(!track.isOver());
        const double round[] = {16.0, 0.0, -16.0, -16.0, 0.0, 16.0};
        for (std::int64_t frame = 1'000'000; frame < 1'000'020; ++frame) {
            track.seek({frame, 0});
            QCOMPARE(track.now().at(0).x, round[frame % 6]);
        }
        const std::string what = sleepDiffers(script, from + 100);
        QVERIFY2(what.empty(), what.c_str());
    }

    void inputInTheFirstRoundOfASleepIsNoPartOfIt_data()
    {
        QTest::addColumn<QString>("parameter");
        QTest::newRow("another stiffness") << "k";
        QTest::newRow("another scene, with more points") << "more";
    }
    void inputInTheFirstRoundOfASleepIsNoPartOfIt()
    {
        // As above: a round of 6 frames. What comes in within the first one, and is taken back, changes nothing.
        QFETCH(QString, parameter);
        support::Sample sample;
        sample.values.set("k", 1.0);
        sample.values.set("more", 0.0);
        sample.build = [](const Values &values) {
            Scene scene = support::pointsOf(1 + values.whole("more"));
            scene.start.place(0, {16.0, 0.0});
            scene.effects = {make_shared<PointSpring>(0, Vec2{0.0, 0.0}, values["k"])};
            return scene;
        };
        const Script still = support::script(sample, "semi_implicit_euler");
        Track alone(still, budget);
        const std::int64_t from = sleepsFrom(alone, 200);
        QVERIFY(from > 0);

        Script script = still;
        script.input = {{from + 3, Set{parameter.toStdString(), 2.0}}};
        const std::string what = sleepDiffers(script, from + 100);
        QVERIFY2(what.empty(), what.c_str());
        Track track(script, budget);
        track.seek({from + 20, 0});
        track.seek({from, 0});
        track.replaceInput({}, from + 3);
        Track straight(still, 0, Sleeping::never);
        for (std::int64_t frame = from; frame < from + 20; ++frame) {
            track.seek({frame, 0});
            straight.seek({frame, 0});
            QVERIFY2(sameBits(track.now(), straight.now()), qPrintable(QString::number(frame)));
        }
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
            QVERIFY(waker.now().evaluations > 0);
            QCOMPARE(track.now().evaluations, waker.now().evaluations);
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
        const std::size_t small = 40 * memoryOf(Track(script, 0).now());
        Track track(script, small), straight(script, 0, Sleeping::never);
        support::Dice dice(3);
        for (int i = 0; i < 200; ++i) {
            const std::int64_t frame = dice.whole(0, 100'500);
            track.seek({frame, 0});
            QVERIFY(track.sleepBytes() <= small + SleepWatch::longest * memoryOf(track.now()));
            QVERIFY(track.keptBytes() <= small);
            if (i % 40 == 0) {
                straight.seek({frame, 0});
                QVERIFY(sameBits(track.now(), straight.now()));
            }
        }
    }

private:
    struct Waker
    {
        const char *name;
        Scene (*build)(const Values &);
        decltype(Event::what) what;
        bool changes; ///< whether it changes where the scene goes
    };
    static std::vector<Waker> wakers()
    {
        return {{"grab", homing, Grab{"foot0"}, true},
                {"set", homing, Set{"k", 0.15}, true},
                {"key", waiting, Key{&Keys::right, true}, true},
                {"target", waiting, Target{{300.0, 50.0}}, true},
                {"pointer", waiting, Pointer{{12.0, 34.0}, false}, true},
                {"gust", windy, Gust{15.0}, false}};
    }
};

QTEST_APPLESS_MAIN(TestSleep)
#include "tst_sleep.moc"

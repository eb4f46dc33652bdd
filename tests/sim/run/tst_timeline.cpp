// Seeking to any cursor gives the bits of a straight run.

#include "sim/run/script/composed_interval.h"
#include "tests/sim/support/method_rows.h"
#include "tests/sim/support/support.h"
#include "tests/sizes.h"

#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/methods/methods.h"
#include "sim/run/phase_before.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;

namespace {

constexpr std::size_t tinyBudget = 4000; // a few states

/// A force that breaks the rule that effects have no memory: it grows with each call.
class ForceWithMemory : public Force
{
public:
    std::string id() const override { return "force_with_memory"; }
    std::string title() const override { return "force_with_memory"; }
    EffectKind kind() const override { return EffectKind::wind; }
    std::vector<Region> regions(DirectionRule) const override { return {}; }
    int count(const State &, PointRange points) const override { return points.count; }
    void add(const State &, PointRange movers, double scale, DirectionRule,
             Eigen::ArrayX2d &accelerations) const override
    {
        accelerations.middleRows(movers.first, movers.count) += scale * 1e-9 * ++m_calls;
    }
    bool addJacobian(const State &, PointRange, double, DirectionRule, Jacobian &) const override
    {
        return true;
    }
    std::vector<LiveValue> explain(const State &, int, DirectionRule) const override { return {}; }

private:
    mutable int m_calls = 0;
};

/// Returns a script in which bodies are dragged and thrown and parameters change.
Script withInput(Script script)
{
    const std::string body = script.build(script.values).names.front();
    script.input = {{3, Grab{body}},       {3, Move{{120, 90}}}, {5, Move{{160, 110}}},
                    {9, Move{{200, 100}}}, {10, Set{"k", 0.25}}, {14, Release{}},
                    {14, Grab{body}},      {15, Release{}},      {21, Set{"damp", 0.7}},
                    {21, Set{"k", 0.1}},   {22, Grab{"body"}},   {23, Move{{50, 60}}}};
    return script;
}

}

class TestTimeline : public QObject
{
    Q_OBJECT

private slots:
    void parameterChangeComposesTheSceneOnce()
    {
        int built = 0;
        Script script = support::script(support::sample("creature in a room"), "published");
        script.build = [&built, build = script.build](const Values &values) {
            ++built;
            return build(values);
        };
        Timeline timeline(script);
        QCOMPARE(built, 1);
        timeline.seek({20, 0});
        timeline.applyInput(Grab{"body"});
        timeline.applyInput(Move{{120, 90}});
        timeline.seek({25, 0});
        QCOMPARE(built, 1); // a drag changes no scene
        timeline.setParameter("k", 0.25);
        timeline.seek({40, 0});
        QCOMPARE(built, 2);
        std::vector<Event> input = timeline.script().input;
        input.push_back({60, Set{"damp", 0.7}});
        timeline.replaceInput(input);
        timeline.seek({80, 0});
        QCOMPARE(built, 3);
    }

    void stateBeforeLastPhaseIsThatOfThePreviousPhase()
    {
        for (const char *method : {"published", "semi_implicit_euler"}) {
            const support::Sample &sample = support::samples().front();
            Track track(support::script(sample, method, 0.5), std::size_t{1} << 20);
            for (int frame = 0; frame < 4; ++frame) {
                track.seek({frame, 0});
                QVERIFY(!stateBeforeLastPhase(track));
                for (int phase = 1; phase < track.phasesPerOutput(); ++phase) {
                    track.seek({frame, phase - 1});
                    State before = track.state();
                    track.seek({frame, phase});
                    if (phase == 1) // after the input of this output step
                        before = track.stateAfterInput(before, frame);
                    QVERIFY(sameBits(*stateBeforeLastPhase(track), before));
                }
            }
        }
    }

    void anyCursorHasTheBitsOfAStraightRun_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("h");
        for (const support::Sample &sample : support::samples()) {
            for (const MethodPtr &method : allMethods()) {
                if (!support::fits(sample.build(sample.values), *method))
                    continue;
                // Output steps depend on h in the same way for all methods, so two methods test all steps.
                std::vector<double> steps = {1.0};
                if (method->id() == "published" || method->id() == "semi_implicit_euler")
                    steps = {1.0, 0.25, 1.0 / 3, 2.0, 10.0};
                for (const double h : steps)
                    QTest::addRow("%s, %s, h = %.3g", sample.name.c_str(), method->id().c_str(), h)
                        << QString::fromStdString(sample.name) << QString::fromStdString(method->id()) << h;
            }
        }
    }
    void anyCursorHasTheBitsOfAStraightRun()
    {
        QFETCH(QString, scene);
        QFETCH(QString, method);
        QFETCH(double, h);
        const Script plain = support::script(support::sample(scene.toStdString()), method.toStdString(), h);
        for (const Script &script : {plain, withInput(plain)}) {
            for (const std::size_t bytes : {std::size_t{0}, tinyBudget, Timeline::defaultBudget}) {
                const std::string found =
                    support::seekMismatch(script, bytes, h > 2 ? 200 : 60, tests::sized(500, 40), 1);
                QVERIFY2(found.empty(), found.c_str());
            }
        }
    }

    void straightRunEqualsPlainPhases_data() { anyCursorHasTheBitsOfAStraightRun_data(); }
    void straightRunEqualsPlainPhases()
    {
        QFETCH(QString, scene);
        QFETCH(QString, method);
        QFETCH(double, h);
        const Script script = support::script(support::sample(scene.toStdString()), method.toStdString(), h);
        Track track(script, tinyBudget);
        track.seek({100, 0});
        const State expected = support::plainRun(script.build(script.values), method.toStdString(), h,
                                                 int(track.cursor().frame));
        QCOMPARE(support::difference(track.state(), expected), std::string());
    }

    void effectWithMemoryIsDetected_data() { support::addFixedMethodRows(); }
    void effectWithMemoryIsDetected()
    {
        QFETCH(QString, method);
        support::Sample sample = support::sample("creature in a room");
        const auto build = sample.build;
        sample.build = [build](const Values &values) {
            Scene scene = build(values);
            scene.effects.push_back(std::make_shared<ForceWithMemory>());
            return scene;
        };
        const Script script = support::script(sample, method.toStdString());
        QVERIFY(!support::seekMismatch(script, tinyBudget, 60, 500, 1).empty());
    }

    void phasesStepForwardAndBack_data()
    {
        QTest::addColumn<double>("h");
        for (const double h : {1.0, 0.5, 3.0})
            QTest::addRow("h = %g", h) << h;
    }
    void phasesStepForwardAndBack()
    {
        QFETCH(double, h);
        Timeline timeline(withInput(support::script(support::sample("creature in a room"), "published", h)));
        std::vector<std::pair<Cursor, State>> visited;
        while (timeline.cursor().frame < 30) {
            visited.emplace_back(timeline.cursor(), timeline.state());
            timeline.nextPhase();
        }
        for (; !visited.empty(); visited.pop_back()) {
            timeline.previousPhase();
            QVERIFY(timeline.cursor() == visited.back().first);
            QCOMPARE(support::difference(timeline.state(), visited.back().second), std::string());
        }
        timeline.previousPhase();
        QVERIFY(timeline.cursor() == (Cursor{0, 0}));
    }

    void outputStepsGoForwardAndBack()
    {
        Timeline timeline(support::script(support::sample("creature in a room"), "published", 2.0));
        timeline.seek({7, 0});
        QVERIFY(timeline.cursor() == (Cursor{6, 0})); // rounded down to an output step
        timeline.nextOutputStep();
        QVERIFY(timeline.cursor() == (Cursor{8, 0}));
        timeline.nextPhase();
        timeline.nextPhase();
        timeline.previousOutputStep();
        QVERIFY(timeline.cursor() == (Cursor{8, 0})); // first to the start of this output step
        timeline.previousOutputStep();
        QVERIFY(timeline.cursor() == (Cursor{6, 0}));
        timeline.nextPhase();
        timeline.nextOutputStep();
        QVERIFY(timeline.cursor() == (Cursor{8, 0}));
        timeline.seek({-5, -5});
        timeline.previousOutputStep();
        QVERIFY(timeline.cursor() == (Cursor{0, 0}));
    }

    void phaseBeyondTheLastIsTheNextOutputStep()
    {
        Timeline timeline(support::script(support::sample("spring to a point"), "published"));
        timeline.seek({5, 1000});
        QVERIFY(timeline.cursor() == (Cursor{6, 0}));
        timeline.seek({5, timeline.track().phasesPerOutput()});
        QVERIFY(timeline.cursor() == (Cursor{6, 0}));
        timeline.seek({2, 1000});
        QVERIFY(timeline.cursor() == (Cursor{3, 0}));
    }

    void liveValuesEndAtTheState_data()
    {
        QTest::addColumn<QString>("scene");
        QTest::addColumn<QString>("method");
        for (const support::Sample &sample : support::samples()) {
            for (const MethodPtr &method : allMethods()) {
                if (!support::fits(sample.build(sample.values), *method))
                    continue;
                QTest::addRow("%s, %s", sample.name.c_str(), method->id().c_str())
                    << QString::fromStdString(sample.name) << QString::fromStdString(method->id());
            }
        }
    }
    void liveValuesEndAtTheState()
    {
        QFETCH(QString, scene);
        QFETCH(QString, method);
        Track track(support::script(support::sample(scene.toStdString()), method.toStdString(), 0.5),
                    tinyBudget);
        QVERIFY(track.explainPhases("foot0").empty());
        const std::string name = track.interval().scene.names.front();
        int compared = 0;
        for (int i = 0; i < 200; ++i) {
            track.seek({track.cursor().frame, track.cursor().phase + 1});
            const State before = track.state();
            const std::vector<PhaseExplanation> explanations = track.explainPhases(name);
            QCOMPARE(support::difference(track.state(), before), std::string());
            const int phases = track.nextInterval()->pipeline.phasesPerStep();
            const int done = track.cursor().phase % phases == 0 ? phases : track.cursor().phase % phases;
            QCOMPARE(int(explanations.size()), done);
            for (const PhaseExplanation &explanation : explanations) {
                for (const LiveValue &live : explanation.live) {
                    if (live.name != "x" || explanation.phase + 1 != done)
                        continue;
                    ++compared;
                    QVERIFY(std::get<Vec2>(live.value) == before.positionOf(0));
                }
            }
        }
        QVERIFY(compared > 0);
        QVERIFY(track.explainPhases("nobody").empty());
    }

    void sceneOfTheIntervalBelongsToTheState()
    {
        Script script = support::script(support::sample("creature in a room"), "published");
        script.input = {{10, Set{"feet", 2}}, {20, Set{"feet", 4}}};
        Track track(script, tinyBudget);
        support::Dice dice(1);
        for (int i = 0; i < 300; ++i) {
            track.seek({dice.whole(0, 30), dice.whole(0, 9)});
            // The output step that ends at frame 10 is the first with two feet, including its phases.
            const std::int64_t end = track.cursor().frame + (track.cursor().phase > 0 ? 1 : 0);
            const int movedFeet = end < 10 ? 5 : end < 20 ? 2 : 4;
            QCOMPARE(track.state().pointCount(), movedFeet + 1);
            QCOMPARE(track.interval().scene.start.pointCount(), movedFeet + 1);
            QCOMPARE(track.interval().values.integer("feet"), movedFeet);
        }
    }

    void previewAppliesTheInputOfTheNextStep()
    {
        Script script = support::script(support::sample("creature in a room"), "published");
        script.input = {{4, Grab{"foot0"}}, {4, Move{{77, 88}}}};
        Track track(script, tinyBudget);
        track.seek({3, 0});
        std::shared_ptr<const ComposedInterval> interval;
        const State shown = track.preview(interval);
        QVERIFY(shown.positionOf(0) == (Vec2{77, 88}));
        QVERIFY(track.state().positionOf(0) != (Vec2{77, 88}));
        track.seek({3, 1});
        QVERIFY(support::difference(track.preview(interval), track.state()).empty());
    }
};

SUITE(tst_timeline, TestTimeline)
#include "tst_timeline.moc"

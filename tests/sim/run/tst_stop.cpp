// A run stops at its last finite frame, and names the effect and the body that failed first.

#include "sim/run/finite.h"
#include "sim/run/script/composed_interval.h"
#include "tests/sim/support/support.h"

#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

using namespace sim;

namespace {

/// Returns two springs that are much too stiff for their step, so the numbers overflow.
support::Sample unstablePair()
{
    support::Sample sample;
    sample.values.set("k", 5000.0);
    sample.build = [](const Values &values) {
        Scene scene = scenes::linearCreature(1, values["k"]);
        scene.start.place(0, {300, 230});
        return scene;
    };
    return sample;
}

/// Returns the title of the phase and the name of the body that are non-finite first after frame `lastFrame`.
std::pair<std::string, std::string> firstNonFinite(const Script &script, int lastFrame)
{
    const Scene scene = script.build(script.values);
    const Pipeline pipeline = compose(scene, *script.method, script.step);
    State state = support::plainRun(scene, script.method->id(), script.step.h, lastFrame);
    for (int i = 0; i < pipeline.phasesPerOutput(); ++i) {
        pipeline.phaseAt(i).run(state);
        for (int point = 0; point < state.pointCount(); ++point) {
            for (const Eigen::ArrayX2d *numbers : {&state.position, &state.velocity, &state.acceleration}) {
                if (numbers->rows() > 0 && !numbers->row(point).isFinite().all())
                    return {pipeline.phaseAt(i).title, scene.names[static_cast<std::size_t>(point)]};
            }
        }
    }
    return {};
}

/// Returns whether the numbers are finite `phase` phases after frame `lastFrame`.
bool isFiniteAfter(const Script &script, int lastFrame, int phase)
{
    const Scene scene = script.build(script.values);
    const Pipeline pipeline = compose(scene, *script.method, script.step);
    State state = support::plainRun(scene, script.method->id(), script.step.h, lastFrame);
    for (int i = 0; i < std::min(phase, pipeline.phasesPerOutput()); ++i)
        pipeline.phaseAt(i).run(state);
    return firstNonFinitePoint(state) < 0;
}

/// Returns the last finite frame, computed without a Track.
int lastFinite(const Script &script)
{
    const Scene scene = script.build(script.values);
    int frame = 0;
    const auto at = [&](int end) {
        return support::plainRun(scene, script.method->id(), script.step.h, end);
    };
    while (firstNonFinitePoint(at(frame + script.step.framesPerOutput)) < 0)
        frame += script.step.framesPerOutput;
    return frame;
}

}

class TestStop : public QObject
{
    Q_OBJECT

private:
    static void addRunRows()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("h");
        for (const MethodPtr &method : support::fixedMethods()) {
            const std::vector<std::string> needs = method->requirements();
            if (std::find(needs.begin(), needs.end(), "jacobian") != needs.end())
                continue; // implicit methods are stable at any stiffness and never stop
            for (const double h : {0.5, 1.0, 2.0})
                QTest::addRow("%s, h = %g", method->id().c_str(), h)
                    << QString::fromStdString(method->id()) << h;
        }
    }
    static Script scriptOf(const QString &method, double h)
    {
        return support::script(unstablePair(), method.toStdString(), h);
    }

private slots:
    void runStopsAtItsLastFiniteFrame_data() { addRunRows(); }
    void runStopsAtItsLastFiniteFrame()
    {
        QFETCH(QString, method);
        QFETCH(double, h);
        const Script script = scriptOf(method, h);
        const int lastFrame = lastFinite(script);
        Track track(script, 5000);
        track.seek({10'000, 0});
        QVERIFY(track.stop());
        QCOMPARE(track.stop()->frame, std::int64_t(lastFrame));
        QVERIFY(track.cursor() == (Cursor{lastFrame, 0}));
        QCOMPARE(track.computed(), std::int64_t(lastFrame));
        QCOMPARE(firstNonFinitePoint(track.state()), -1);
        const State expected =
            support::plainRun(script.build(script.values), method.toStdString(), h, lastFrame);
        QCOMPARE(support::difference(track.state(), expected), std::string());
    }

    void stopNamesTheEffectAndTheBody_data() { addRunRows(); }
    void stopNamesTheEffectAndTheBody()
    {
        QFETCH(QString, method);
        QFETCH(double, h);
        const Script script = scriptOf(method, h);
        Track track(script, 5000);
        track.seek({10'000, 0});
        QVERIFY(track.stop());
        const auto [phase, body] = firstNonFinite(script, static_cast<int>(track.stop()->frame));
        QCOMPARE(track.stop()->phase, phase);
        QCOMPARE(track.stop()->body, body);
        QCOMPARE(track.interval().scene.find(body), track.stop()->point);
        // The spring is the only possible cause, in whatever phase.
        QVERIFY(track.stop()->effect);
        QCOMPARE(track.stop()->effect->id(), std::string("body_spring"));
        QCOMPARE(track.stop()->other, 1 - track.stop()->point); // there are two points
        QCOMPARE(track.interval().scene.find(track.stop()->otherBody), track.stop()->other);
        // The force overflows first, or the positions that it leads to.
        const bool hasStages = findMethod(method.toStdString())->evaluationsPerStep() > 1;
        QVERIFY(phase == "spring" || (hasStages && (phase == "trial step" || phase == "move")));
    }

    void noCursorShowsNonFiniteNumbers_data() { addRunRows(); }
    void noCursorShowsNonFiniteNumbers()
    {
        QFETCH(QString, method);
        QFETCH(double, h);
        const Script script = scriptOf(method, h);
        const int lastFrame = lastFinite(script);
        const int phases = Track(script, 0).phasesPerOutput();
        Track stopped(script, 5000);
        stopped.seek({lastFrame + 10, 0});
        for (int phase = 0; phase <= phases + 1; ++phase) {
            Track fresh(script, 5000);
            fresh.seek({lastFrame, phase});
            QCOMPARE(firstNonFinitePoint(fresh.state()), -1);
            QCOMPARE(fresh.cursor().frame, std::int64_t(lastFrame));
            QVERIFY(fresh.cursor().phase == phase || !isFiniteAfter(script, lastFrame, phase));
            stopped.seek({lastFrame, phase}); // the result is the same whether the stop is known or not
            QVERIFY(stopped.cursor() == fresh.cursor());
            QCOMPARE(support::difference(stopped.state(), fresh.state()), std::string());
        }
    }

    void seekingBeyondTheEndStaysThere_data() { addRunRows(); }
    void seekingBeyondTheEndStaysThere()
    {
        QFETCH(QString, method);
        QFETCH(double, h);
        Timeline timeline(scriptOf(method, h));
        timeline.seek({10'000, 0});
        const Cursor end = timeline.cursor();
        const State state = timeline.state();
        for (const std::int64_t beyond : {std::int64_t{1}, std::int64_t{2}, std::int64_t{1'000'000'000}}) {
            timeline.seek({end.frame + beyond * 2, 1});
            QVERIFY(timeline.cursor() == end);
            QVERIFY(sameBits(timeline.state(), state));
        }
        timeline.nextOutputStep();
        QVERIFY(timeline.cursor() == end);
        timeline.previousOutputStep();
        QVERIFY(timeline.cursor().frame == end.frame - timeline.track().framesPerOutput());
        timeline.seek({10'000, 0});
        QVERIFY(timeline.cursor() == end && sameBits(timeline.state(), state));
    }

    void implicitMethodStopsIfAStepOverflows_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("h");
        QTest::addColumn<double>("k");
        QTest::addColumn<double>("velocity");
        for (const char *method : {"backward_euler", "implicit_midpoint", "tr_bdf2"}) {
            QTest::addRow("%s, an overflowing force", method) << QString(method) << 1.0 << 1e308 << 0.0;
            QTest::addRow("%s, an overflowing throw", method) << QString(method) << 1.0 << 1e6 << 1e307;
            // The forces are finite, but their product with the step is not.
            QTest::addRow("%s, an overflowing product", method) << QString(method) << 100.0 << 5e305 << 0.0;
        }
    }
    void implicitMethodStopsIfAStepOverflows()
    {
        QFETCH(QString, method);
        QFETCH(double, h);
        QFETCH(double, k);
        QFETCH(double, velocity);
        Script script = scriptOf(method, h);
        script.values.set("k", k);
        const Vec2 start = script.build(script.values).start.positionOf(0);
        script.bodies["foot0"] = {start, Vec2{velocity, 0.0}};
        Track track(script, 5000);
        track.seek({1000, 0});
        QVERIFY(track.stop());
        QCOMPARE(track.stop()->frame, std::int64_t(0));
        QCOMPARE(firstNonFinitePoint(track.state()), -1);
        QCOMPARE(track.stop()->body, std::string("foot0"));
        QVERIFY(track.stop()->effect);
        QCOMPARE(track.stop()->effect->id(), std::string("body_spring"));
    }

    void editBeforeTheStopLetsTheRunContinue()
    {
        Timeline timeline(scriptOf("published", 1.0));
        timeline.seek({10'000, 0});
        QVERIFY(timeline.stop());
        timeline.seek({5, 0});
        timeline.setParameter("k", 0.1);
        QVERIFY(!timeline.stop());
        timeline.seek({2000, 0});
        QVERIFY(!timeline.stop());
        QCOMPARE(timeline.cursor().frame, std::int64_t(2000));
        QVERIFY(timeline.comparison() && timeline.comparison()->stop()); // the comparison run still stops
        QCOMPARE(timeline.comparison()->cursor().frame, timeline.comparison()->stop()->frame);
    }

    void editAtTheStopLetsTheRunContinue()
    {
        Timeline timeline(scriptOf("published", 1.0));
        timeline.seek({10'000, 0});
        const std::int64_t end = timeline.cursor().frame;
        timeline.applyInput(Grab{"foot0"});
        timeline.setParameter("k", 0.0);
        QVERIFY(!timeline.stop());
        timeline.seek({end + 1, 0});
        QCOMPARE(timeline.cursor().frame, end + 1);
    }
};

SUITE(tst_stop, TestStop)
#include "tst_stop.moc"

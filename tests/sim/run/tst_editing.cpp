// Editing the past: the comparison run, later input, and bodies that are added or removed.

#include "sim/scene/scene.h"
#include "sim/scene/values.h"
#include "tests/sim/support/support.h"

#include "sim/base/error.h"
#include "tests/suite.h"

#include <QTest>

#include <limits>

using namespace sim;
using support::Dice;

namespace {

Script creature(double h = 1.0)
{
    return support::script(support::sample("creature in a room"), "published", h);
}

}

class TestEditing : public QObject
{
    Q_OBJECT

private slots:
    void comparisonRunEqualsTheOldRun()
    {
        for (std::uint64_t seed = 1; seed <= 50; ++seed) {
            Dice dice(seed);
            Timeline timeline(creature(dice.chance(0.5) ? 1.0 : 0.5), 30'000);
            timeline.seek({dice.whole(20, 60), 0});
            const Script old = timeline.script();
            timeline.seek({dice.whole(1, 15), dice.whole(0, 5)});
            const std::int64_t frame = timeline.cursor().frame;
            dice.chance(0.5) ? timeline.setParameter("k", 0.1) : timeline.applyInput(Grab{"foot0"});
            QVERIFY(timeline.comparison());
            QCOMPARE(timeline.forkFrame(), frame + 1);
            Track expected(old, 0);
            for (int i = 0; i < 30; ++i) {
                // Seek also beyond the frames that the old run had computed.
                timeline.seek({dice.whole(0, 100), 0});
                expected.seek(timeline.cursor());
                QCOMPARE(support::difference(timeline.comparison()->state(), expected.state()),
                         std::string());
                if (timeline.cursor().frame < timeline.forkFrame())
                    QVERIFY(sameBits(timeline.comparison()->state(), timeline.state()));
            }
        }
    }

    void editAtTheEndMakesNoComparisonRun()
    {
        Timeline timeline(creature());
        timeline.seek({30, 0});
        timeline.applyInput(Grab{"foot0"});
        timeline.setParameter("k", 0.1);
        QVERIFY(!timeline.comparison());
    }

    void dragMakesOneFork()
    {
        Timeline timeline(creature());
        timeline.seek({100, 0});
        timeline.seek({30, 0});
        timeline.applyInput(Grab{"foot0"});
        for (int i = 0; i < 10; ++i) {
            timeline.applyInput(Move{{100.0 + i, 100.0}});
            timeline.applyInput(Move{{100.0 + 2 * i, 100.0}}); // replaces the move before
            timeline.nextOutputStep();
        }
        QCOMPARE(timeline.forkFrame(), std::int64_t(31));
        QCOMPARE(timeline.script().input.size(), std::size_t(11));
        timeline.dropComparison();
        QVERIFY(!timeline.comparison());
    }

    void dragsRemoveLaterInputAndParametersKeepIt()
    {
        Timeline timeline(creature());
        timeline.seek({50, 0});
        timeline.applyInput(Grab{"foot0"});
        timeline.seek({60, 0});
        timeline.applyInput(Release{});
        timeline.seek({20, 0});
        timeline.setParameter("k", 0.1);
        QCOMPARE(timeline.script().input.size(), std::size_t(3));
        QVERIFY(std::holds_alternative<Set>(timeline.script().input.front().what));
        timeline.seek({55, 0});
        QCOMPARE(timeline.state().hold.point, 0);
        timeline.seek({30, 0});
        timeline.applyInput(Grab{"body"});
        QCOMPARE(timeline.script().input.size(), std::size_t(2));
    }

    void runAndComparisonRunCanBeSwapped()
    {
        for (std::uint64_t seed = 1; seed <= 20; ++seed) {
            Dice dice(seed);
            Timeline timeline(creature(), 30'000);
            timeline.seek({60, 0});
            timeline.seek({dice.whole(1, 30), dice.whole(0, 5)});
            dice.chance(0.5) ? timeline.setParameter("k", 0.1) : timeline.applyInput(Grab{"foot0"});
            for (int round = 0; round < 4; ++round) {
                const std::vector<Event> run = timeline.script().input,
                                         comparison = timeline.comparison()->script().input;
                const std::int64_t computed = timeline.comparison()->computed(), fork = timeline.forkFrame();
                timeline.swapWithComparison();
                QVERIFY(timeline.script().input == comparison &&
                        timeline.comparison()->script().input == run);
                QVERIFY(timeline.computed() >= computed);
                QCOMPARE(timeline.forkFrame(), fork);
                timeline.seek({dice.whole(0, 80), dice.whole(0, 3)});
                Track expected(timeline.script(), 0), expectedComparison(timeline.comparison()->script(), 0);
                expected.seek(timeline.cursor());
                expectedComparison.seek({timeline.cursor().frame, 0});
                QVERIFY(sameBits(expected.state(), timeline.state()) &&
                        sameBits(expectedComparison.state(), timeline.comparison()->state()));
            }
        }
    }

    void replacedInputIsComputedFromTheFirstDifference()
    {
        Timeline timeline(creature());
        timeline.seek({50, 0});
        const std::vector<Event> none;
        std::vector<Event> input = {{21, Set{"k", 0.1}}};
        QVERIFY(!timeline.replaceInput(none)); // unchanged
        QVERIFY(timeline.replaceInput(input));
        QCOMPARE(timeline.cursor().frame, std::int64_t(50));
        QCOMPARE(timeline.forkFrame(), std::int64_t(21));
        QCOMPARE(timeline.comparison()->computed(), std::int64_t(50));
        Track expected(timeline.script(), 0);
        expected.seek({50, 0});
        QVERIFY(sameBits(expected.state(), timeline.state()));
        input.push_back({80, Set{"damp", std::nan("")}});
        QVERIFY_THROWS_EXCEPTION(Error, timeline.replaceInput(input));
        QCOMPARE(timeline.script().input.size(), std::size_t(1));
        input.back() = {80, Set{"damp", 0.5}}; // after the computed frames, so no comparison run
        QVERIFY(!timeline.replaceInput(input));
        QVERIFY(sameBits(expected.state(), timeline.state()));
    }

    void inputOfFrameZeroCanBeReplaced()
    {
        Script script = creature();
        script.input = {{0, Set{"k", 0.1}}, {0, Grab{"body"}}};
        Timeline timeline(script);
        timeline.seek({20, 0});
        for (const std::vector<Event> &input :
             {std::vector<Event>{}, std::vector<Event>{{0, Grab{"foot0"}}, {3, Release{}}}, script.input}) {
            QVERIFY(timeline.replaceInput(input));
            QCOMPARE(timeline.cursor().frame, std::int64_t(20));
            Track expected(timeline.script(), 0);
            expected.seek({20, 0});
            QVERIFY(sameBits(expected.state(), timeline.state()));
            timeline.seek({0, 0});
            QVERIFY(sameBits(timeline.state(), Track(timeline.script(), 0).state()));
            timeline.seek({20, 0});
        }
    }

    void firstDifferenceIsTheFirstEventThatIsNotInBoth()
    {
        const std::vector<Event> input = {{5, Release{}}, {9, Set{"k", 0.1}}};
        QCOMPARE(firstDifference(input, input), std::numeric_limits<std::int64_t>::max());
        QCOMPARE(firstDifference(input, {}), std::int64_t(5));
        QCOMPARE(firstDifference(input, {{5, Release{}}}), std::int64_t(9));
        QCOMPARE(firstDifference(input, {{5, Release{}}, {7, Release{}}, {9, Set{"k", 0.1}}}),
                 std::int64_t(7));
        QCOMPARE(firstDifference(input, {{5, Release{}}, {9, Set{"k", 0.2}}}), std::int64_t(9));
    }

    void parameterSetAgainInTheSameFrameReplacesTheEvent()
    {
        Timeline timeline(creature());
        timeline.seek({20, 0});
        for (const double k : {0.1, 0.11, 0.12})
            timeline.setParameter("k", k);
        QCOMPARE(timeline.script().input.size(), std::size_t(1));
        QCOMPARE(timeline.values()["k"], 0.12);
        timeline.seek({0, 0});
        timeline.setParameter("k", 0.3); // at the start it changes the value, without an event
        QCOMPARE(timeline.script().input.size(), std::size_t(1));
        QCOMPARE(timeline.values()["k"], 0.3);
    }

    void changedNumberOfBodiesKeepsTheOthers()
    {
        Timeline timeline(creature());
        timeline.seek({20, 0});
        timeline.setParameter("gravity", 0.0);
        const State before = timeline.state();
        timeline.setParameter("feet", 3);
        timeline.setParameter("radius", 0.0);
        std::shared_ptr<const ComposedInterval> interval;
        const State preview = timeline.track().preview(interval);
        QCOMPARE(preview.pointCount(), 4);
        const int body = 3;
        for (int i = 0; i < 3; ++i)
            QVERIFY(preview.positionOf(i) == before.positionOf(i) &&
                    preview.velocityOf(i) == before.velocityOf(i));
        QVERIFY(preview.positionOf(body) == before.positionOf(5) &&
                preview.velocityOf(body) == before.velocityOf(5));
        timeline.setParameter("feet", 5);
        timeline.seek({21, 0});
        timeline.setParameter("feet", 4);
        timeline.seek({22, 0});
        QCOMPARE(timeline.state().pointCount(), 5);
    }

    void heldBodyStaysHeldWhenBodiesAreAdded()
    {
        Timeline timeline(creature());
        timeline.seek({10, 0});
        timeline.applyInput(Grab{"body"});
        timeline.applyInput(Move{{111, 122}});
        timeline.seek({12, 0});
        timeline.setParameter("feet", 2);
        timeline.seek({14, 0});
        QCOMPARE(timeline.state().hold.point, 2);
        QVERIFY(timeline.state().positionOf(2) == (Vec2{111, 122}));
        timeline.setParameter("feet", 5);
        timeline.seek({16, 0});
        QVERIFY(timeline.state().positionOf(5) == (Vec2{111, 122}));
        QVERIFY(!timeline.state().isDynamic(5) && timeline.state().isDynamic(2));
    }

    void removedBodyIsReleased()
    {
        Timeline timeline(creature());
        timeline.applyInput(Grab{"foot4"});
        timeline.seek({5, 0});
        timeline.setParameter("feet", 2);
        timeline.seek({8, 0});
        QCOMPARE(timeline.state().hold.point, -1);
    }

    void inputIsPendingUntilItsStepIsComputed()
    {
        Timeline timeline(creature());
        QVERIFY(!timeline.hasPendingInput());
        timeline.applyInput(Grab{"foot0"});
        QVERIFY(timeline.hasPendingInput());
        timeline.nextOutputStep();
        QVERIFY(!timeline.hasPendingInput());
        timeline.seek({0, 0});
        QVERIFY(!timeline.hasPendingInput());
    }

    void refusedParameterChangesNothing()
    {
        Script script = creature();
        const auto build = script.build;
        script.build = [build](const Values &values) {
            Scene scene = build(values);
            if (values["k"] > 1.0)
                scene.start.inverseMass.setZero(); // no dynamic points
            return scene;
        };
        Timeline timeline(script);
        timeline.seek({20, 0});
        timeline.seek({10, 2});
        const State before = timeline.state();
        QVERIFY_THROWS_EXCEPTION(Error, timeline.setParameter("k", 2.0));
        timeline.seek({0, 0});
        QVERIFY_THROWS_EXCEPTION(Error, timeline.setParameter("k", 2.0));
        timeline.seek({10, 2});
        QVERIFY(sameBits(timeline.state(), before));
        QVERIFY(timeline.script().input.empty() && !timeline.comparison());
    }

    void refusedInputIsFoundBeforeTheRun()
    {
        Script script = creature();
        const auto build = script.build;
        script.build = [build](const Values &values) {
            Scene scene = build(values);
            if (values["k"] > 1.0 && values["damp"] > 0.9)
                scene.start.inverseMass.setZero();
            return scene;
        };
        script.input = {{30, Set{"k", 2.0}}};
        Timeline timeline(script); // composes
        timeline.seek({10, 0});
        // The value does not compose together with the later event.
        QVERIFY_THROWS_EXCEPTION(Error, timeline.setParameter("damp", 0.95));
        timeline.seek({40, 0});
        script.input.push_back({40, Set{"damp", 0.95}});
        // The constructor throws, because stepping never does.
        QVERIFY_THROWS_EXCEPTION(Error, Timeline(script, 1000));
    }
};

SUITE(tst_editing, TestEditing)
#include "tst_editing.moc"

#include "sim/methods/methods.h"
#include "sim/pipeline/method.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"
#include "sim/scenes/creatures.h"
#include "tests/suite.h"

#include <QTest>

#include <cstring>

using namespace sim;

namespace {

/// A method that counts its steps in State::memory, moves the first point to 10 px times that number, and fails
/// in one frame.
class CountingMethod : public Method
{
public:
    explicit CountingMethod(std::int64_t failingFrame) : m_failingFrame(failingFrame) {}

    std::string id() const override { return "counting"; }
    std::string title() const override { return "Counting"; }
    int order() const override { return 1; }
    std::vector<std::string> requirements() const override { return {}; }
    DirectionRule directionRule() const override { return DirectionRule::published; }
    Region region() const override { return {}; }
    void prepareState(State &state) const override { state.memory.assign(sizeof(double), std::byte{0}); }
    std::vector<Phase> phases(const Scene &scene, StepSize) const override
    {
        Phase phase;
        phase.title = "count";
        phase.points = {0, scene.start.pointCount()};
        phase.innerEffects = scene.effects;
        phase.explain = motionChange;
        phase.kernels = {{[failingFrame = m_failingFrame](State &state) {
                              double count = 0.0;
                              std::memcpy(&count, state.memory.data(), sizeof count);
                              count += 1.0;
                              std::memcpy(state.memory.data(), &count, sizeof count);
                              state.place(0, {10.0 * count, 0.0});
                              state.stepFailed = state.frame == failingFrame;
                          },
                          {},
                          {}}};
        return {phase};
    }

private:
    std::int64_t m_failingFrame;
};

Script countingScript(std::int64_t failingFrame)
{
    Script script;
    script.build = [](const Values &) { return scenes::singleFoot(); };
    script.values.set("k", 0.25);
    script.method = std::make_shared<CountingMethod>(failingFrame);
    script.step = StepSize::ofLength(1.0);
    return script;
}

}

class MethodMemory : public QObject
{
    Q_OBJECT

    static constexpr std::size_t budget = 1 << 20;

private slots:
    void seekingBackRestoresTheMemory();
    void memoryIsComparedBitByBit();
    void memorySurvivesAChangedParameter();
    void runEndsBeforeTheFrameThatFailed();
    void sceneKeepsTheValuesThatItWasBuiltFrom();
    void holdKeepsThePositionBeforeTheDrag();
};

void MethodMemory::seekingBackRestoresTheMemory()
{
    Track track(countingScript(-1), 0); // only the initial state is kept, so seeking back computes again
    track.seek({50, 0});
    QCOMPARE(track.state().positionOf(0).x, 500.0);
    track.seek({7, 0});
    QCOMPARE(track.state().positionOf(0).x, 70.0);
    const State seventh = track.state();
    track.seek({50, 0});
    track.seek({7, 0});
    QVERIFY(sameBits(track.state(), seventh));
}

void MethodMemory::memoryIsComparedBitByBit()
{
    State a = State::ofPoints(1);
    a.memory.assign(3, std::byte{1});
    State b = a;
    QVERIFY(sameBits(a, b));
    b.memory[2] = std::byte{2};
    QVERIFY(!sameBits(a, b));
    QVERIFY(byteSize(a) == byteSize(State::ofPoints(1)) + 3);
}

void MethodMemory::memorySurvivesAChangedParameter()
{
    Script script = countingScript(-1);
    script.input = {{5, Set{"k", 0.5}}};
    Track track(script, budget);
    track.seek({9, 0});
    QCOMPARE(track.state().positionOf(0).x, 90.0);
}

void MethodMemory::runEndsBeforeTheFrameThatFailed()
{
    Track track(countingScript(6), budget);
    track.seek({20, 0});
    QCOMPARE(track.cursor().frame, std::int64_t{5});
    QVERIFY(track.stop().has_value());
    QVERIFY(track.stop()->reason == StopReason::stepFailed);
    QCOMPARE(track.stop()->frame, std::int64_t{5});
    QCOMPARE(track.stop()->point, -1);
    QCOMPARE(track.stop()->phase, std::string("count"));
    QVERIFY(!track.state().stepFailed);
    QCOMPARE(track.state().positionOf(0).x, 50.0);
}

void MethodMemory::sceneKeepsTheValuesThatItWasBuiltFrom()
{
    Script script = countingScript(-1);
    script.input = {{3, Set{"k", 0.5}}};
    Track track(script, budget);
    QCOMPARE((*track.intervalAt(2)->scene.values)["k"], 0.25);
    QCOMPARE((*track.intervalAt(3)->scene.values)["k"], 0.5);
}

void MethodMemory::holdKeepsThePositionBeforeTheDrag()
{
    Script script = countingScript(-1);
    script.method = findMethod("published");
    script.bodies["foot"] = {{100, 100}, Vec2{3, 4}};
    // Without an effect nothing bends the path: after frame 2 the foot is at (106, 108).
    script.input = {{3, Grab{"foot"}}, {3, Move{{150, 90}}}, {4, Move{{160, 95}}}};
    Track track(script, budget);
    track.seek({3, 0});
    QVERIFY(track.state().hold.positionBefore == (Vec2{106, 108}));
    QVERIFY(track.state().hold.velocityBefore == (Vec2{3, 4}));
    track.seek({4, 0});
    QVERIFY(track.state().hold.positionBefore == (Vec2{150, 90}));
    QVERIFY(track.state().hold.velocityBefore == (Vec2{44, -18}));
    QVERIFY(track.state().positionOf(0) == (Vec2{160, 95}));
}

SUITE(tst_method_memory, MethodMemory)
#include "tst_method_memory.moc"

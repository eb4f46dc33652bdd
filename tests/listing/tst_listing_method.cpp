#include "app/listing/listing_method.h"
#include "sim/base/error.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"
#include "sim/scene/values.h"
#include "sim/scenes/creatures.h"
#include "tests/listing/listing_support.h"
#include "tests/suite.h"

#include <QTest>

using namespace listing_support;
using sim::Cursor;
using sim::Vec2;

namespace {

constexpr std::size_t budget = 1 << 20;

/// Returns a script in which `text` moves one foot, which starts at (100, 100), and k is 0.25.
sim::Script scriptOf(const std::string &text)
{
    sim::Script script;
    script.build = [](const sim::Values &) {
        sim::Scene scene = scenes::singleFoot();
        scene.start.place(0, {100, 100});
        return scene;
    };
    script.values.set("k", 0.25);
    script.values.seed = 3;
    sim::Scene scene = script.build(script.values);
    scene.values = std::make_shared<const sim::Values>(script.values);
    const listing::Compiled compiled = listing::Program::compile(text, listing::vocabularyOf(scene));
    if (!compiled.program)
        qFatal("%s", compiled.errors.front().sentence.c_str());
    script.method = std::make_shared<listing::ListingMethod>(compiled.program);
    script.step = sim::StepSize::ofLength(1.0);
    return script;
}

const std::string clockListing = "double clock = 0;\n" + frameOf("clock += k;\nfoot.position.x = clock;");

}

class ListingMethodSuite : public QObject
{
    Q_OBJECT

private slots:
    void seekingBackIsExact();
    void parameterReachesTheProgramFromItsFrameOn();
    void changedPastIsComputedAgain();
    void releasedBodyKeepsTheVelocityOfTheHand();
    void listingThatDoesNotReadTheHandIgnoresIt();
    void runEndsBeforeTheFrameWithAnError();
    void cursorStopsBeforeThePhase();
    void restingRunSleeps();
    void runWithRandomNumbersStaysAwake();
    void otherStepsAreRejected();
    void missingMemoryIsInitialised();
};

void ListingMethodSuite::seekingBackIsExact()
{
    sim::Track track(scriptOf(clockListing),
                     0); // only the initial state is kept, so seeking back computes again
    track.seek({40, 0});
    QCOMPARE(track.state().positionOf(0).x, 10.0);
    track.seek({8, 0});
    QCOMPARE(track.state().positionOf(0).x, 2.0);
    const sim::State eighth = track.state();
    track.seek({40, 0});
    track.seek({8, 0});
    QVERIFY(sim::sameBits(track.state(), eighth));
}

void ListingMethodSuite::parameterReachesTheProgramFromItsFrameOn()
{
    sim::Script script = scriptOf(clockListing);
    script.input = {{5, sim::Set{"k", 2.0}}};
    sim::Track track(script, budget);
    track.seek({4, 0});
    QCOMPARE(track.state().positionOf(0).x, 1.0);
    track.seek({6, 0});
    QCOMPARE(track.state().positionOf(0).x, 5.0); // 4 * 0.25 + 2 * 2
}

void ListingMethodSuite::changedPastIsComputedAgain()
{
    sim::Track track(scriptOf(clockListing), budget);
    track.seek({10, 0});
    track.seek({2, 0});
    track.replaceInput(track.prepareInput({{4, sim::Set{"k", 1.0}}}, 4));
    track.seek({10, 0});
    QCOMPARE(track.state().positionOf(0).x, 3 * 0.25 + 7 * 1.0);
}

void ListingMethodSuite::releasedBodyKeepsTheVelocityOfTheHand()
{
    sim::Script script =
        scriptOf(fileText("lessons/single_spring/drag.code").replace(0, 0, "const double damp = 0.5;\n"));
    script.input = {
        {1, sim::Grab{"foot"}}, {2, sim::Move{{110, 90}}}, {3, sim::Move{{130, 94}}}, {4, sim::Release{}}};
    sim::Track track(script, budget);
    track.seek({1, 0});
    QVERIFY(track.state().velocityOf(0) == (Vec2{0, 0})); // grabbed, and the hand stands still
    track.seek({3, 0});
    QVERIFY(track.state().positionOf(0) == (Vec2{130, 94}));
    QVERIFY(track.state().velocityOf(0) == (Vec2{20, 4}));
    track.seek({4, 0});
    QVERIFY(track.state().velocityOf(0) == (Vec2{10, 2}));
    QVERIFY(track.state().positionOf(0) == (Vec2{140, 96}));
}

void ListingMethodSuite::listingThatDoesNotReadTheHandIgnoresIt()
{
    sim::Script script = scriptOf(frameOf("foot.position.x += 1;"));
    script.input = {{2, sim::Grab{"foot"}}, {3, sim::Move{{300, 300}}}};
    sim::Track track(script, budget);
    track.seek({6, 0});
    QVERIFY(track.state().positionOf(0) == (Vec2{106, 100}));
}

void ListingMethodSuite::runEndsBeforeTheFrameWithAnError()
{
    sim::Track track(scriptOf("int n = 5;\n" + frameOf("n -= 1;\nfoot.position.x = 12 / n;")), budget);
    track.seek({20, 0});
    QCOMPARE(track.cursor().frame, std::int64_t{4});
    QVERIFY(track.stop() && track.stop()->reason == sim::StopReason::stepFailed);
    QCOMPARE(track.stop()->phase, std::string("your code"));
    QCOMPARE(track.state().positionOf(0).x, 12.0);
    // the error itself, from the state before the frame
    const auto &method = static_cast<const listing::ListingMethod &>(*track.script().method);
    sim::State state = track.stateAfterInput(track.state(), track.stop()->frame);
    const auto error = method.program().run(
        state, listing::bind(method.program().vocabulary(), track.nextInterval()->scene));
    QVERIFY(error && error->kind == listing::RunErrorKind::divisionByZero && error->line == 5);
    QCOMPARE(shown(error->variables, "n"), std::string("n = 0"));
}

void ListingMethodSuite::cursorStopsBeforeThePhase()
{
    sim::Track track(scriptOf(clockListing), budget);
    QCOMPARE(track.phasesPerOutput(), 1);
    track.seek({3, 0});
    const auto interval = track.nextInterval();
    QCOMPARE(interval->pipeline.phases.front().title, std::string("your code"));
    QCOMPARE(track.explainPhases("foot").size(), std::size_t{1});
    QCOMPARE(track.explainPhases("foot").front().live.size(), std::size_t{1}); // x changed
}

void ListingMethodSuite::restingRunSleeps()
{
    sim::Track track(scriptOf(frameOf("foot.position.x = min(110, foot.position.x + 1);")), budget);
    track.seek({1'000'000'000, 0});
    QVERIFY(track.sleep() && track.sleep()->isStill());
    QCOMPARE(track.state().positionOf(0).x, 110.0);
}

void ListingMethodSuite::runWithRandomNumbersStaysAwake()
{
    sim::Track track(scriptOf(frameOf("foot.position.x = 100 + 0 * random(0);")), budget);
    track.seek({300, 0});
    QVERIFY(!track.sleep());
}

void ListingMethodSuite::otherStepsAreRejected()
{
    sim::Script script = scriptOf(clockListing);
    script.step = sim::StepSize::ofLength(0.5);
    try {
        sim::Track::check(script);
        QFAIL("accepted");
    } catch (const sim::Error &error) {
        QCOMPARE(error.id(), std::string("listing-needs-frame-steps"));
        QCOMPARE(error.values().at("h"), std::string("0.5"));
    }
}

void ListingMethodSuite::missingMemoryIsInitialised()
{
    Bench bench("double clock = 8;\n" + frameOf("clock += 1;\nbody.position.x = clock;"));
    bench.state.memory.assign(3, std::byte{9}); // of another listing
    QVERIFY(!bench.run());
    QCOMPARE(bench.body().x, 9.0);
}

SUITE(tst_listing_method, ListingMethodSuite)
#include "tst_listing_method.moc"

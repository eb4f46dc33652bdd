// The variables of a listing: globals are kept in the state from frame to frame, locals are not.

#include "sim/effects/constraints/sticks.h"
#include "sim/scenes/creatures.h"
#include "tests/listing/listing_support.h"
#include "tests/suite.h"

#include <QTest>

using namespace listing_support;
using sim::Vec2;

class ListingVariables : public QObject
{
    Q_OBJECT

private slots:
    void globalsAreInTheState();
    void globalsBeginWithTheParametersOfTheFirstFrame();
    void globalsSurviveTheRemovalOfACreature();
    void globalsSurviveTheRemovalOfAStick();
    void localsAreInitialisedInEveryFrame();
};

void ListingVariables::globalsAreInTheState()
{
    Bench bench("double clock = 0.5;\nint turns = 3;\nVec2 last = body.position;\nbool started = false;\n" +
                frameOf("clock += 0.25; turns--; if (!started) last.x += 1; started = true;\n"
                        "body.position = Vec2(clock, turns); body.velocity = last;"));
    QVERIFY(!bench.run());
    const sim::State first = bench.state;
    QVERIFY(first.positionOf(3) == (Vec2{0.75, 2}));
    QVERIFY(first.velocityOf(3) == (Vec2{101, 50}));
    QCOMPARE(first.memory.size(), std::size_t{8 + 4 + 16 + 1});
    QVERIFY(!bench.run());
    const sim::State second = bench.state;
    QVERIFY(second.positionOf(3) == (Vec2{1, 1}));
    bench.state = first; // going back
    QVERIFY(!bench.run());
    QVERIFY(sim::sameBits(bench.state, second));
}

void ListingVariables::globalsBeginWithTheParametersOfTheFirstFrame()
{
    Bench bench("double half = radius / 2;\n" + frameOf("body.position.x = half;"));
    bench.binding.parameters[2] = 8;
    QVERIFY(!bench.run());
    QCOMPARE(bench.body().x, 4.0);
    bench.binding.parameters[2] = 100; // later changes do not reach them
    QVERIFY(!bench.run());
    QCOMPARE(bench.body().x, 4.0);
}

void ListingVariables::globalsSurviveTheRemovalOfACreature()
{
    const std::string text =
        "double way = creatures[2].gait;\n" + frameOf("way += 1; creatures[0].gait = way;");
    Bench first(text, threeCreatures());
    QVERIFY(!first.run());
    sim::Scene fewer = scenes::crowd(2, 2);
    fewer.start.gait = fewer.start.gaitSpeed = Eigen::ArrayXd::Zero(2);
    fewer.values = first.scene.values;
    Bench second(text, fewer); // compiled again, so its globals had no value yet
    second.state.memory = first.state.memory;
    QVERIFY(!second.run());
    QCOMPARE(second.state.gait[0], 4.0);
}

void ListingVariables::globalsSurviveTheRemovalOfAStick()
{
    const std::string text = "double way = sticks[1].length + points[1].position.x;\n" +
                             frameOf("way += 1; points[0].position.x = way; sticks[0].b.position.y = way;");
    Bench first(text, twoSticks());
    QVERIFY(!first.run());
    sim::Scene fewer = twoSticks();
    fewer.effects.clear();
    scenes::add<sim::Sticks>(fewer, std::vector<sim::Stick>{{0, 1, 10, 0.25}}, 3);
    Bench second(text, fewer); // compiled again, so its globals had no value yet
    second.state.memory = first.state.memory;
    QVERIFY(!second.run());
    QVERIFY(second.state.positionOf(0) == (Vec2{12, 0}));
    QVERIFY(second.state.positionOf(1) == (Vec2{3, 12}));
}

void ListingVariables::localsAreInitialisedInEveryFrame()
{
    Bench bench =
        Bench::ofFrame("double sum = 0; Vec2 v; sum += 1; v.x += 2; body.position = Vec2(sum, v.x);");
    for (int i = 0; i < 3; ++i)
        QVERIFY(!bench.run());
    QVERIFY(bench.body() == (Vec2{1, 2}));
}

SUITE(tst_listing_variables, ListingVariables)
#include "tst_listing_variables.moc"

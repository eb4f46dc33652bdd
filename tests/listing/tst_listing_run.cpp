#include "app/listing/program.h"
#include "sim/base/direction.h"
#include "sim/base/random.h"
#include "sim/effects/tree/joints.h"
#include "sim/scenes/trees.h"
#include "sim/simd/portable_math.h"
#include "tests/listing/listing_support.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>

using namespace listing_support;
using sim::Vec2;

class ListingRun : public QObject
{
    Q_OBJECT

private slots:
    void freeFallFollowsItsClosedForm();
    void dampedGlideEndsAtTheSumOfItsSeries();
    void operatorsComputeByHand_data();
    void operatorsComputeByHand();
    void arrayReachesEveryBody();
    void bodyVariableStandsForTheBody();
    void bodiesAreEqualIfTheyAreTheSame();
    void anglesAndTheGaitClockAreInTheState();
    void creatureHasItsBodyItsFeetAndItsClock();
    void creatureVariableStandsForTheCreature();
    void floorOfARoomIsANumber();
    void branchHasTheNumbersOfTheTree();
    void functionThatCallsItselfReachesEveryBranch();
    void anglesUseTheFunctionsOfTheTree();
    void gustIsInTheState();
    void stickJoinsTwoBodies();
    void stickVariableStandsForTheStick();
    void beforeIsThePositionAtTheStartOfTheFrame();
    void directionOfCoincidentPointsHasLengthOne();
    void directionOfABranchIsWhereItPoints();
    void newTargetsAreTheTargetsOfThisFrame();
    void vectorsAndNumbersArePassedByValue();
    void functionThatCallsItselfComputesFactorials();
    void inputReachesTheProgram();
    void handAndPointerAreSeparate();
    void heldBodyHasItsPositionBeforeTheDrag();
    void randomDependsOnSeedFrameAndIndexOnly();
    void handleAndBodyHaveTheirMassAndRadius();
};

void ListingRun::freeFallFollowsItsClosedForm()
{
    Bench bench = Bench::ofFrame("body.velocity.y += 0.5; body.position += body.velocity;");
    for (int i = 0; i < 20; ++i)
        QVERIFY(!bench.run());
    // v = n g, y = g n (n + 1) / 2
    QVERIFY(bench.state.velocityOf(3) == (Vec2{0, 10}));
    QVERIFY(bench.body() == (Vec2{100, 50 + 0.5 * 20 * 21 / 2}));
}

void ListingRun::dampedGlideEndsAtTheSumOfItsSeries()
{
    Bench bench = Bench::ofFrame("body.velocity *= damp; body.position += body.velocity;");
    bench.state.setVelocity(3, {64, -32});
    for (int i = 0; i < 80; ++i)
        QVERIFY(!bench.run());
    // damp = 1/2: the sum of the series is the first velocity
    QVERIFY(sim::length(bench.body() - (Vec2{164, 18})) < 1e-12);
}

void ListingRun::operatorsComputeByHand_data()
{
    QTest::addColumn<QString>("expression");
    QTest::addColumn<double>("x");
    QTest::addColumn<double>("y");
    const auto row = [](const char *expression, double x, double y) {
        QTest::newRow(expression) << QString::fromLatin1(expression) << x << y;
    };
    row("Vec2(1, 2) + Vec2(3, 5)", 4, 7);
    row("Vec2(1, 2) - Vec2(3, 5)", -2, -3);
    row("2 * Vec2(1, 2)", 2, 4);
    row("Vec2(1, 2) * 2", 2, 4);
    row("Vec2(1, 2) / 4", 0.25, 0.5);
    row("-Vec2(1, 2)", -1, -2);
    row("Vec2(length(Vec2(3, 4)), dot(Vec2(1, 2), Vec2(3, 4)))", 5, 11);
    row("Vec2(atan2(1, 0), pow(2, 10))", std::acos(0.0), 1024);
    row("Vec2(sin(0.5), cos(0.5))", std::sin(0.5), std::cos(0.5));
    row("Vec2(sqrt(2), abs(-3))", std::sqrt(2.0), 3);
    row("Vec2(min(1, 2.5), max(1, 2.5))", 1, 2.5);
    row("Vec2(clamp(7, 1, 3), clamp(-7, 1, 3))", 3, 1);
    row("Vec2(clamp(2, 3, 1), clamp(7, 3, 1))", 1, 1); // no number is in this range
    row("Vec2(hypot(3, 4), hypot(-5, 12))", 5, 13);
    row("Vec2(remainder(350, 360), remainder(-190, 360))", -10, 170); // the short way round
    row("Vec2(floor(1.9), floor(-1.1))", 1, -2);
    row("Vec2((feet.count + 4) / 2, 7 % 4)", 3, 3);
    row("Vec2(7 / 2.0, 1.0 / 4)", 3.5, 0.25);
    row("Vec2(Vec2(1, 2) == Vec2(1, 2) ? 1 : 0, Vec2(1, 2) != Vec2(1, 2) ? 1 : 0)", 1, 0);
    row("Vec2(k, radius) + Vec2(pi, 0)", 0.25 + std::acos(-1.0), 50);
    row("Vec2(feet.count, frame_number)", 3, 1);
}

void ListingRun::operatorsComputeByHand()
{
    QFETCH(QString, expression);
    QFETCH(double, x);
    QFETCH(double, y);
    Bench bench = Bench::ofFrame("body.position = " + expression.toStdString() + ";");
    QVERIFY(!bench.run());
    QCOMPARE(bench.body().x, x);
    QCOMPARE(bench.body().y, y);
}

void ListingRun::arrayReachesEveryBody()
{
    Bench bench = Bench::ofFrame("for (int i = 0; i < feet.count; i++)\n    feet[i].position.y = 2 * i;");
    QVERIFY(!bench.run());
    for (int i = 0; i < 3; ++i)
        QVERIFY(bench.state.positionOf(i) == (Vec2{10.0 * i, 2.0 * i}));
    QVERIFY(bench.body() == (Vec2{100, 50}));
}

void ListingRun::bodyVariableStandsForTheBody()
{
    Bench bench("void push(Body me, Body other) { me.velocity += other.position; other.velocity.x = 9; }\n" +
                frameOf("Body first = feet[1]; push(first, body); first.position.y = 4;"));
    QVERIFY(!bench.run());
    QVERIFY(bench.state.velocityOf(1) == (Vec2{100, 50}));
    QVERIFY(bench.state.velocityOf(3) == (Vec2{9, 0}));
    QVERIFY(bench.state.positionOf(1) == (Vec2{10, 4}));
}

void ListingRun::bodiesAreEqualIfTheyAreTheSame()
{
    Bench bench(
        "double neighbours(Body me)\n{\n    double sum = 0;\n    for (int i = 0; i < feet.count; i++)\n"
        "    {\n        if (feet[i] == me)\n            continue;\n        sum += 1;\n    }\n"
        "    return sum;\n}\n" +
        frameOf("body.position = Vec2(neighbours(feet[1]), neighbours(body));"));
    QVERIFY(!bench.run());
    QVERIFY(bench.body() == (Vec2{2, 3}));
}

void ListingRun::anglesAndTheGaitClockAreInTheState()
{
    sim::Scene scene = threeFeet();
    scene.start.angle = Eigen::ArrayXd::Constant(4, 30.0);
    scene.start.spin = Eigen::ArrayXd::Constant(4, 2.0);
    scene.start.gait = Eigen::ArrayXd::Constant(1, 0.5);
    scene.start.gaitSpeed = Eigen::ArrayXd::Constant(1, 0.25);
    const listing::Compiled compiled =
        listing::Program::compile(frameOf("gait += gait_speed; body.angle += body.spin; feet[0].spin = 7;"),
                                  listing::vocabularyOf(scene));
    QVERIFY(compiled.program);
    sim::State state = scene.start;
    QVERIFY(!compiled.program->run(state, listing::bind(compiled.program->vocabulary(), scene)));
    QCOMPARE(state.gait[0], 0.75);
    QCOMPARE(state.angle[3], 32.0);
    QCOMPARE(state.angle[0], 30.0);
    QCOMPARE(state.spin[0], 7.0);
}

void ListingRun::creatureHasItsBodyItsFeetAndItsClock()
{
    Bench bench(frameOf("for (int i = 0; i < creatures.count; i++)\n"
                        "{\n"
                        "    creatures[i].body.position = Vec2(i, creatures[i].feet.count);\n"
                        "    creatures[i].feet[1].velocity = Vec2(creatures[i].body.radius, 10 * i);\n"
                        "    creatures[i].gait += creatures[i].gait_speed;\n"
                        "    creatures[i].gait_speed = -i;\n"
                        "}"),
                threeCreatures());
    QVERIFY(!bench.run());
    for (int i = 0; i < 3; ++i) { // each has two feet, then its body
        QVERIFY(bench.state.positionOf(3 * i + 2) == (Vec2{1.0 * i, 2}));
        QVERIFY(bench.state.velocityOf(3 * i + 1) == (Vec2{15, 10.0 * i}));
        QVERIFY(bench.state.velocityOf(3 * i) == (Vec2{0, 0}));
        QCOMPARE(bench.state.gait[i], i + 0.5);
        QCOMPARE(bench.state.gaitSpeed[i], double(-i));
    }
}

void ListingRun::creatureVariableStandsForTheCreature()
{
    Bench bench("int number(Creature me)\n{\n    for (int i = 0; i < creatures.count; i++)\n"
                "        if (creatures[i] == me)\n            return i;\n    return -1;\n}\n" +
                    frameOf("Creature last = creatures[2];\nBody foot = last.feet[0];\n"
                            "foot.position.x = number(last);\n"
                            "if (last.body != foot && foot == last.feet[0])\n    foot.position.y = 1;"),
                threeCreatures());
    const listing::Trace trace = bench.program->trace(bench.state, bench.binding);
    const std::vector<listing::Variable> &variables =
        trace.lines.at(trace.lines.size() - 2).variables; // before '}'
    QCOMPARE(shown(variables, "last"), std::string("last = creatures[2]"));
    QCOMPARE(shown(variables, "foot"), std::string("foot = creatures[2].feet[0]"));
    QCOMPARE(listing::typeName(variables.front().value), std::string("Creature"));
    QCOMPARE(std::get<listing::BodyReference>(variables.front().value).point, 8);
    QVERIFY(!bench.run());
    QVERIFY(bench.state.positionOf(6) == (Vec2{2, 1}));
}

void ListingRun::floorOfARoomIsANumber()
{
    Bench bench(frameOf("creatures[0].body.position.y = floor - creatures[0].body.radius;"),
                threeCreatures());
    QVERIFY(!bench.run());
    QCOMPARE(bench.state.positionOf(2).y, 365.0);
}

void ListingRun::branchHasTheNumbersOfTheTree()
{
    Bench bench(frameOf("Body trunk = branches[0]; Body right = trunk.children[1];\n"
                        "trunk.velocity = Vec2(trunk.children.count, right.children.count);\n"
                        "branches[1].velocity = Vec2(right.number, right.rest);\n"
                        "right.velocity = Vec2(right.scale, right.length);\n"
                        "branches[1].spin = trunk.inertia;"),
                swingingBush());
    QVERIFY(!bench.run());
    QVERIFY(bench.state.velocityOf(0) == (Vec2{2, 0}));
    QVERIFY(bench.state.velocityOf(1) == (Vec2{2, 30}));
    QVERIFY(bench.state.velocityOf(2) == (Vec2{0.7, 70}));
    // a rod of mass 1 and length 1 in units of its own inertia, with two masses at its end: 1 + 3 (0.8^3 + 0.7^3)
    QCOMPARE(bench.state.spin[1], 1 + 3 * (0.512 + 0.343));
}

void ListingRun::functionThatCallsItselfReachesEveryBranch()
{
    Bench bench("int grow(Body branch, int level)\n{\n    int count = 1;\n    branch.spin = level;\n"
                "    for (int i = 0; i < branch.children.count; i++)\n"
                "        count += grow(branch.children[i], level + 1);\n    return count;\n}\n" +
                    frameOf("branches[0].velocity.x = grow(branches[0], 1);"),
                swingingBush());
    QVERIFY(!bench.run());
    QCOMPARE(bench.state.velocityOf(0).x, 3.0);
    QVERIFY((bench.state.spin == Eigen::Array3d(1, 2, 2)).all());
}

void ListingRun::anglesUseTheFunctionsOfTheTree()
{
    const std::string text = frameOf("branches[0].position = Vec2(cos(0.3), sin(-2.2));\n"
                                     "branches[1].position.x = atan2(3, -0.4);");
    Bench swinging(text, swingingBush()); // the wave of a gust
    QVERIFY(!swinging.run());
    QCOMPARE(swinging.state.positionOf(0).x, std::cos(0.3));
    QCOMPARE(swinging.state.positionOf(0).y, std::sin(-2.2));
    const auto tree = std::make_shared<const sim::Tree>(scenes::bush());
    sim::Scene standing = scenes::standingTree(*tree, {0, 0}, sim::TreeFormula::corrected);
    scenes::add<sim::Joints>(standing, tree, sim::degreesPerRadian);
    Bench corrected(text, standing);
    QVERIFY(!corrected.run());
    QCOMPARE(corrected.state.positionOf(0).x, sim::portable::fast::cos(0.3));
    QCOMPARE(corrected.state.positionOf(0).y, sim::portable::fast::sin(-2.2));
    sim::Scene printed = scenes::standingTree(*tree, {0, 0}, sim::TreeFormula::published);
    scenes::add<sim::Joints>(printed, tree, sim::publishedDegrees);
    Bench published(text, printed);
    QVERIFY(!published.run());
    QCOMPARE(published.state.positionOf(0).x, sim::portable::cos(0.3));
    QCOMPARE(published.state.positionOf(0).y, sim::portable::sin(-2.2));
    QCOMPARE(published.state.positionOf(1).x, sim::portable::atan2(3, -0.4));
    QVERIFY(std::abs(published.state.positionOf(1).x - std::atan2(3, -0.4)) < 1e-15);
}

void ListingRun::gustIsInTheState()
{
    Bench bench(frameOf("gust_front += 12;\nif (gust_front > 20) gust_tail = gust_front - 20;\n"
                        "branches[0].velocity = Vec2(gust, gust_known ? 1 : 0);"),
                swingingBush());
    QVERIFY(!bench.run());
    QVERIFY(bench.state.velocityOf(0) == (Vec2{0, 0}));
    bench.state.input.gust = -15;
    QVERIFY(!bench.run());
    QCOMPARE(bench.state.gustExtent.front, 24.0);
    QCOMPARE(bench.state.gustExtent.tail, 4.0);
    QVERIFY(bench.state.velocityOf(0) == (Vec2{-15, 1}));
}

void ListingRun::stickJoinsTwoBodies()
{
    Bench bench(
        frameOf("for (int i = 0; i < sticks.count; i++)\n"
                "    sticks[i].b.velocity = Vec2(sticks[i].length, sticks[i].share);\n"
                "sticks[0].a.position = Vec2(8, 9);\n"
                "if (sticks[0].b == sticks[1].a && sticks[1].a == points[1])\n    points[1].position.x = 1;"),
        twoSticks());
    QVERIFY(!bench.run());
    QVERIFY(bench.state.velocityOf(1) == (Vec2{10, 0.25}));
    QVERIFY(bench.state.velocityOf(2) == (Vec2{7, 0.5})); // reached only through its stick
    QVERIFY(bench.state.positionOf(0) == (Vec2{8, 9}));
    QVERIFY(bench.state.positionOf(1) == (Vec2{1, 4}));
}

void ListingRun::stickVariableStandsForTheStick()
{
    Bench bench("void part(Stick stick)\n{\n    Body end = stick.b;\n    end.position.y += 1;\n}\n" +
                    frameOf("part(sticks[1]);"),
                twoSticks());
    const listing::Trace trace = bench.program->trace(bench.state, bench.binding);
    const auto line = std::find_if(trace.lines.begin(), trace.lines.end(),
                                   [](const listing::TracedLine &traced) { return traced.line == 4; });
    QVERIFY(line != trace.lines.end());
    const std::vector<listing::Variable> &variables = line->variables;
    QCOMPARE(shown(variables, "stick"), std::string("stick = sticks[1]"));
    QCOMPARE(shown(variables, "end"), std::string("end = sticks[1].b"));
    QCOMPARE(listing::typeName(variables.front().value), std::string("Stick"));
    QCOMPARE(std::get<listing::BodyReference>(variables.back().value).point, 2);
    QVERIFY(!bench.run());
    QCOMPARE(bench.state.positionOf(2).y, 5.0);
}

void ListingRun::beforeIsThePositionAtTheStartOfTheFrame()
{
    Bench bench =
        Bench::ofFrame("body.position += Vec2(3, 4);\nbody.velocity = body.position - body.before;\n"
                       "feet[0].velocity = feet[0].before;");
    bench.state.hold = {0, {110, 45}, {7, 8}, {1, 1}};
    QVERIFY(!bench.run());
    QVERIFY(bench.state.velocityOf(3) == (Vec2{3, 4}));
    QVERIFY(bench.state.velocityOf(0) == (Vec2{7, 8})); // held: before the hand moved it
    QVERIFY(!bench.run());
    QVERIFY(bench.state.velocityOf(3) == (Vec2{3, 4}));
}

void ListingRun::directionOfCoincidentPointsHasLengthOne()
{
    Bench bench = Bench::ofFrame("feet[0].velocity = direction(feet[0], Vec2(3, 4));\n"
                                 "feet[1].velocity = direction(feet[1], body);\n"
                                 "feet[2].velocity = direction(body, feet[1]);\n"
                                 "body.velocity = direction(Vec2(1, 1), Vec2(1, 1), body);");
    bench.state.place(1, {100, 50}); // on the body
    QVERIFY(!bench.run());
    QVERIFY(bench.state.velocityOf(0) == (Vec2{0.6, 0.8}));
    const Vec2 there = bench.state.velocityOf(1), back = bench.state.velocityOf(2);
    QVERIFY(std::abs(sim::length(there) - 1) < 1e-15);
    QVERIFY(there == (Vec2{-back.x, -back.y})); // so they part
    QVERIFY(std::abs(sim::length(bench.state.velocityOf(3)) - 1) < 1e-15);
    QVERIFY(there == sim::direction({}, 1, 3).out);
    QVERIFY(bench.state.velocityOf(3) == sim::direction({}, -1, 3).out);
}

void ListingRun::directionOfABranchIsWhereItPoints()
{
    Bench bench(frameOf("for (int i = 0; i < branches.count; i++)\n"
                        "    branches[i].velocity = direction(branches[i]);"),
                swingingBush());
    bench.state.angle = Eigen::Array3d(-90, 0, 30);
    QVERIFY(!bench.run());
    const auto isNear = [](Vec2 a, Vec2 b) { return sim::length(a - b) < 1e-15; };
    QVERIFY(isNear(bench.state.velocityOf(0), {0, -1})); // up
    QVERIFY(isNear(bench.state.velocityOf(1), {1, 0}));
    QVERIFY(isNear(bench.state.velocityOf(2), {std::sqrt(0.75), 0.5}));
}

void ListingRun::newTargetsAreTheTargetsOfThisFrame()
{
    Bench bench = Bench::ofFrame("body.velocity = Vec2();\nfor (int i = 0; i < new_targets.count; i++)\n"
                                 "    body.velocity += (i + 1) * new_targets[i];");
    QVERIFY(!bench.run());
    QVERIFY(bench.state.velocityOf(3) == (Vec2{0, 0}));
    bench.state.input.newTargets = {{1, 2}, {10, 30}};
    QVERIFY(!bench.run());
    QVERIFY(bench.state.velocityOf(3) == (Vec2{21, 62}));
}

void ListingRun::vectorsAndNumbersArePassedByValue()
{
    Bench bench("double change(Vec2 v, double n) { v.x = 77; n = 88; return v.x + n; }\n" +
                frameOf("Vec2 v(1, 2); double n = 3; double sum = change(v, n);\n"
                        "body.position = v; body.velocity = Vec2(n, sum);"));
    QVERIFY(!bench.run());
    QVERIFY(bench.body() == (Vec2{1, 2}));
    QVERIFY(bench.state.velocityOf(3) == (Vec2{3, 165}));
}

void ListingRun::functionThatCallsItselfComputesFactorials()
{
    Bench bench("double factorial(int n) { if (n <= 1) return 1; return n * factorial(n - 1); }\n" +
                frameOf("body.position.x = factorial(10);"));
    QVERIFY(!bench.run());
    QCOMPARE(bench.body().x, 3628800.0);
}

void ListingRun::inputReachesTheProgram()
{
    Bench bench = Bench::ofFrame("body.position = pointer; body.velocity = target;\n"
                                 "feet[0].position = Vec2(keys.left ? 1 : 0, keys.right ? 1 : 0);\n"
                                 "feet[1].position = Vec2(keys.up ? 1 : 0, keys.down ? 1 : 0);\n"
                                 "feet[2].position = Vec2(pointer_down ? 1 : 0, frame_number);");
    bench.state.input.pointer = Vec2{12, 34};
    bench.state.input.pointerDown = true;
    bench.state.input.target = {56, 78};
    bench.state.input.keys = {false, true, true, false};
    bench.state.frame = 41;
    QVERIFY(!bench.run());
    QVERIFY(bench.body() == (Vec2{12, 34}));
    QVERIFY(bench.state.velocityOf(3) == (Vec2{56, 78}));
    QVERIFY(bench.state.positionOf(0) == (Vec2{0, 1}));
    QVERIFY(bench.state.positionOf(1) == (Vec2{1, 0}));
    QVERIFY(bench.state.positionOf(2) == (Vec2{1, 42}));
}

void ListingRun::handAndPointerAreSeparate()
{
    Bench bench = Bench::ofFrame("feet[0].position = hand; feet[1].position = pointer;\n"
                                 "feet[2].position = Vec2(pointer_down ? 1 : 0, pointer_known ? 1 : 0);");
    QVERIFY(!bench.run());
    QVERIFY(bench.state.positionOf(2) == (Vec2{0, 0})); // it has not moved yet
    bench.state.input.pointer = Vec2{12, 34};
    QVERIFY(!bench.run());
    QVERIFY(bench.state.positionOf(0) == (Vec2{12, 34}));
    QVERIFY(bench.state.positionOf(2) == (Vec2{0, 1}));
    bench.state.hold = {3, {56, 78}, {100, 50}, {0, 0}};
    QVERIFY(!bench.run());
    QVERIFY(bench.state.positionOf(0) == (Vec2{56, 78}));
    QVERIFY(bench.state.positionOf(1) == (Vec2{12, 34}));
    QVERIFY(bench.state.positionOf(2) == (Vec2{0, 1})); // a hand that holds a body does not press the button
}

void ListingRun::heldBodyHasItsPositionBeforeTheDrag()
{
    Bench bench =
        Bench::ofFrame("if (body.held) { body.velocity = hand - body.position; body.position = hand; }\n"
                       "if (feet[0].held) body.position.x = 0;");
    // as the input of a frame leaves it: the hand moved the body from (100, 50) to (110, 45)
    bench.state.hold = {3, {110, 45}, {100, 50}, {1, 1}};
    bench.state.place(3, {110, 45});
    bench.state.setVelocity(3, {10, -5});
    QVERIFY(!bench.run());
    QVERIFY(bench.body() == (Vec2{110, 45}));
    QVERIFY(bench.state.velocityOf(3) == (Vec2{10, -5}));
    // a listing that does nothing with a held body leaves it where it was
    Bench idle = Bench::ofFrame("");
    idle.state.hold = {3, {110, 45}, {100, 50}, {1, 1}};
    idle.state.place(3, {110, 45});
    QVERIFY(!idle.run());
    QVERIFY(idle.body() == (Vec2{100, 50}));
    QVERIFY(idle.state.velocityOf(3) == (Vec2{1, 1}));
}

void ListingRun::randomDependsOnSeedFrameAndIndexOnly()
{
    Bench bench = Bench::ofFrame("body.position = Vec2(random(0), random(5)); body.velocity.x = random(0);");
    bench.state.frame = 11;
    QVERIFY(!bench.run());
    QCOMPARE(bench.body().x, sim::uniform(7, 12, 0));
    QCOMPARE(bench.body().y, sim::uniform(7, 12, 5));
    QCOMPARE(bench.state.velocityOf(3).x, bench.body().x);
    QVERIFY(bench.program->dependsOnTime());
    QVERIFY(!Bench::ofFrame("body.position.x = k;").program->dependsOnTime());
    Bench other = Bench::ofFrame("body.position = Vec2(random(5, 12), random(0, 0));"); // of other frames
    QVERIFY(!other.run());
    QCOMPARE(other.body().x, sim::uniform(7, 12, 5));
    QCOMPARE(other.body().y, sim::uniform(7, 0, 0));
}

void ListingRun::handleAndBodyHaveTheirMassAndRadius()
{
    Bench bench = Bench::ofFrame("feet[0].position = Vec2(body.mass, body.radius);\n"
                                 "feet[1].position = Vec2(feet[0].mass, feet[0].radius);");
    bench.scene.start.inverseMass[0] = 0.0;  // a handle
    bench.scene.start.inverseMass[3] = 0.25; // mass 4
    bench.binding = listing::bind(bench.program->vocabulary(), bench.scene);
    QVERIFY(!bench.run());
    QVERIFY(bench.state.positionOf(0) == (Vec2{4, 15}));
    QVERIFY(bench.state.positionOf(1) == (Vec2{0, 5}));
}

SUITE(tst_listing_run, ListingRun)
#include "tst_listing_run.moc"

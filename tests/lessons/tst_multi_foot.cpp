#include "sim/scene/scene.h"
#include "tests/lessons/support/published_files.h"
#include "tests/lessons/support/support.h"
#include "tests/lessons/support/tutorial_match.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <set>

using namespace support;

class MultiFoot : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("multi_foot"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    sim::Scene grownScene(double feet, std::uint64_t seed) const
    {
        sim::Values values = step("grown_feet").defaultValues();
        values.set("feet", feet);
        values.seed = seed;
        return step("grown_feet").scene(values);
    }

private slots:
    void publishedTrajectories_data() { addPublishedRows(QStringLiteral("multi_foot")); }
    void publishedTrajectories() { checkPublished(m_lesson); }
    void matchesTutorialCode_data();
    void matchesTutorialCode();
    void simultaneousMoveKeepsMomentumWithAnyNumberOfFeet_data();
    void simultaneousMoveKeepsMomentumWithAnyNumberOfFeet();
    void methodsConvergeWithOrderOne_data();
    void methodsConvergeWithOrderOne();
    void fiveFeetRestOneRadiusFromTheBody();
    void damping085KeepsTheCreatureOnStageAnd09DoesNot();
    void sixtyPublishedFeetNeedHalfFrameSteps();
    void grownFeetStartWithin50PxAndDependOnlyOnTheSeed();
    void singleFootIsNumbered();
    void feetAfterTheFifthStartOnACircle();
};

void MultiFoot::matchesTutorialCode_data()
{
    QTest::addColumn<Match>("match");
    std::mt19937 random(3);
    const auto tutorial = [&](int feet) { return randomTutorial(Tutorial::Kind::mutual, feet, random); };
    for (int run = 0; run < 10; ++run)
        QTest::addRow("two_feet, random drags %d", run) << Match{"two_feet", tutorial(2)};
    for (int feet = 1; feet <= 16; ++feet) {
        for (const char *id : {"any_number", "grown_feet"})
            QTest::addRow("%s, %d feet, random drags", id, feet) << Match{id, tutorial(feet)};
    }
}

void MultiFoot::matchesTutorialCode()
{
    QFETCH(Match, match);
    QVERIFY(largestDifference(step(match.step), match.tutorial, 200) <= 1e-9);
}

void MultiFoot::simultaneousMoveKeepsMomentumWithAnyNumberOfFeet_data()
{
    QTest::addColumn<int>("feet");
    for (int feet : {1, 2, 5, 12})
        QTest::addRow("%d feet", feet) << feet;
}

void MultiFoot::simultaneousMoveKeepsMomentumWithAnyNumberOfFeet()
{
    QFETCH(int, feet);
    sim::Script script =
        scriptOf(step("grown_feet"), "semi_implicit_euler", 0.5, {{"damp", 1.0}, {"feet", double(feet)}});
    script.bodies["body"] = {{270, 200}, sim::Vec2{6, -3}};
    const sim::State state = stateAfter(script, 500);
    const sim::Vec2 momentum = {state.velocity.col(0).sum(), state.velocity.col(1).sum()};
    QVERIFY(sim::length(momentum - sim::Vec2{6, -3}) < 1e-9);
}

void MultiFoot::methodsConvergeWithOrderOne_data()
{
    QTest::addColumn<QString>("id");
    for (const char *id : {"two_feet", "any_number"})
        QTest::newRow(id) << id;
}

void MultiFoot::methodsConvergeWithOrderOne()
{
    QFETCH(QString, id);
    const OrderRange order = observedOrders(
        [&](double h) {
            const lessons::Step &step = m_lesson.step(id);
            return largestDistance(stateAfter(scriptOf(step, "published", h), 20),
                                   stateAfter(scriptOf(step, "semi_implicit_euler", h), 20));
        },
        4, 9);
    QVERIFY(order.min > 0.9 && order.max < 1.1);
}

void MultiFoot::fiveFeetRestOneRadiusFromTheBody()
{
    const sim::State rest = stateAfter(step("any_number").script(), 3000);
    for (int foot = 0; foot < 5; ++foot)
        QVERIFY(std::abs(sim::length(rest.positionOf(foot) - rest.positionOf(5)) - 50.0) < 1e-9);
}

void MultiFoot::damping085KeepsTheCreatureOnStageAnd09DoesNot()
{
    const auto bodyAfter1000Frames = [&](double damp) {
        return stateAfter(scriptOf(step("two_feet"), "published", 1.0, {{"damp", damp}}), 1000).positionOf(2);
    };
    QVERIFY(sim::length(bodyAfter1000Frames(0.85) - sim::Vec2{270, 200}) < 10.0);
    QVERIFY(sim::length(bodyAfter1000Frames(0.9) - sim::Vec2{270, 200}) > 1000.0);
}

void MultiFoot::sixtyPublishedFeetNeedHalfFrameSteps()
{
    sim::Track fullSteps(scriptOf(step("grown_feet"), "published", 1.0, {{"feet", 60.0}}), 0);
    fullSteps.seek({400, 0});
    QVERIFY(fullSteps.stop() || fullSteps.state().position.abs().maxCoeff() > 1e20);
    const sim::State halfSteps =
        stateAfter(scriptOf(step("grown_feet"), "published", 0.5, {{"feet", 60.0}}), 400);
    QVERIFY(halfSteps.velocity.abs().maxCoeff() < 1e-6);
    QVERIFY(sim::length(halfSteps.positionOf(60) - sim::Vec2{270, 200}) < 50.0);
}

void MultiFoot::grownFeetStartWithin50PxAndDependOnlyOnTheSeed()
{
    const sim::State hundred = grownScene(100, 1).start;
    QCOMPARE(hundred.pointCount(), 101);
    QVERIFY(((hundred.position.col(0) - 270.0).abs() <= 50.0).all());
    QVERIFY(((hundred.position.col(1) - 200.0).abs() <= 50.0).all());
    QVERIFY(sim::sameBits(hundred, grownScene(100, 1).start));
    QVERIFY(!sim::sameBits(hundred, grownScene(100, 2).start));
    std::set<std::pair<double, double>> positions;
    for (int foot = 0; foot < 100; ++foot)
        positions.insert({hundred.positionOf(foot).x, hundred.positionOf(foot).y});
    QCOMPARE(positions.size(), std::size_t{100});
}

void MultiFoot::singleFootIsNumbered()
{
    QCOMPARE(grownScene(1, 1).names, (std::vector<std::string>{"foot0", "body"}));
}

void MultiFoot::feetAfterTheFifthStartOnACircle()
{
    sim::Values values = step("any_number").defaultValues();
    values.set("feet", 9.0);
    const sim::State start = step("any_number").scene(values).start;
    QCOMPARE(start.positionOf(4), (sim::Vec2{310, 180}));
    for (int foot = 5; foot < 9; ++foot)
        QVERIFY(std::abs(sim::length(start.positionOf(foot) - start.positionOf(9)) - 60.0) < 1e-9);
}

SUITE(tst_multi_foot, MultiFoot)
#include "tst_multi_foot.moc"

#include "lessons/api/view/view.h"
#include "sim/pipeline/pipeline.h"
#include "sim/run/script/script.h"
#include "sim/scene/scene.h"
#include "tests/lessons/support/published_files.h"
#include "tests/lessons/support/support.h"
#include "tests/lessons/support/tutorial_match.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>

using namespace support;

class GravityWalls : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("gravity_walls"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    /// Returns step `walls` with one foot and no spring. Bodies move in straight lines between bounces.
    sim::Script freeBodies(double bounce) const
    {
        return scriptOf(step("walls"), "published", 1.0,
                        {{"k", 0.0}, {"damp", 1.0}, {"bounce", bounce}, {"feet", 1.0}});
    }

    /// Returns step `gravity` with the body held at (270, 100).
    sim::Script heldUp(const Changes &changes) const
    {
        sim::Script script = scriptOf(step("gravity"), "published", 1.0, changes);
        script.input = {{1, sim::Grab{"body"}}, {1, sim::Move{{270, 100}}}};
        return script;
    }

private slots:
    void publishedTrajectories_data() { addPublishedRows(QStringLiteral("gravity_walls")); }
    void publishedTrajectories() { checkPublished(m_lesson); }
    void matchesTutorialCode_data();
    void matchesTutorialCode();
    void edgeStopsAtTheWallAndVelocityReverses_data();
    void edgeStopsAtTheWallAndVelocityReverses();
    void thereIsNoCeiling();
    void heldBodyIgnoresWalls();
    void hangingFeetBalanceSpringAndGravityAtAnyDamping_data();
    void hangingFeetBalanceSpringAndGravityAtAnyDamping();
    void springsOfAStandingCreatureBalanceGravity();
    void creatureSettlesOnTheFloorAtAnyGravity_data();
    void creatureSettlesOnTheFloorAtAnyGravity();
    void velocityOnTheFloorIsNotZero();
    void methodsConvergeWithOrderOneInTheAir();
    void noGravityPhaseWithoutGravity();
    void viewShowsTheRoom();
};

void GravityWalls::matchesTutorialCode_data()
{
    QTest::addColumn<Match>("match");
    std::mt19937 random(4);
    for (int feet = 1; feet <= 12; ++feet) {
        for (const char *id : {"walls", "gravity"}) {
            Tutorial tutorial = randomTutorial(Tutorial::Kind::mutual, feet, random);
            tutorial.hasWalls = true;
            tutorial.left = 80.0;
            tutorial.right = 460.0;
            tutorial.floor = 300.0;
            tutorial.bounce = feet % 2 ? 1.0 : 0.6;
            tutorial.gravity = id == std::string("gravity") ? 0.1 * feet : 0.0;
            QTest::addRow("%s, %d feet, random drags", id, feet) << Match{id, tutorial};
        }
    }
}

void GravityWalls::matchesTutorialCode()
{
    QFETCH(Match, match);
    QVERIFY(largestDifference(step(match.step), match.tutorial, 200) <= 1e-9);
}

void GravityWalls::edgeStopsAtTheWallAndVelocityReverses_data()
{
    QTest::addColumn<QString>("body");
    QTest::addColumn<double>("bounce");
    QTest::newRow("body, bounce 1") << "body" << 1.0;
    QTest::newRow("body, bounce 0.5") << "body" << 0.5;
    QTest::newRow("foot, bounce 1") << "foot0" << 1.0;
    QTest::newRow("foot, bounce 0") << "foot0" << 0.0;
}

void GravityWalls::edgeStopsAtTheWallAndVelocityReverses()
{
    QFETCH(QString, body);
    QFETCH(double, bounce);
    const double half = body == u"body" ? 15.0 : 5.0;
    const int point = body == u"body" ? 1 : 0;
    const auto after = [&](sim::Vec2 x, sim::Vec2 v) {
        sim::Script script = freeBodies(bounce);
        script.bodies[body.toStdString()] = {x, v};
        const sim::State state = stateAfter(script, 1);
        return std::pair{state.positionOf(point), state.velocityOf(point)};
    };
    const auto right = after({520.0 - half - 3.0, 200}, {7, 1});
    QCOMPARE(right.first, (sim::Vec2{520.0 - half, 201}));
    QCOMPARE(right.second, (sim::Vec2{-7 * bounce, 1}));
    const auto left = after({20.0 + half + 3.0, 200}, {-7, 1});
    QCOMPARE(left.first, (sim::Vec2{20.0 + half, 201}));
    QCOMPARE(left.second, (sim::Vec2{7 * bounce, 1}));
    const auto floor = after({300, 380.0 - half - 3.0}, {1, 7});
    QCOMPARE(floor.first, (sim::Vec2{301, 380.0 - half}));
    QCOMPARE(floor.second, (sim::Vec2{1, -7 * bounce}));
    const auto touching = after({520.0 - half - 7.0, 200}, {7, 1});
    QCOMPARE(touching.second, (sim::Vec2{7, 1}));
}

void GravityWalls::thereIsNoCeiling()
{
    sim::Script script = freeBodies(1.0);
    script.bodies["body"] = {{270, 200}, sim::Vec2{0, -10}};
    QCOMPARE(stateAfter(script, 100).positionOf(1), (sim::Vec2{270, -800}));
}

void GravityWalls::heldBodyIgnoresWalls()
{
    sim::Script script = step("gravity").script();
    script.input = {{1, sim::Grab{"body"}}, {1, sim::Move{{600, 450}}}};
    QCOMPARE(stateAfter(script, 50).positionOf(4), (sim::Vec2{600, 450}));
}

void GravityWalls::hangingFeetBalanceSpringAndGravityAtAnyDamping_data()
{
    QTest::addColumn<double>("k");
    QTest::addColumn<double>("gravity");
    QTest::addColumn<double>("damp");
    QTest::newRow("as published: 52.5 px") << 0.2 << 0.5 << 0.85;
    QTest::newRow("less damping") << 0.2 << 0.5 << 0.95;
    QTest::newRow("more damping") << 0.2 << 0.5 << 0.4;
    QTest::newRow("more gravity") << 0.2 << 3.0 << 0.85;
    QTest::newRow("softer") << 0.05 << 0.5 << 0.85;
}

void GravityWalls::hangingFeetBalanceSpringAndGravityAtAnyDamping()
{
    QFETCH(double, k);
    QFETCH(double, gravity);
    QFETCH(double, damp);
    const sim::State rest = stateAfter(heldUp({{"k", k}, {"gravity", gravity}, {"damp", damp}}), 3000);
    for (int foot = 0; foot < 4; ++foot)
        QVERIFY(sim::length(rest.positionOf(foot) - sim::Vec2{270.0, 100.0 + 50.0 + gravity / k}) < 1e-6);
}

void GravityWalls::springsOfAStandingCreatureBalanceGravity()
{
    sim::Script script = scriptOf(step("gravity"), "published", 1.0, {{"left", 240.0}, {"right", 300.0}});
    script.bodies = {{"foot0", {{250, 330}, {}}},
                     {"foot1", {{290, 330}, {}}},
                     {"foot2", {{250, 340}, {}}},
                     {"foot3", {{290, 340}, {}}},
                     {"body", {{270, 290}, {}}}};
    const sim::State rest = stateAfter(script, 3000);
    QVERIFY(rest.position(4, 1) < 350.0);
    sim::Vec2 pull;
    for (int foot = 0; foot < 4; ++foot) {
        const sim::Vec2 toFoot = rest.positionOf(foot) - rest.positionOf(4);
        const double distance = sim::length(toFoot);
        pull = pull + (0.2 * (distance - 50.0) / distance) * toFoot;
    }
    QVERIFY(sim::length(pull - sim::Vec2{0.0, -0.5}) < 1e-9);
}

void GravityWalls::creatureSettlesOnTheFloorAtAnyGravity_data()
{
    QTest::addColumn<double>("gravity");
    for (double gravity : {0.05, 0.5, 3.0})
        QTest::addRow("gravity %g", gravity) << gravity;
}

void GravityWalls::creatureSettlesOnTheFloorAtAnyGravity()
{
    QFETCH(double, gravity);
    const sim::State rest =
        stateAfter(scriptOf(step("gravity"), "published", 1.0, {{"gravity", gravity}}), 3000);
    QVERIFY(std::abs(rest.position(4, 1) - (380.0 - 15.0)) < 1e-9);
    for (int foot = 0; foot < 4; ++foot)
        QVERIFY(std::abs(rest.position(foot, 1) - (380.0 - 5.0)) < 1e-9);
}

/// With bounce 1, each frame changes v to -(v + g) damp. So v converges to -g damp / (1 + damp).
void GravityWalls::velocityOnTheFloorIsNotZero()
{
    const sim::State rest = stateAfter(scriptOf(step("gravity"), "published", 1.0, {{"k", 0.0}}), 3000);
    for (int point = 0; point < rest.pointCount(); ++point)
        QVERIFY(std::abs(rest.velocity(point, 1) + 0.5 * 0.85 / 1.85) < 1e-9);
}

void GravityWalls::methodsConvergeWithOrderOneInTheAir()
{
    const OrderRange order = observedOrders(
        [&](double h) {
            return largestDistance(stateAfter(scriptOf(step("gravity"), "published", h), 12),
                                   stateAfter(scriptOf(step("gravity"), "semi_implicit_euler", h), 12));
        },
        4, 9);
    QVERIFY(order.min > 0.9 && order.max < 1.1);
}

void GravityWalls::noGravityPhaseWithoutGravity()
{
    for (const auto &[id, wanted] : {std::pair{"walls", 0}, std::pair{"gravity", 2}}) {
        const sim::Script script = step(id).script();
        const sim::Pipeline pipeline =
            sim::compose(sim::sceneOf(script, script.values), *script.method, script.step);
        const auto phases = std::count_if(pipeline.phases.begin(), pipeline.phases.end(),
                                          [](const sim::Phase &phase) { return phase.id == "gravity"; });
        QCOMPARE(static_cast<int>(phases), wanted);
    }
}

void GravityWalls::viewShowsTheRoom()
{
    sim::Values values = step("walls").defaultValues();
    values.set("left", 33.0);
    const lessons::View view = step("walls").view(step("walls").scene(values), values);
    QVERIFY(view.room);
    QCOMPARE(view.room->left, 33.0);
    QCOMPARE(view.room->right, 520.0);
    QCOMPARE(view.room->floor, 380.0);
}

SUITE(tst_gravity_walls, GravityWalls)
#include "tst_gravity_walls.moc"

#include "lessons/api/creature.h"
#include "lessons/api/view/view.h"
#include "sim/analysis/accuracy/study.h"
#include "sim/analysis/stability/stability.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/scenes/creatures.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>

using namespace support;

/// The step `crowd`, with up to thousands of creatures.
class Crowd : public QObject
{
    Q_OBJECT

    static constexpr int feet = 5;

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("accuracy"));
    const lessons::Step &step() const { return m_lesson.step(QStringLiteral("crowd")); }

    sim::Script crowdOf(int count, const std::string &method = "semi_implicit_euler", double h = 1.0,
                        double bounce = 1.0) const
    {
        return scriptOf(step(), method, h, {{"creatures", count}, {"bounce", bounce}});
    }

    sim::Scene sceneOf(int count) const
    {
        const sim::Script script = crowdOf(count);
        return script.build(script.values);
    }

    /// Returns a scene with one creature of a crowd alone in the same room. It is set up as in the other
    /// lessons: feet, then body.
    static sim::Scene alone(const sim::Scene &crowd, int creature, const sim::Room &room,
                            const sim::Values &values)
    {
        sim::Scene scene = scenes::springCreature(feet, values["k"], values["radius"]);
        for (int i = 0; i < feet; ++i) {
            const std::string foot = QString("creature%1.foot%2").arg(creature).arg(i).toStdString();
            scene.start.place(i, crowd.start.positionOf(crowd.find(foot)));
        }
        const std::string body = QString("creature%1.body").arg(creature).toStdString();
        scene.start.place(feet, crowd.start.positionOf(crowd.find(body)));
        scenes::add<sim::Gravity>(scene, values["gravity"]);
        scenes::add<sim::Damping>(scene, values["damp"]);
        scenes::add<sim::Walls>(scene, room, scenes::halfWidths(scene));
        return scene;
    }

private slots:
    void creaturesMoveAsTheyDoAlone_data();
    void creaturesMoveAsTheyDoAlone();
    void equalPartsAreContiguous();
    void workIsProportionalToCreatures();
    void creaturesStartWithDifferentPositionsAndShapes();
    void roomGrowsWithTheCrowd();
    void addedCreatureDoesNotDisturbOthers();
    void analysesOfTooManyPointsAreRejected();
    void numbersOfTheTextHold();
};

void Crowd::creaturesMoveAsTheyDoAlone_data()
{
    QTest::addColumn<QString>("method");
    QTest::addColumn<double>("h");
    QTest::newRow("semi-implicit Euler") << "semi_implicit_euler" << 1.0;
    QTest::newRow("published") << "published" << 1.0;
    QTest::newRow("Runge-Kutta 4, half steps") << "rk4" << 0.5;
}

/// Compares all bits, including the fall to the floor and the bounce.
void Crowd::creaturesMoveAsTheyDoAlone()
{
    QFETCH(QString, method);
    QFETCH(double, h);
    constexpr int count = 7;
    constexpr int frames = 300;
    const sim::Script script = crowdOf(count, method.toStdString(), h, 0.8);
    const sim::Scene crowd = script.build(script.values);
    const auto view = step().view(crowd, script.values);
    sim::Room room = view.room.value();
    room.bounce = 0.8;
    const sim::State end = stateAfter(script, frames);
    for (int creature = 0; creature < count; ++creature) {
        sim::Script singleScript = script;
        singleScript.build = [&](const sim::Values &values) { return alone(crowd, creature, room, values); };
        const sim::State single = stateAfter(singleScript, frames);
        QVERIFY(single.positionOf(feet).y > 340.0); // it has reached the floor
        const auto positionInCrowd = [&](const QString &part) {
            return end.positionOf(crowd.find(QString("creature%1.%2").arg(creature).arg(part).toStdString()));
        };
        QVERIFY(positionInCrowd("body") == single.positionOf(feet));
        for (int i = 0; i < feet; ++i)
            QVERIFY(positionInCrowd(QString("foot%1").arg(i)) == single.positionOf(i));
    }
}

void Crowd::equalPartsAreContiguous()
{
    constexpr int count = 4;
    const sim::Scene scene = sceneOf(count);
    QCOMPARE(scene.start.pointCount(), count * (feet + 1));
    for (int creature = 0; creature < count; ++creature) {
        const std::string name = "creature" + std::to_string(creature);
        QCOMPARE(scene.find(name + ".body"), creature);
        for (int i = 0; i < feet; ++i)
            QCOMPARE(scene.find(name + ".foot" + std::to_string(i)), (i + 1) * count + creature);
    }
    QCOMPARE(scene.groups.size(), std::size_t(2)); // feet, then bodies
    QCOMPARE(scene.groups[0].points.first, count);
    QCOMPARE(scene.groups[0].points.end(), scene.start.pointCount());
    QCOMPARE(scene.groups[1].points.first, 0);
    QCOMPARE(scene.groups[1].points.end(), count);
}

void Crowd::workIsProportionalToCreatures()
{
    for (const int count : {1, 10, 100, 1000}) {
        const sim::Scene scene = sceneOf(count);
        QCOMPARE(scene.effects.size(), std::size_t(4));
        const auto work = [&](std::size_t effect) {
            return scene.effects[effect]->count(scene.start, {0, scene.start.pointCount()});
        };
        QCOMPARE(scene.effects[0]->id(), std::string("radial_spring"));
        QCOMPARE(work(0), 10 * count);
        for (const std::size_t effect : {1u, 2u, 3u})
            QCOMPARE(work(effect), 6 * count);
    }
}

void Crowd::creaturesStartWithDifferentPositionsAndShapes()
{
    constexpr int count = 100;
    const sim::Scene scene = sceneOf(count);
    for (int i = 1; i < count; ++i) {
        QVERIFY(sim::length(scene.start.positionOf(i) - scene.start.positionOf(i - 1)) > 0.0);
        const auto shape = [&](int creature) {
            return scene.start.positionOf(count + creature) - scene.start.positionOf(creature);
        };
        QVERIFY(sim::length(shape(i) - shape(i - 1)) > 0.0);
    }
    sim::Values values = crowdOf(count).values;
    values.seed = 2;
    QVERIFY((step().scene(values).start.position != scene.start.position).all());
}

void Crowd::roomGrowsWithTheCrowd()
{
    const auto widthPerRootOf = [&](int count) {
        const sim::Scene scene = sceneOf(count);
        const lessons::View view = step().view(scene, crowdOf(count).values);
        for (int i = 0; i < scene.start.pointCount(); ++i) {
            const sim::Vec2 position = scene.start.positionOf(i);
            if (!view.stage.contains(position.x, position.y) || position.x < view.room->left ||
                position.x > view.room->right || position.y > view.room->floor)
                return 0.0;
        }
        QTest::qCompare(view.room->floor, 380.0, "floor", "380", __FILE__, __LINE__);
        return (view.room->right - view.room->left) / std::sqrt(double(count));
    };
    const double expected = widthPerRootOf(20);
    QVERIFY(expected > 100.0);
    for (const int count : {100, 1000, 20'000})
        QVERIFY2(std::abs(widthPerRootOf(count) / expected - 1.0) < 1e-12,
                 qPrintable(QString::number(count)));
    QVERIFY(widthPerRootOf(1) >= 500.0);
}

void Crowd::addedCreatureDoesNotDisturbOthers()
{
    sim::Script script = crowdOf(3);
    const sim::State before = stateAfter(script, 40);
    script.input = {{21, sim::Set{"creatures", 5.0}}};
    const sim::State after = stateAfter(script, 40);
    QCOMPARE(after.pointCount(), 30);
    for (int i = 0; i < 3; ++i)
        QVERIFY(before.positionOf(i) == after.positionOf(i));
}

void Crowd::analysesOfTooManyPointsAreRejected()
{
    const auto boundOf = [&](int count) {
        const sim::Script script = crowdOf(count);
        const sim::Scene scene = script.build(script.values);
        return sim::stabilityOf(scene, scene.start, *script.method, script.step.h).bound;
    };
    QVERIFY(boundOf(2) == sim::Bound::stiffness);
    QVERIFY(boundOf(sim::maxAnalysedPoints / 6 + 1) == sim::Bound::tooLarge);
    try {
        sim::studyAccuracy(crowdOf(sim::maxStudiedPoints / 6 + 1), {},
                           [](const sim::Accuracy &, double) { return false; });
        QFAIL("studyAccuracy did not throw");
    } catch (const sim::Error &error) {
        QCOMPARE(error.id(), std::string("too-many-points"));
    }
}

void Crowd::numbersOfTheTextHold()
{
    const QString text = QString(step().narration).replace(QChar(0x202f), ' ');
    QVERIFY(text.contains("6 points, and 10 pulls in every step"));
    QVERIFY(text.contains("At 30 frames a second there are 33 ms"));
    QCOMPARE(std::lround(1000.0 / 30.0), 33l);
}

SUITE(tst_crowd, Crowd)
#include "tst_crowd.moc"

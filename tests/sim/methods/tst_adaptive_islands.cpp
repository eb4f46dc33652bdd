// Adaptive methods choose steps for each island separately. So a creature moves the same alone and in a
// crowd.

#include "sim/pipeline/pipeline.h"
#include "tests/sim/support/energy_support.h"
#include "tests/sim/support/support.h"

#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <cstring>
#include <deque>

using namespace sim;
using energy_support::balanceOf;
using std::make_shared;

namespace {

constexpr int pointsPerCreature = 3;
constexpr int crowdFrames = 150; ///< enough to fall, bounce and come to rest

/// A creature with two feet and its number in the crowd.
struct Creature
{
    int number;
    Vec2 at;       ///< px, start position of the body
    Vec2 velocity; ///< px/frame
};

const std::vector<Creature> crowd = {
    {0, {100.0, 250.0}, {3.0, -2.0}}, {1, {700.0, 90.0}, {0.0, 0.0}}, {2, {400.0, 340.0}, {-6.0, 1.0}}};

/// Returns creatures in a room whose walls have restitution `bounce`. Points are stored part by part, so the
/// points of a creature are not neighbours.
Scene creaturesInRoom(const std::vector<Creature> &creatures, double bounce)
{
    const int count = static_cast<int>(creatures.size());
    Scene scene = scenes::crowdByParts(count, pointsPerCreature - 1);
    for (int part = 0; part < pointsPerCreature; ++part) {
        for (int i = 0; i < count; ++i) {
            const Creature &creature = creatures[static_cast<std::size_t>(i)];
            const int point = part * count + i;
            scene.start.place(point, creature.at + part * Vec2{31.0, 17.0 * creature.number - 12.0});
            scene.start.setVelocity(point, creature.velocity);
            scene.start.inverseMass[point] = 1.0 / (1.0 + part);
            scene.names[static_cast<std::size_t>(point)] =
                (part == 0 ? "body" : "foot" + std::to_string(part)) + std::to_string(creature.number);
        }
    }
    scene.groups = {{"all", {0, pointsPerCreature * count}}};
    scene.effects = {make_shared<RadialSpring>(scenes::legsByParts(count, pointsPerCreature - 1), 0.2, 50.0),
                     make_shared<Gravity>(0.5), make_shared<Damping>(0.97),
                     make_shared<Walls>(Room{0.0, 1000.0, 380.0, bounce},
                                        Eigen::ArrayXd::Constant(pointsPerCreature * count, 5.0))};
    return scene;
}

Script scriptOf(const Scene &scene, const QString &method)
{
    Script script = support::script(scene, method.toStdString());
    script.step = StepSize::withTolerance(1e-6);
    return script;
}

bool sameNumber(double a, double b)
{
    return std::memcmp(&a, &b, sizeof a) == 0;
}

/// Returns whether point `inA` of `a` has the same bits as point `inB` of `b`.
bool samePoint(const State &a, int inA, const State &b, int inB)
{
    bool same = a.restingContacts[inA] == b.restingContacts[inB];
    for (int axis = 0; axis < 2; ++axis)
        same = same && sameNumber(a.position(inA, axis), b.position(inB, axis)) &&
               sameNumber(a.velocity(inA, axis), b.velocity(inB, axis));
    return same;
}

/// Returns points on springs of stiffness `k[i]` to fixed positions, 1000 px apart.
Scene separateSprings(const std::vector<double> &k)
{
    Scene scene = scenes::pointsAt(std::vector<Vec2>(k.size()));
    for (int i = 0; i < scene.start.pointCount(); ++i) {
        const Vec2 centre = {1000.0 * i, 0.0};
        scene.start.place(i, centre + Vec2{100.0, -40.0});
        scenes::add<PointSpring>(scene, i, centre, k[static_cast<std::size_t>(i)]);
    }
    return scene;
}

}

class TestAdaptiveIslands : public QObject
{
    Q_OBJECT

private:
    static void addMethodRows()
    {
        QTest::addColumn<QString>("method");
        for (const char *method : {"dormand_prince", "rkn86", "dop853"})
            QTest::newRow(method) << method;
    }

private slots:
    void creatureMovesAloneAsInACrowd_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("bounce");
        for (const QString method : {"dormand_prince", "rkn86", "dop853"}) {
            for (const double bounce : {1.0, 0.4, 0.0})
                QTest::addRow("%s, bounce %g", qPrintable(method), bounce) << method << bounce;
        }
    }
    void creatureMovesAloneAsInACrowd()
    {
        QFETCH(QString, method);
        QFETCH(double, bounce);
        const int count = static_cast<int>(crowd.size());
        Track together(scriptOf(creaturesInRoom(crowd, bounce), method), 0);
        std::deque<Track> alone;
        for (const Creature &creature : crowd)
            alone.emplace_back(scriptOf(creaturesInRoom({creature}, bounce), method), 0);
        std::int64_t evaluations = 0;
        int rests = 0;
        for (int frame = 1; frame <= crowdFrames; ++frame) {
            together.seek({frame, 0});
            QVERIFY(!together.stop());
            evaluations = 0;
            for (int i = 0; i < count; ++i) {
                Track &track = alone[static_cast<std::size_t>(i)];
                track.seek({frame, 0});
                evaluations += track.state().pointEvaluations;
                for (int part = 0; part < pointsPerCreature; ++part) {
                    QVERIFY2(
                        samePoint(together.state(), part * count + i, track.state(), part),
                        qPrintable(QString("creature %1, part %2, frame %3").arg(i).arg(part).arg(frame)));
                    rests += track.state().restingContacts[part] != 0;
                }
                QVERIFY(together.state().adaptiveSteps[static_cast<std::size_t>(i)] ==
                        track.state().adaptiveSteps.front());
            }
            QCOMPARE(together.state().pointEvaluations, evaluations);
        }
        QVERIFY(evaluations > 0);
        QVERIFY(bounce > 0.5 || rests > 0);
    }

    void workIsProportionalToTheNumberOfCreatures_data() { addMethodRows(); }
    void workIsProportionalToTheNumberOfCreatures()
    {
        QFETCH(QString, method);
        const auto workOf = [&](int count) {
            std::vector<Creature> creatures;
            for (int i = 0; i < count; ++i)
                creatures.push_back({1, crowd[1].at, crowd[1].velocity});
            Track track(scriptOf(creaturesInRoom(creatures, 0.7), method), 0);
            track.seek({60, 0});
            return track.state().pointEvaluations;
        };
        const std::int64_t workOfOne = workOf(1);
        QVERIFY(workOfOne > 60 * pointsPerCreature);
        for (const int count : {2, 7, 30})
            QCOMPARE(workOf(count), count * workOfOne);
    }

    /// A drag discards the steps that other islands have computed ahead. Their motion stays the same within
    /// the tolerance.
    void draggingOneCreatureLeavesTheOthersUnchanged_data() { addMethodRows(); }
    void draggingOneCreatureLeavesTheOthersUnchanged()
    {
        QFETCH(QString, method);
        const Scene scene = creaturesInRoom(crowd, 0.0);
        Script script = scriptOf(scene, method);
        Track free(script, 0);
        script.input = {{10, Grab{"foot11"}}, {10, Move{{650.0, 60.0}}}, {25, Release{}}};
        Track held(script, 0);
        bool moved = false;
        for (int frame = 1; frame <= 40; ++frame) {
            free.seek({frame, 0});
            held.seek({frame, 0});
            for (int point = 0; point < held.state().pointCount(); ++point) {
                const double difference =
                    length(held.state().positionOf(point) - free.state().positionOf(point));
                const bool isOfHeld = scene.names[static_cast<std::size_t>(point)].back() == '1';
                moved = moved || (isOfHeld && difference > 1.0);
                QVERIFY2(
                    isOfHeld || difference < 1e-3,
                    qPrintable(QString("point %1, frame %2: %3 px").arg(point).arg(frame).arg(difference)));
            }
            if (frame >= 10 && frame < 25)
                QVERIFY(held.state().positionOf(scene.find("foot11")) == (Vec2{650.0, 60.0}));
        }
        QVERIFY(moved);
    }

    void seekingBackGivesTheSameBits_data() { addMethodRows(); }
    void seekingBackGivesTheSameBits()
    {
        QFETCH(QString, method);
        Script script = scriptOf(creaturesInRoom(crowd, 0.4), method);
        script.input = {{10, Grab{"body2"}}, {11, Move{{450.0, 300.0}}}, {14, Release{}}};
        const std::string found = support::seekMismatch(script, 1 << 16, 60, 40, 5);
        QVERIFY2(found.empty(), found.c_str());
    }

    void sleepingChangesNoState_data() { addMethodRows(); }
    void sleepingChangesNoState()
    {
        QFETCH(QString, method);
        Script script = scriptOf(creaturesInRoom(crowd, 0.0), method);
        script.step = StepSize::withTolerance(0.1);
        script.input = {{3000, Grab{"body1"}}, {3001, Move{{500.0, 100.0}}}, {3004, Release{}}};
        Track track(script, Timeline::defaultBudget);
        track.seek({2990, 0});
        Track reference(script, 0, Sleeping::never);
        for (const int frame : {2990, 2995, 3010, 3050}) {
            track.seek({frame, 0});
            reference.seek({frame, 0});
            const std::string found = support::difference(track.state(), reference.state());
            QVERIFY2(found.empty(), found.c_str());
            QCOMPARE(track.state().pointEvaluations, reference.state().pointEvaluations);
            // The drag has lifted it off the floor.
            QVERIFY(frame != 3010 || track.state().positionOf(1).y < 350.0);
        }
    }

    void ledgerOfACrowdIsTheSumOfItsCreatures_data() { addMethodRows(); }
    void ledgerOfACrowdIsTheSumOfItsCreatures()
    {
        QFETCH(QString, method);
        constexpr int counted = 60;
        const Balance all = balanceOf(scriptOf(creaturesInRoom(crowd, 0.7), method), counted);
        Balance sum;
        for (const Creature &creature : crowd) {
            const Balance alone = balanceOf(scriptOf(creaturesInRoom({creature}, 0.7), method), counted);
            for (const AccountName &name : accountNames()) {
                sum.energy[name.account] += alone.energy[name.account];
                sum.momentum[name.account] = sum.momentum[name.account] + alone.momentum[name.account];
            }
        }
        const double scale = std::abs(all.energy[Account::impact]);
        QVERIFY(scale > 100.0);
        for (const AccountName &name : accountNames()) {
            const double difference = all.energy[name.account] - sum.energy[name.account];
            QVERIFY2(std::abs(difference) < 1e-9 * scale, name.id.c_str());
            QVERIFY2(length(all.momentum[name.account] - sum.momentum[name.account]) < 1e-9 * scale,
                     name.id.c_str());
        }
        // The drift is only the method's error. No jump of one creature is counted for another.
        QVERIFY2(std::abs(all.energy[Account::drift]) < 1e-5 * scale,
                 qPrintable(QString::number(all.energy[Account::drift])));
    }

    void stopNamesThePointThatNeedsTooManySteps_data() { addMethodRows(); }
    void stopNamesThePointThatNeedsTooManySteps()
    {
        QFETCH(QString, method);
        // The third spring oscillates 600 times per frame.
        Script script = scriptOf(separateSprings({0.2, 0.3, 1.6e7, 0.2}), method);
        script.step = StepSize::withTolerance(1e-13);
        Track track(script, 0);
        track.seek({5, 0});
        QVERIFY(track.stop());
        QVERIFY(track.stop()->reason == StopReason::tooManySteps);
        QCOMPARE(track.stop()->body, std::string("p2"));
        QVERIFY(sameBits(track.state(), Track(script, 0).state())); // unchanged
    }

    void stiffIslandDoesNotShortenTheStepsOfOthers_data() { addMethodRows(); }
    void stiffIslandDoesNotShortenTheStepsOfOthers()
    {
        QFETCH(QString, method);
        Track track(scriptOf(separateSprings({0.01, 50.0}), method), 0);
        track.seek({40, 0});
        const std::vector<AdaptiveStep> &lastStep = track.state().adaptiveSteps;
        QCOMPARE(lastStep.size(), std::size_t{2});
        // Steps are proportional to the period, so their ratio is the root of the stiffness ratio, about 70.
        const double ratio = lastStep[0].length / lastStep[1].length;
        QVERIFY2(ratio > 20.0 && ratio < 200.0, qPrintable(QString::number(ratio)));
    }

    /// The callback is called after a fixed number of attempted steps, whether one island or many take them.
    void longFrameCanBeInterrupted_data() { addMethodRows(); }
    void longFrameCanBeInterrupted()
    {
        QFETCH(QString, method);
        const MethodPtr rule = findMethod(method.toStdString());
        Scene scene = separateSprings(std::vector<double>(400, 0.2));
        rule->prepareState(scene.start);
        const Pipeline pipeline = compose(scene, *rule, StepSize::withTolerance(1e-6));
        State state = scene.start;
        int calls = 0;
        QVERIFY(!pipeline.phases.front().runInterruptible(state, [&] { return ++calls < 3; }));
        QCOMPARE(calls, 3);
        // 60 attempted steps, and one evaluation at each start.
        QVERIFY(state.pointEvaluations > 0 && state.pointEvaluations <= 60 * 16 + 400);
        calls = 0;
        state = scene.start;
        QVERIFY(pipeline.phases.front().runInterruptible(state, [&] { return ++calls > 0; }));
        QVERIFY(calls >= 400 / 20);
    }

    /// A gait clock couples all the points that it drives.
    void pointsDrivenByOneClockShareTheirSteps()
    {
        Scene scene = scenes::crowd(2, 1);
        scene.start.position.setZero();
        scene.start.gait.setZero(1);
        scene.start.gaitSpeed.setConstant(1, 0.05);
        scene.groups = {{"all", {0, 4}}};
        scene.effects = {make_shared<LegSpring>(std::vector<Leg>{{0, 1, 0.0, 0}, {2, 3, 0.0, 0}},
                                                LegRule{0.1, 50.0, 0.0, Aim::swing, Reaction::none}),
                         make_shared<Damping>(0.9), make_shared<GaitClock>()};
        Track track(scriptOf(scene, "dop853"), 0);
        track.seek({10, 0});
        QCOMPARE(track.state().adaptiveSteps.size(), std::size_t{1});
        QVERIFY(std::abs(track.state().gait[0] - 0.5) < 1e-12);
    }
};

SUITE(tst_adaptive_islands, TestAdaptiveIslands)
#include "tst_adaptive_islands.moc"

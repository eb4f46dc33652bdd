// Adaptive methods take each part of a scene that nothing ties to the rest by steps of its own: whoever is alone and
// whoever is in company run alike.

#include "energy_support.h"
#include "sim/pipeline/pipeline.h"
#include "support.h"

#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/drivers/gait_clock.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/leg_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/effects/springs/radial_spring.h"
#include "sim/methods/methods.h"

#include <QTest>

#include <cmath>
#include <cstring>
#include <deque>

using namespace sim;
using energy_bench::balanceOf;
using std::make_shared;

namespace {

constexpr int each = 3;     ///< points of one creature
constexpr int frames = 150; ///< enough to fall, bounce and lie

/// A creature with two feet, which number `number` of a crowd is.
struct Creature
{
    int number;
    Vec2 at;
    Vec2 speed;
};

const std::vector<Creature> company = {
    {0, {100.0, 250.0}, {3.0, -2.0}}, {1, {700.0, 90.0}, {0.0, 0.0}}, {2, {400.0, 340.0}, {-6.0, 1.0}}};

/// Creatures in a room. Their points lie part by part, as those of a crowd, so each is several runs; `bounce`: of walls.
Scene roomOf(const std::vector<Creature> &creatures, double bounce)
{
    const int count = static_cast<int>(creatures.size());
    Scene scene = scenes::crowdByParts(count, each - 1);
    for (int part = 0; part < each; ++part) {
        for (int i = 0; i < count; ++i) {
            const Creature &one = creatures[static_cast<std::size_t>(i)];
            const int point = part * count + i;
            scene.start.place(point, one.at + part * Vec2{31.0, 17.0 * one.number - 12.0});
            scene.start.setVelocity(point, one.speed);
            scene.start.inverseMass[point] = 1.0 / (1.0 + part);
            scene.names[static_cast<std::size_t>(point)] =
                (part == 0 ? "body" : "foot" + std::to_string(part)) + std::to_string(one.number);
        }
    }
    scene.groups = {{"all", {0, each * count}}};
    scene.effects = {
        make_shared<RadialSpring>(scenes::legsByParts(count, each - 1), 0.2, 50.0), make_shared<Gravity>(0.5),
        make_shared<Damping>(0.97),
        make_shared<Walls>(Room{0.0, 1000.0, 380.0, bounce}, Eigen::ArrayXd::Constant(each * count, 5.0))};
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

/// Whether a point has the same bits in two states.
bool samePoint(const State &a, int inA, const State &b, int inB)
{
    bool same = a.restingContacts[inA] == b.restingContacts[inB];
    for (int axis = 0; axis < 2; ++axis)
        same = same && sameNumber(a.position(inA, axis), b.position(inB, axis)) &&
               sameNumber(a.velocity(inA, axis), b.velocity(inB, axis));
    return same;
}

/// Points in the air on springs of stiffness `k` to where each can rest, too far from each other to meet.
Scene swings(const std::vector<double> &k)
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
    void whoeverIsAloneRunsAsInCompany_data()
    {
        QTest::addColumn<QString>("method");
        QTest::addColumn<double>("bounce");
        for (const QString method : {"dormand_prince", "rkn86", "dop853"}) {
            for (const double bounce : {1.0, 0.4, 0.0})
                QTest::addRow("%s, bounce %g", qPrintable(method), bounce) << method << bounce;
        }
    }
    void whoeverIsAloneRunsAsInCompany()
    {
        QFETCH(QString, method);
        QFETCH(double, bounce);
        const int count = static_cast<int>(company.size());
        Track together(scriptOf(roomOf(company, bounce), method), 0);
        std::deque<Track> alone;
        for (const Creature &one : company)
            alone.emplace_back(scriptOf(roomOf({one}, bounce), method), 0);
        std::int64_t evaluations = 0;
        int rests = 0;
        for (int frame = 1; frame <= frames; ++frame) {
            together.seek({frame, 0});
            QVERIFY(!together.stop());
            evaluations = 0;
            for (int i = 0; i < count; ++i) {
                Track &one = alone[static_cast<std::size_t>(i)];
                one.seek({frame, 0});
                evaluations += one.state().pointEvaluations;
                for (int part = 0; part < each; ++part) {
                    QVERIFY2(
                        samePoint(together.state(), part * count + i, one.state(), part),
                        qPrintable(QString("creature %1, part %2, frame %3").arg(i).arg(part).arg(frame)));
                    rests += one.state().restingContacts[part] != 0;
                }
                QVERIFY(together.state().adaptiveSteps[static_cast<std::size_t>(i)] ==
                        one.state().adaptiveSteps.front());
            }
            QCOMPARE(together.state().pointEvaluations, evaluations);
        }
        QVERIFY(evaluations > 0);
        QVERIFY(bounce > 0.5 || rests > 0);
    }

    void asManyTimesTheCreaturesAreAsManyTimesTheWork_data() { addMethodRows(); }
    void asManyTimesTheCreaturesAreAsManyTimesTheWork()
    {
        QFETCH(QString, method);
        const auto workOf = [&](int count) {
            std::vector<Creature> creatures;
            for (int i = 0; i < count; ++i)
                creatures.push_back({1, company[1].at, company[1].speed});
            Track track(scriptOf(roomOf(creatures, 0.7), method), 0);
            track.seek({60, 0});
            return track.state().pointEvaluations;
        };
        const std::int64_t one = workOf(1);
        QVERIFY(one > 60 * each);
        for (const int count : {2, 7, 30})
            QCOMPARE(workOf(count), count * one);
    }

    /// A hand that holds one makes what the others have computed ahead begin anew: the motion is the same within the
    /// tolerance, and the hand's point stands where the hand is.
    void aHandOnOneLeavesTheOthersAsTheyAre_data() { addMethodRows(); }
    void aHandOnOneLeavesTheOthersAsTheyAre()
    {
        QFETCH(QString, method);
        const Scene scene = roomOf(company, 0.0);
        Script script = scriptOf(scene, method);
        Track free(script, 0);
        script.input = {{10, Grab{"foot11"}}, {10, Move{{650.0, 60.0}}}, {25, Release{}}};
        Track held(script, 0);
        bool parted = false;
        for (int frame = 1; frame <= 40; ++frame) {
            free.seek({frame, 0});
            held.seek({frame, 0});
            for (int point = 0; point < held.state().pointCount(); ++point) {
                const double off = length(held.state().positionOf(point) - free.state().positionOf(point));
                const bool isOfHeld = scene.names[static_cast<std::size_t>(point)].back() == '1';
                parted = parted || (isOfHeld && off > 1.0);
                QVERIFY2(isOfHeld || off < 1e-3,
                         qPrintable(QString("point %1, frame %2: %3 px").arg(point).arg(frame).arg(off)));
            }
            if (frame >= 10 && frame < 25)
                QVERIFY(held.state().positionOf(scene.find("foot11")) == (Vec2{650.0, 60.0}));
        }
        QVERIFY(parted);
    }

    void steppingBackComesToTheSameBits_data() { addMethodRows(); }
    void steppingBackComesToTheSameBits()
    {
        QFETCH(QString, method);
        Script script = scriptOf(roomOf(company, 0.4), method);
        script.input = {{10, Grab{"body2"}}, {11, Move{{450.0, 300.0}}}, {14, Release{}}};
        const std::string what = support::seekMismatch(script, 1 << 16, 60, 40, 5);
        QVERIFY2(what.empty(), what.c_str());
    }

    void aCrowdThatMaySleepRunsAsOneThatNeverDoes_data() { addMethodRows(); }
    void aCrowdThatMaySleepRunsAsOneThatNeverDoes()
    {
        QFETCH(QString, method);
        Script script = scriptOf(roomOf(company, 0.0), method);
        script.step = StepSize::withTolerance(0.1);
        script.input = {{3000, Grab{"body1"}}, {3001, Move{{500.0, 100.0}}}, {3004, Release{}}};
        Track track(script, Timeline::defaultBudget);
        track.seek({2990, 0});
        Track waker(script, 0, Sleeping::never);
        for (const int frame : {2990, 2995, 3010, 3050}) {
            track.seek({frame, 0});
            waker.seek({frame, 0});
            const std::string what = support::difference(track.state(), waker.state());
            QVERIFY2(what.empty(), what.c_str());
            QCOMPARE(track.state().pointEvaluations, waker.state().pointEvaluations);
            QVERIFY(frame != 3010 ||
                    track.state().positionOf(1).y < 350.0); // the hand has lifted it off the floor
        }
    }

    /// Energy and momentum of a crowd are those of its creatures, account by account.
    void booksOfACrowdAreThoseOfItsCreatures_data() { addMethodRows(); }
    void booksOfACrowdAreThoseOfItsCreatures()
    {
        QFETCH(QString, method);
        constexpr int counted = 60;
        const Balance all = balanceOf(scriptOf(roomOf(company, 0.7), method), counted);
        Balance sum;
        for (const Creature &one : company) {
            const Balance alone = balanceOf(scriptOf(roomOf({one}, 0.7), method), counted);
            for (const AccountName &name : accountNames()) {
                sum.energy[name.account] += alone.energy[name.account];
                sum.momentum[name.account] = sum.momentum[name.account] + alone.momentum[name.account];
            }
        }
        const double scale = std::abs(all.energy[Account::impact]);
        QVERIFY(scale > 100.0);
        for (const AccountName &name : accountNames()) {
            const double off = all.energy[name.account] - sum.energy[name.account];
            QVERIFY2(std::abs(off) < 1e-9 * scale, name.id.c_str());
            QVERIFY2(length(all.momentum[name.account] - sum.momentum[name.account]) < 1e-9 * scale,
                     name.id.c_str());
        }
        // What drifts is what the method is off: nothing of the jumps of one is booked for another.
        QVERIFY2(std::abs(all.energy[Account::drift]) < 1e-5 * scale,
                 qPrintable(QString::number(all.energy[Account::drift])));
    }

    void whereOneGivesUpItsPointIsNamed_data() { addMethodRows(); }
    void whereOneGivesUpItsPointIsNamed()
    {
        QFETCH(QString, method);
        // The third swings 600 times a frame.
        Script script = scriptOf(swings({0.2, 0.3, 1.6e7, 0.2}), method);
        script.step = StepSize::withTolerance(1e-13);
        Track track(script, 0);
        track.seek({5, 0});
        QVERIFY(track.stop());
        QVERIFY(track.stop()->reason == StopReason::tooManySteps);
        QCOMPARE(track.stop()->body, std::string("p2"));
        QVERIFY(sameBits(track.state(), Track(script, 0).state())); // as it was before the frame
    }

    /// Each gets the steps that it needs: a stiff one does not shorten those of the others.
    void aStiffOneDoesNotShortenTheStepsOfTheOthers_data() { addMethodRows(); }
    void aStiffOneDoesNotShortenTheStepsOfTheOthers()
    {
        QFETCH(QString, method);
        Track track(scriptOf(swings({0.01, 50.0}), method), 0);
        track.seek({40, 0});
        const std::vector<AdaptiveStep> &lastStep = track.state().adaptiveSteps;
        QCOMPARE(lastStep.size(), std::size_t{2});
        // Steps go with the time of a swing: the square root of the ratio of stiffness, 70.
        const double ratio = lastStep[0].length / lastStep[1].length;
        QVERIFY2(ratio > 20.0 && ratio < 200.0, qPrintable(QString::number(ratio)));
    }

    /// It is asked whether to go on after as many tries in a crowd of many as in one part that takes long.
    void aFrameOfManyIsLeftOffOnTheWay_data() { addMethodRows(); }
    void aFrameOfManyIsLeftOffOnTheWay()
    {
        QFETCH(QString, method);
        const MethodPtr rule = findMethod(method.toStdString());
        Scene scene = swings(std::vector<double>(400, 0.2));
        rule->prepareState(scene.start);
        const Pipeline pipeline = compose(scene, *rule, StepSize::withTolerance(1e-6));
        State state = scene.start;
        int asked = 0;
        QVERIFY(!pipeline.phases.front().runInterruptible(state, [&] { return ++asked < 3; }));
        QCOMPARE(asked, 3);
        QVERIFY(state.pointEvaluations > 0 &&
                state.pointEvaluations <= 60 * 16 + 400); // 60 tries, and a look at each start
        asked = 0;
        state = scene.start;
        QVERIFY(pipeline.phases.front().runInterruptible(state, [&] { return ++asked > 0; }));
        QVERIFY(asked >= 400 / 20);
    }

    /// A clock is one for all: what is driven stays together.
    void whatAClockDrivesGoesByCommonSteps()
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

QTEST_APPLESS_MAIN(TestAdaptiveIslands)
#include "tst_adaptive_islands.moc"

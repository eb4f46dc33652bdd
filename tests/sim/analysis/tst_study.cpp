// The accuracy study: progress and cancellation, timing, its rows, and refused scenes.

#include "tests/sim/support/study_scenes.h"

#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>

using namespace sim;
using namespace support;

namespace {

/// A spring that counts its evaluations.
class CountedSpring : public PointSpring
{
public:
    CountedSpring(int mover, Vec2 centre, double k, std::int64_t &evaluations)
        : PointSpring(mover, centre, k), m_evaluations(evaluations)
    {
    }
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &accelerations) const override
    {
        ++m_evaluations;
        PointSpring::add(state, movers, scale, directionRule, accelerations);
    }

private:
    std::int64_t &m_evaluations;
};

}

class TestStudy : public QObject
{
    Q_OBJECT

private slots:
    void cancelledStudyEndsAtOnce_data()
    {
        QTest::addColumn<int>("calls");
        for (const int calls : {1, 2, 3, 5, 8})
            QTest::addRow("at call %d", calls) << calls;
    }
    void cancelledStudyEndsAtOnce()
    {
        QFETCH(int, calls);
        int callsMade = 0;
        const auto stop = [&](const Accuracy &, double) { return ++callsMade < calls; };
        StudyPlan plan;
        plan.frames = 10'000;
        const Accuracy found = studyAccuracy(scriptOf(dampedSpring()), plan, stop);
        QCOMPARE(callsMade, calls); // the callback was not called again
        QVERIFY(!found.rows.empty());
        if (calls == 1)
            QVERIFY(found.rows.front().outcome == Outcome::waiting);
    }

    void studyCanBeCancelledWithinAFrame()
    {
        // The springs are so stiff that the reference run needs more steps than a frame may have. Many
        // coupled points make these steps slow, so the study is cancelled within the first frame.
        std::int64_t evaluations = 0, evaluationsWhenStopped = 0;
        Scene scene = scenes::creature(400);
        support::scatter(scene.start, 7, 300.0);
        scene.effects = {std::make_shared<CountedSpring>(0, anchor, 1e12, evaluations)};
        for (int i = 1; i <= 400; ++i)
            scene.effects.push_back(std::make_shared<PointSpring>(i, anchor, 1e12));
        scene.effects.push_back(std::make_shared<BodySpring>(scenes::legs(400), 1e-6));
        int calls = 0;
        const auto stop = [&](const Accuracy &, double) {
            evaluationsWhenStopped = evaluations;
            return ++calls < 2;
        };
        const Accuracy found = studyAccuracy(scriptOf(scene), quickPlan(100), stop);
        QCOMPARE(calls, 2);
        QCOMPARE(found.horizon, std::int64_t(0));
        const std::int64_t evaluationsAfterStop = evaluations - evaluationsWhenStopped;
        QVERIFY2(evaluationsAfterStop <= 20 * 16,
                 std::to_string(evaluationsAfterStop)
                     .c_str()); // 20 attempted steps with at most 16 evaluations each
    }

    void frameWithTooManyStepsEndsTheReferenceRun()
    {
        Scene scene = dampedSpring();
        scene.effects = {std::make_shared<PointSpring>(0, anchor, 1e12)};
        const Accuracy found = studyAccuracy(scriptOf(scene), quickPlan(10), keepGoing);
        QCOMPARE(found.horizon, std::int64_t(0));
        QVERIFY(found.reference.end == ReferenceRun::End::tooLong);
    }

    void progressGoesFromZeroToOne()
    {
        std::vector<double> shares;
        studyAccuracy(scriptOf(dampedSpring()), quickPlan(50), [&](const Accuracy &, double done) {
            shares.push_back(done);
            return true;
        });
        QVERIFY(std::is_sorted(shares.begin(), shares.end()));
        QCOMPARE(shares.front(), 0.0);
        QCOMPARE(shares.back(), 1.0);
    }

    void measuredRowsAreTimedAndTheFrontIsUnbeaten()
    {
        StudyPlan plan;
        plan.frames = 30;
        plan.secondsOfTiming = 0.2;
        const Accuracy found = studyAccuracy(scriptOf(dampedSpring()), plan, keepGoing);
        int front = 0;
        for (const AccuracyRow &row : found.rows) {
            if (row.outcome != Outcome::measured)
                continue;
            QVERIFY2(row.nsPerFrame > 0.0 && row.spread >= 0.0, nameOf(row).c_str());
            const bool isBeaten =
                std::any_of(found.rows.begin(), found.rows.end(), [&](const AccuracyRow &other) {
                    return other.outcome == Outcome::measured && &other != &row && other.error <= row.error &&
                           other.nsPerFrame < row.nsPerFrame;
                });
            QVERIFY2(row.front != isBeaten, nameOf(row).c_str());
            front += row.front;
        }
        QVERIFY(front >= 2);
    }

    void cheapestIsTheFastestWithinTheError()
    {
        Accuracy found;
        const MethodPtr method = findMethod("published");
        const auto add = [&](double error, double cost, Outcome outcome) {
            AccuracyRow row;
            row.setup = {method, StepSize::ofLength(1.0)};
            row.outcome = outcome;
            row.error = error;
            row.nsPerFrame = cost;
            found.rows.push_back(row);
        };
        add(5.0, 10.0, Outcome::measured);
        add(0.1, 40.0, Outcome::measured);
        add(0.05, 30.0, Outcome::measured);
        add(0.01, 20.0, Outcome::unstable);
        add(0.01, 0.0, Outcome::measured); // not timed
        QCOMPARE(found.cheapest(10.0), &found.rows[0]);
        QCOMPARE(found.cheapest(0.1), &found.rows[2]);
        QCOMPARE(found.cheapest(0.05), &found.rows[2]);
        QVERIFY(!found.cheapest(0.04));
        markFront(found.rows);
        std::vector<bool> front;
        for (const AccuracyRow &row : found.rows)
            front.push_back(row.front);
        QCOMPARE(front, (std::vector<bool>{true, false, true, false, false}));
    }

    void refinementLevelsGoFromCoarseToFine()
    {
        for (const MethodPtr &method : allMethods()) {
            const std::vector<StepSize> levels = refinementLevels(*method);
            QCOMPARE(levels.size(), std::size_t(method->stepping() == Stepping::fixed ? 7 : 11));
            for (std::size_t i = 0; i < levels.size(); ++i) {
                QCOMPARE(levels[i].isAdaptive(), method->stepping() == Stepping::adaptive);
                if (i > 0)
                    QVERIFY(levels[i].h < levels[i - 1].h || levels[i].tolerance < levels[i - 1].tolerance);
            }
        }
    }

    void methodSetupInUseIsSortedIntoTheLevels_data()
    {
        QTest::addColumn<double>("h");
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("index");
        QTest::newRow("a level") << 0.5 << 7 << 1;
        QTest::newRow("between two levels") << 1.0 / 3.0 << 8 << 2;
        QTest::newRow("coarser than all levels") << 5.0 << 8 << 0;
        QTest::newRow("finer than all levels") << 0.01 << 8 << 7;
    }
    void methodSetupInUseIsSortedIntoTheLevels()
    {
        QFETCH(double, h);
        QFETCH(int, rows);
        QFETCH(int, index);
        Script script = scriptOf(dampedSpring());
        script.step = StepSize::ofLength(h);
        StudyPlan plan = quickPlan(21);
        plan.inUse = MethodSetup{script.method, script.step};
        const Accuracy found = studyAccuracy(script, plan, keepGoing);
        std::vector<const AccuracyRow *> published;
        for (const AccuracyRow &row : found.rows) {
            if (row.setup.method->id() == "published")
                published.push_back(&row);
        }
        QCOMPARE(int(published.size()), rows);
        const AccuracyRow &row = *published[std::size_t(index)];
        QCOMPARE(row.setup.step.h, script.step.h);
        QVERIFY(row.outcome == Outcome::measured);
        QCOMPARE(row.evaluations, 1.0 / h);
        // With steps longer than a frame, the frames between two output steps have the error of the earlier
        // one.
        QCOMPARE(row.errorAt.size(), std::size_t(h > 1.0 ? 21 : 22));
        if (h == 5.0)
            QVERIFY(row.errorAt[9] == row.errorAt[5] && row.errorAt[10] != row.errorAt[9]);
    }

    void stepBeyondTheHorizonDoesNotFit()
    {
        Script script = scriptOf(dampedSpring());
        StudyPlan plan = quickPlan(20);
        plan.inUse = MethodSetup{script.method, StepSize::ofLength(50.0)};
        const Accuracy found = studyAccuracy(script, plan, keepGoing);
        const AccuracyRow &row = found.rows.front();
        QVERIFY(row.setup.step == plan.inUse->step && row.outcome == Outcome::doesNotFit);
        QCOMPARE(row.why->id(), std::string("short-horizon"));
        QVERIFY(found.rows[1].outcome == Outcome::measured);
    }

    void sceneThatDoesNotFitItsMethodIsRefused()
    {
        Scene scene = dampedSpring();
        scene.effects.clear();
        scene.groups = {};
        QVERIFY_THROWS_EXCEPTION(Error, studyAccuracy(scriptOf(scene), quickPlan(5), keepGoing));
    }
};

SUITE(tst_study, TestStudy)
#include "tst_study.moc"

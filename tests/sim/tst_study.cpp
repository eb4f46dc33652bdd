// The study of accuracy: how it is watched and stopped, what is timed, which rows it has and what it refuses.

#include "study_scenes.h"

#include "sim/effects/springs/body_spring.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/methods/methods.h"

#include <QTest>

#include <algorithm>

using namespace sim;
using namespace support;

namespace {

/// A spring that counts how often it was asked for its pull.
class CountedSpring : public PointSpring
{
public:
    CountedSpring(int mover, Vec2 centre, double k, std::int64_t &asked)
        : PointSpring(mover, centre, k), m_asked(asked)
    {
    }
    void add(const State &state, PointRange movers, double scale, DirectionRule directionRule,
             Eigen::ArrayX2d &into) const override
    {
        ++m_asked;
        PointSpring::add(state, movers, scale, directionRule, into);
    }

private:
    std::int64_t &m_asked;
};

}

class TestStudy : public QObject
{
    Q_OBJECT

private slots:
    void aStudyThatIsStoppedEndsAtOnce_data()
    {
        QTest::addColumn<int>("calls");
        for (const int calls : {1, 2, 3, 5, 8})
            QTest::addRow("at call %d", calls) << calls;
    }
    void aStudyThatIsStoppedEndsAtOnce()
    {
        QFETCH(int, calls);
        int made = 0;
        const auto stop = [&](const Accuracy &, double) { return ++made < calls; };
        StudyPlan plan;
        plan.frames = 10'000;
        const Accuracy found = studyAccuracy(scriptOf(dampedSpring()), plan, stop);
        QCOMPARE(made, calls); // it was not asked again
        QVERIFY(!found.rows.empty());
        if (calls == 1)
            QVERIFY(found.rows.front().outcome == Outcome::waiting);
    }

    void aStudyIsStoppedInTheMiddleOfAFrame()
    {
        // So stiff that the exact run takes all the steps that a frame may have, and of many points that are tied to each
        // other, so that they take a while: the study is told to stop before its first frame is done.
        std::int64_t asked = 0, askedWhenStopped = 0;
        Scene scene = scenes::creature(400);
        support::scatter(scene.start, 7, 300.0);
        scene.effects = {std::make_shared<CountedSpring>(0, spot, 1e12, asked)};
        for (int i = 1; i <= 400; ++i)
            scene.effects.push_back(std::make_shared<PointSpring>(i, spot, 1e12));
        scene.effects.push_back(std::make_shared<BodySpring>(scenes::legs(400), 1e-6));
        int calls = 0;
        const auto stop = [&](const Accuracy &, double) {
            askedWhenStopped = asked;
            return ++calls < 2;
        };
        const Accuracy found = studyAccuracy(scriptOf(scene), quickPlan(100), stop);
        QCOMPARE(calls, 2);
        QCOMPARE(found.horizon, std::int64_t(0));
        const std::int64_t more = asked - askedWhenStopped;
        QVERIFY2(more <= 20 * 16, std::to_string(more).c_str()); // 20 tries, of at most 16 evaluations each
    }

    void aFrameOfTooManyStepsTakesTooLong()
    {
        Scene scene = dampedSpring();
        scene.effects = {std::make_shared<PointSpring>(0, spot, 1e12)};
        const Accuracy found = studyAccuracy(scriptOf(scene), quickPlan(10), goOn);
        QCOMPARE(found.horizon, std::int64_t(0));
        QVERIFY(found.reference.end == ReferenceRun::End::tooLong);
    }

    void progressGoesFromNothingToOne()
    {
        std::vector<double> shares;
        studyAccuracy(scriptOf(dampedSpring()), quickPlan(50), [&](const Accuracy &, double done) {
            shares.push_back(done);
            return true;
        });
        QVERIFY(std::is_sorted(shares.begin(), shares.end()));
        QVERIFY(shares.front() >= 0.0);
        QCOMPARE(shares.back(), 1.0);
    }

    void everyMeasuredRowIsTimedAndTheFrontIsWhatNothingBeats()
    {
        StudyPlan plan;
        plan.frames = 30;
        plan.secondsOfTiming = 0.2;
        const Accuracy found = studyAccuracy(scriptOf(dampedSpring()), plan, goOn);
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

    void theCheapestIsTheFastestThatIsWithinTheError()
    {
        Accuracy found;
        const MethodPtr method = findMethod("published");
        const auto add = [&](double error, double ns, Outcome outcome) {
            AccuracyRow row;
            row.setup = {method, StepSize::ofLength(1.0)};
            row.outcome = outcome;
            row.error = error;
            row.nsPerFrame = ns;
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

    void laddersGoFromCoarseToFine()
    {
        for (const MethodPtr &method : allMethods()) {
            const std::vector<StepSize> rungs = refinementLevels(*method);
            QCOMPARE(rungs.size(), std::size_t(method->stepping() == Stepping::fixed ? 7 : 11));
            for (std::size_t i = 0; i < rungs.size(); ++i) {
                QCOMPARE(rungs[i].isAdaptive(), method->stepping() == Stepping::adaptive);
                if (i > 0)
                    QVERIFY(rungs[i].h < rungs[i - 1].h || rungs[i].tolerance < rungs[i - 1].tolerance);
            }
        }
    }

    void theWayInUseHasItsPlaceAmongTheRungs_data()
    {
        QTest::addColumn<double>("h");
        QTest::addColumn<int>("rows");
        QTest::addColumn<int>("place");
        QTest::newRow("a rung") << 0.5 << 7 << 1;
        QTest::newRow("between two") << 1.0 / 3.0 << 8 << 2;
        QTest::newRow("coarser than all") << 5.0 << 8 << 0;
        QTest::newRow("finer than all") << 0.01 << 8 << 7;
    }
    void theWayInUseHasItsPlaceAmongTheRungs()
    {
        QFETCH(double, h);
        QFETCH(int, rows);
        QFETCH(int, place);
        Script script = scriptOf(dampedSpring());
        script.step = StepSize::ofLength(h);
        StudyPlan plan = quickPlan(21);
        plan.inUse = MethodSetup{script.method, script.step};
        const Accuracy found = studyAccuracy(script, plan, goOn);
        std::vector<const AccuracyRow *> published;
        for (const AccuracyRow &row : found.rows) {
            if (row.setup.method->id() == "published")
                published.push_back(&row);
        }
        QCOMPARE(int(published.size()), rows);
        const AccuracyRow &row = *published[std::size_t(place)];
        QCOMPARE(row.setup.step.h, script.step.h);
        QVERIFY(row.outcome == Outcome::measured);
        QCOMPARE(row.evaluations, 1.0 / h);
        // Of rows that are frames apart, the frames between have the error of the one before.
        QCOMPARE(row.errorAt.size(), std::size_t(h > 1.0 ? 21 : 22));
        if (h == 5.0)
            QVERIFY(row.errorAt[9] == row.errorAt[5] && row.errorAt[10] != row.errorAt[9]);
    }

    void aStepPastTheHorizonHasNothingToBeComparedWith()
    {
        Script script = scriptOf(dampedSpring());
        StudyPlan plan = quickPlan(20);
        plan.inUse = MethodSetup{script.method, StepSize::ofLength(50.0)};
        const Accuracy found = studyAccuracy(script, plan, goOn);
        const AccuracyRow &row = found.rows.front();
        QVERIFY(row.setup.step == plan.inUse->step && row.outcome == Outcome::doesNotFit);
        QCOMPARE(row.why->id(), std::string("short-horizon"));
        QVERIFY(found.rows[1].outcome == Outcome::measured);
    }

    void aSceneThatItsOwnMethodCannotComputeIsRefused()
    {
        Scene scene = dampedSpring();
        scene.effects.clear();
        scene.groups = {};
        QVERIFY_EXCEPTION_THROWN(studyAccuracy(scriptOf(scene), quickPlan(5), goOn), Error);
    }
};

QTEST_GUILESS_MAIN(TestStudy)
#include "tst_study.moc"

// The accuracy study: its errors against closed forms, and its horizon.

#include "tests/sim/support/study_scenes.h"

#include "sim/analysis/accuracy/reference.h"
#include "sim/effects/constraints/sticks.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/point_spring.h"
#include "sim/methods/methods.h"
#include "sim/scenes/sticks.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <limits>
#include <set>

using namespace sim;
using namespace support;

namespace {

/// Parameters of a ball that falls and bounces: px/frame^2, restitution, px.
constexpr double gravity = 0.5, bounce = 0.8, ground = 375.0;
const Vec2 dropX = {100.0, 200.0}, dropV = {1.5, 0.0};

Scene bouncingBall()
{
    Scene scene = scenes::onePoint("ball", dropX, dropV);
    scene.effects = {
        std::make_shared<Gravity>(gravity),
        std::make_shared<Walls>(Room{0.0, 1e6, ground + 5.0, bounce}, Eigen::ArrayXd::Constant(1, 5.0))};
    return scene;
}

/// Returns the ball's exact position after t frames: parabola after parabola.
Vec2 bouncingBallAt(double t)
{
    double y = dropX.y, v = dropV.y, timeLeft = t;
    for (;;) {
        // The first time s > 0 with y + v s + fall s^2 / 2 = ground.
        const double timeToHit = (-v + std::sqrt(v * v + 2.0 * gravity * (ground - y))) / gravity;
        if (timeToHit >= timeLeft)
            return {dropX.x + dropV.x * t, y + v * timeLeft + gravity * timeLeft * timeLeft / 2.0};
        timeLeft -= timeToHit;
        v = -bounce * (v + gravity * timeToHit);
        y = ground;
    }
}

/// Returns the largest distance of point 0 from `truth` in the first `frames` frames, px.
double errorAgainst(const Script &script, const std::function<Vec2(double)> &truth, std::int64_t frames)
{
    Track track(script, 0);
    double largest = 0.0;
    for (std::int64_t frame = 1; frame <= frames; ++frame) {
        track.seek({frame, 0});
        largest = std::max(largest, length(track.state().positionOf(0) - truth(static_cast<double>(frame))));
    }
    return largest;
}

/// Returns an undamped creature in a room. It never comes to rest, and small differences grow.
Script undampedCreature()
{
    Script script = support::script(support::sample("creature in a room"), "published");
    script.values.set("damp", 1.0);
    return script;
}

/// Returns a thrown chain of three sticks that have their lengths at the start.
Scene threeSticks()
{
    Scene scene = scenes::creature(3);
    for (int i = 0; i < 4; ++i)
        scene.start.place(i, {200.0 + 36.0 * i, i % 2 == 0 ? 200.0 : 248.0});
    scene.start.setVelocity(0, {3.0, -4.0});
    scene.effects = {std::make_shared<Gravity>(0.5), std::make_shared<Damping>(0.99),
                     std::make_shared<Sticks>(scenes::chainOfSticks(3, 60.0), 4)};
    return scene;
}

}

class TestWorkPrecision : public QObject
{
    Q_OBJECT

private slots:
    void errorsAgreeWithTheClosedFormWithinTwoPercent_data()
    {
        QTest::addColumn<bool>("bounces");
        QTest::addColumn<int>("frames");
        QTest::newRow("a damped spring") << false << 200;
        QTest::newRow("a ball that bounces") << true << 150;
    }
    void errorsAgreeWithTheClosedFormWithinTwoPercent()
    {
        QFETCH(bool, bounces);
        QFETCH(int, frames);
        const Scene scene = bounces ? bouncingBall() : dampedSpring();
        const std::function<Vec2(double)> truth = bounces ? bouncingBallAt : dampedSpringAt;
        const Accuracy found = studyAccuracy(scriptOf(scene), quickPlan(frames), keepGoing);
        QCOMPARE(found.horizon, frames);
        QVERIFY(found.reference.kind == ReferenceRun::Kind::solution);
        int compared = 0;
        std::set<std::string> methods;
        for (const AccuracyRow &row : found.rows) {
            if (row.outcome != Outcome::measured || row.error < 1e-8)
                continue; // smaller errors are rounding errors of the closed form
            const double exact = errorAgainst(scriptOf(scene, row.setup), truth, frames);
            const std::string message =
                nameOf(row) + ": " + std::to_string(row.error) + ", not " + std::to_string(exact);
            QVERIFY2(std::abs(row.error - exact) <= 0.02 * exact, message.c_str());
            ++compared;
            methods.insert(row.setup.method->id());
        }
        QVERIFY(compared > 20);
        QVERIFY(methods.size() > 4);
    }

    void referenceRunMatchesTheClosedForm()
    {
        const Accuracy found = studyAccuracy(scriptOf(bouncingBall()), quickPlan(100), keepGoing);
        QCOMPARE(found.reference.trajectories.size(), std::size_t(101));
        for (std::size_t frame = 0; frame <= 100; ++frame) {
            const Vec2 exact = bouncingBallAt(static_cast<double>(frame));
            QVERIFY(length(found.reference.trajectories[frame][0] - exact) < 1e-8);
        }
        QVERIFY(found.reference.disagreement <= referenceAgreement);
    }

    void errorIsReproducedByARunOfTheMethodAndStep_data()
    {
        QTest::addColumn<bool>("hasInput");
        QTest::newRow("without input") << false;
        QTest::newRow("with a drag and a parameter change") << true;
    }
    void errorIsReproducedByARunOfTheMethodAndStep()
    {
        QFETCH(bool, hasInput);
        Script script = support::script(support::sample("creature from one place"), "published");
        script.values.set("spread", 200.0);
        if (hasInput)
            script.input = {
                {20, Grab{"foot1"}}, {22, Move{{300, 150}}}, {30, Release{}}, {35, Set{"k", 0.15}}};
        const Accuracy found = studyAccuracy(script, quickPlan(60), keepGoing);
        QVERIFY(found.horizon > 30);
        support::Dice dice(2026);
        for (int checked = 0; checked < 10;) {
            const AccuracyRow &row = found.rows[std::size_t(dice.whole(0, int(found.rows.size()) - 1))];
            if (row.outcome != Outcome::measured)
                continue;
            ++checked;
            Script reference = script;
            reference.method = row.setup.method;
            reference.step = row.setup.step;
            Track track(reference, 1 << 20);
            double largest = 0.0;
            for (std::int64_t frame = 1; frame <= found.horizon; ++frame) {
                track.seek({frame, 0});
                double maxDistance = 0.0;
                const std::vector<Vec2> &places = found.reference.trajectories[std::size_t(frame)];
                for (std::size_t i = 0; i < places.size(); ++i)
                    maxDistance = std::max(maxDistance, length(track.state().positionOf(int(i)) - places[i]));
                QCOMPARE(row.errorAt[std::size_t(frame)], maxDistance);
                largest = std::max(largest, maxDistance);
            }
            QCOMPARE(row.error, largest);
        }
    }

    void horizonEndsWhereSmallDifferencesGrow()
    {
        const Accuracy found = studyAccuracy(undampedCreature(), quickPlan(3000), keepGoing);
        QVERIFY(found.reference.kind == ReferenceRun::Kind::solution);
        QVERIFY(found.horizon > 10 && found.horizon < 3000);
        QVERIFY(found.reference.end == ReferenceRun::End::diverged);
        QVERIFY(found.reference.disagreement <= referenceAgreement);
        QCOMPARE(std::int64_t(found.reference.trajectories.size()), found.horizon + 1);
        // The two reference runs differ in the frame after the horizon.
        Script first = undampedCreature(), second = undampedCreature();
        first.method = findMethod(found.reference.method);
        first.step = found.reference.step;
        second.method = findMethod(found.reference.check);
        second.step = found.reference.checkStep;
        Track a(first, 0), b(second, 0);
        const auto distanceAt = [&](std::int64_t frame) {
            a.seek({frame, 0});
            b.seek({frame, 0});
            double maxDistance = 0.0;
            for (int i = 0; i < a.state().pointCount(); ++i)
                maxDistance =
                    std::max(maxDistance, length(a.state().positionOf(i) - b.state().positionOf(i)));
            return maxDistance;
        };
        QVERIFY(distanceAt(found.horizon) <= referenceAgreement);
        QVERIFY(distanceAt(found.horizon + 1) > referenceAgreement);
    }

    void sceneWithoutContinuousLimitUsesSelfRefinement()
    {
        const Accuracy found = studyAccuracy(scriptOf(threeSticks()), quickPlan(20), keepGoing);
        QVERIFY(found.reference.kind == ReferenceRun::Kind::selfRefinement);
        QCOMPARE(found.reference.discontinuity->id(), std::string("sticks"));
        QVERIFY(found.reference.trajectories.empty());
        QVERIFY(found.horizon > 0);
        int measured = 0;
        for (const AccuracyRow &row : found.rows) {
            if (row.setup.method->stepping() == Stepping::adaptive) {
                QVERIFY(row.outcome == Outcome::doesNotFit);
                QCOMPARE(row.why->id(), std::string("method-does-not-fit"));
            }
            measured += row.outcome == Outcome::measured;
        }
        QVERIFY(measured >= 14);
    }

    void selfRefinementIsTheFinestRunOfTheMethod()
    {
        const Scene scene = threeSticks();
        StudyPlan plan = quickPlan(15);
        plan.secondsPerRun = 600.0; // so the finest run does not depend on the load of the machine
        const Accuracy found = studyAccuracy(scriptOf(scene), plan, keepGoing);
        QVERIFY(found.horizon > 0);
        for (const AccuracyRow &row : found.rows) {
            if (row.outcome != Outcome::measured || row.setup.method->id() != "semi_implicit_euler")
                continue;
            Track reference(scriptOf(scene, {row.setup.method, found.reference.step}), 0);
            Track run(scriptOf(scene, row.setup), 0);
            double largest = 0.0;
            for (std::int64_t frame = 1; frame <= found.horizon; ++frame) {
                reference.seek({frame, 0});
                run.seek({frame, 0});
                for (int i = 0; i < 4; ++i)
                    largest = std::max(largest,
                                       length(reference.state().positionOf(i) - run.state().positionOf(i)));
            }
            QCOMPARE(row.error, largest);
        }
    }

    void growingRunsAreUnstable()
    {
        Scene scene = dampedSpring();
        scene.effects = {std::make_shared<PointSpring>(0, anchor, 6.0)}; // stable up to h = 2 / sqrt(6)
        const Accuracy found = studyAccuracy(scriptOf(scene), quickPlan(200), keepGoing);
        int published = 0, unstable = 0;
        for (const AccuracyRow &row : found.rows) {
            if (row.setup.method->id() != "published")
                continue;
            ++published;
            unstable += row.outcome == Outcome::unstable ? 1 : 0;
            QCOMPARE(row.outcome == Outcome::unstable, row.setup.step.h == 1.0);
        }
        QCOMPARE(unstable, 1);
        QVERIFY(published > 1);
    }

    void previewHasTheErrorsOfItsFrames()
    {
        StudyPlan plan = quickPlan(60);
        plan.secondsToPreview = 0.0;
        int compared = 0;
        bool isRight = true;
        std::int64_t lastPreview = 0;
        const auto compare = [&](const Accuracy &soFar, double) {
            if (soFar.previewed == 0 || soFar.previewed == lastPreview)
                return true;
            isRight &= soFar.previewed <= soFar.horizon;
            for (const AccuracyRow &row : soFar.rows) {
                if (row.outcome != Outcome::measured || row.error < 1e-8)
                    continue;
                const double exact =
                    errorAgainst(scriptOf(dampedSpring(), row.setup), dampedSpringAt, soFar.previewed);
                isRight &= std::abs(row.error - exact) <= 1e-3 * exact + 1e-9;
                lastPreview = soFar.previewed;
                ++compared;
            }
            return true;
        };
        const Accuracy found = studyAccuracy(scriptOf(dampedSpring()), plan, compare);
        QVERIFY(isRight);
        QVERIFY(compared > 10);
        QCOMPARE(found.previewed, 0);
    }

    void previewDoesNotChangeTheResult()
    {
        StudyPlan withPreview = quickPlan(60);
        withPreview.secondsToPreview = 0.0;
        StudyPlan withoutPreview = quickPlan(60);
        withoutPreview.secondsToPreview = std::numeric_limits<double>::infinity();
        const Accuracy a = studyAccuracy(scriptOf(bouncingBall()), withPreview, keepGoing);
        const Accuracy b = studyAccuracy(scriptOf(bouncingBall()), withoutPreview, keepGoing);
        QCOMPARE(a.horizon, b.horizon);
        QCOMPARE(a.reference.disagreement, b.reference.disagreement);
        QCOMPARE(a.rows.size(), b.rows.size());
        for (std::size_t i = 0; i < a.rows.size(); ++i) {
            if (a.rows[i].outcome == Outcome::tooLong || b.rows[i].outcome == Outcome::tooLong)
                continue; // depends on the machine
            QVERIFY(a.rows[i].outcome == b.rows[i].outcome);
            QCOMPARE(a.rows[i].errorAt, b.rows[i].errorAt);
            QCOMPARE(a.rows[i].evaluations, b.rows[i].evaluations);
        }
    }
};

SUITE(tst_work_precision, TestWorkPrecision)
#include "tst_work_precision.moc"

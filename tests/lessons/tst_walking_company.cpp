#include "lessons/api/view/view.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"
#include "tests/lessons/support/support.h"
#include "tests/lessons/support/trajectory.h"

#include "sim/methods/methods.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>

using namespace support;

/// Steps `walls` and `company`, which follow the tutorial's last two suggestions.
class WalkingCompany : public QObject
{
    Q_OBJECT

    const LoadedLesson m_lesson = loadLesson(QStringLiteral("walking_gait"));

    const lessons::Step &step(const char *id) const { return m_lesson.step(QString::fromUtf8(id)); }

    /// Returns the mean of the slip that step `walls` measures, from frame `from` to frame `to`.
    double slipOf(const sim::Script &script, int from, int to) const;

    /// Returns step `company` in the air, where momentum is conserved: only legs and pushes between creatures
    /// act.
    sim::Script inTheAir(const std::string &method, double feltBy, double h = 1.0) const
    {
        sim::Script script = scriptOf(step("company"), method, h,
                                      {{"felt_by", feltBy},
                                       {"damp", 1.0},
                                       {"gravity", 0.0},
                                       {"ground", 1e6},
                                       {"left", -1e6},
                                       {"right", 1e6},
                                       {"creatures", 3.0}});
        script.bodies = {{"creature0.body", {{230, 300}, sim::Vec2{2, 1}}},
                         {"creature1.body", {{260, 310}, {}}},
                         {"creature2.body", {{300, 290}, sim::Vec2{-3, 0}}}};
        return script;
    }

private slots:
    void nothingPassesAWall_data() { addWalkingMethodRows(); }
    void nothingPassesAWall();
    void creatureTurnsAtWallsOrKeepsWalking();
    void feetSlipMoreAgainstAWall();
    void pushesConserveMomentum_data() { addWalkingMethodRows(); }
    void pushesConserveMomentum();
    void oneSidedPushCreatesMomentum_data() { addWalkingMethodRows(); }
    void oneSidedPushCreatesMomentum();
    void pushesSumToZeroUnlessOneSided();
    void draggedCreaturePushesTheOther();
    void creaturesDoNotOverlapAndPassEachOther();
    void pointsAreOrderedByCreature();
    void fiveCreaturesStayInTheRoom();
};

double WalkingCompany::slipOf(const sim::Script &script, int from, int to) const
{
    const lessons::Measure &slip = step("walls").measures.at(1);
    sim::Track track(script, 0);
    track.seek({from, 0});
    double sum = 0.0;
    int count = 0;
    for (int frame = from + 1; frame <= to; ++frame) {
        const sim::State before = track.state();
        track.seek({frame, 0});
        const double now = slip.of(track.interval().scene, track.state(), &before, track.interval().values);
        sum += std::isfinite(now) ? now : 0.0;
        count += std::isfinite(now);
    }
    return sum / count;
}

void WalkingCompany::nothingPassesAWall()
{
    QFETCH(QString, method);
    for (double keepOn : {0.0, 1.0}) {
        sim::Script script = scriptOf(step("walls"), method.toStdString(), 1.0, {{"at_wall", keepOn}});
        script.bodies["body"] = {{300, 280}, sim::Vec2{40, -5}};
        MotionSummary motion = motionOf(script, "body", 0, 1500);
        QVERIFY(motion.left >= 35.0 && motion.right <= 505.0);
        for (const char *foot : {"foot0", "foot1"}) {
            motion = motionOf(script, foot, 0, 1500);
            QVERIFY(motion.left >= 25.0 && motion.right <= 515.0);
        }
    }
}

void WalkingCompany::creatureTurnsAtWallsOrKeepsWalking()
{
    const MotionSummary turning = motionOf(step("walls").script(), "body", 0, 2000);
    QVERIFY(turning.left < 80.0 && turning.right > 450.0);
    const sim::Script keepsOn = scriptOf(step("walls"), "published", 1.0, {{"at_wall", 1.0}});
    const MotionSummary stuck = motionOf(keepsOn, "body", 600, 2600);
    QVERIFY2(stuck.left > 440.0, qPrintable(QString::number(stuck.left)));
    QCOMPARE(stateAfter(keepsOn, 2000).gaitSpeed[0], 0.05);
}

/// Checks the numbers in the step's text: 1.1 px per frame, more than twice the slip of free walking.
void WalkingCompany::feetSlipMoreAgainstAWall()
{
    const double against = slipOf(scriptOf(step("walls"), "published", 1.0, {{"at_wall", 1.0}}), 800, 2600);
    const double free = slipOf(scriptOf(step("walls"), "published", 1.0, {{"right", 1e5}}), 800, 2600);
    QVERIFY2(std::abs(against - 1.1) < 0.05, qPrintable(QString::number(against)));
    QVERIFY2(against > 2.0 * free, qPrintable(QString::number(free)));
}

void WalkingCompany::pushesConserveMomentum()
{
    QFETCH(QString, method);
    for (double h : {1.0, 0.25}) {
        const sim::Script script = inTheAir(method.toStdString(), 0.0, h);
        for (int frames : {1, 10, 50, 200})
            QVERIFY(sim::length(momentumOf(stateAfter(script, frames)) - sim::Vec2{-1, 1}) < 1e-10);
    }
}

/// Without the reaction force, momentum changes. So the test above can fail.
void WalkingCompany::oneSidedPushCreatesMomentum()
{
    QFETCH(QString, method);
    const sim::State state = stateAfter(inTheAir(method.toStdString(), 1.0), 10);
    QVERIFY(sim::length(momentumOf(state) - sim::Vec2{-1, 1}) > 1.0);
}

void WalkingCompany::pushesSumToZeroUnlessOneSided()
{
    const lessons::Measure &sum = step("company").measures.back();
    for (const auto &[feltBy, adds] : {std::pair{0.0, false}, {1.0, true}}) {
        sim::Script script = inTheAir("published", feltBy);
        const sim::Scene scene = sim::sceneOf(script, script.values);
        const double total = sum.of(scene, scene.start, nullptr, script.values);
        QVERIFY(adds ? total > 1.0 : total < 1e-12);
    }
}

void WalkingCompany::draggedCreaturePushesTheOther()
{
    sim::Script script = scriptOf(step("company"), "published", 1.0, {{"speed", 0.0}});
    const double before = stateAfter(script, 200).positionOf(5).x;
    script.input = {{50, sim::Grab{"creature0.body"}}};
    for (int i = 0; i <= 100; ++i)
        script.input.push_back({60 + i, sim::Move{{170.0 + 2.0 * i, 320.0}}});
    QVERIFY(stateAfter(script, 200).positionOf(5).x > before + 20.0);
}

/// With default values, bodies of 30 px never overlap, and the creatures pass each other.
void WalkingCompany::creaturesDoNotOverlapAndPassEachOther()
{
    sim::Track track(step("company").script(), 0);
    double minDistance = INFINITY;
    int passed = 0;
    for (int frame = 1; frame <= 2000; ++frame) {
        const bool firstIsLeft = track.state().positionOf(2).x < track.state().positionOf(5).x;
        track.seek({frame, 0});
        minDistance =
            std::min(minDistance, sim::length(track.state().positionOf(2) - track.state().positionOf(5)));
        passed += (track.state().positionOf(2).x < track.state().positionOf(5).x) != firstIsLeft;
    }
    QVERIFY2(minDistance > 30.0 && minDistance < 60.0, qPrintable(QString::number(minDistance)));
    QVERIFY(passed >= 2);
}

void WalkingCompany::pointsAreOrderedByCreature()
{
    sim::Values values = step("company").defaultValues();
    const sim::Scene two = step("company").scene(values);
    QCOMPARE(two.names, (std::vector<std::string>{"creature0.foot0", "creature0.foot1", "creature0.body",
                                                  "creature1.foot0", "creature1.foot1", "creature1.body"}));
    values.set("creatures", 5.0);
    const sim::Scene five = step("company").scene(values);
    QCOMPARE(five.names.size(), std::size_t{15});
    QCOMPARE(five.start.gait.rows(), Eigen::Index{5});
    const lessons::View view = step("company").view(five, values);
    QCOMPARE(view.legs.size(), std::size_t{10});
    for (const lessons::LegView &leg : view.legs)
        QVERIFY(leg.from / 3 == leg.to / 3 && leg.from % 3 == 2);
}

void WalkingCompany::fiveCreaturesStayInTheRoom()
{
    const sim::Script script = scriptOf(step("company"), "published", 1.0, {{"creatures", 5.0}});
    sim::Track track(script, 0);
    for (int frame = 0; frame <= 3000; frame += 10) {
        track.seek({frame, 0});
        const auto x = track.state().position.col(0), y = track.state().position.col(1);
        QVERIFY(x.minCoeff() >= 20.0 && x.maxCoeff() <= 520.0);
        QVERIFY(y.minCoeff() > 150.0 && y.maxCoeff() <= 400.0);
    }
    QVERIFY(!track.stop());
}

SUITE(tst_walking_company, WalkingCompany)
#include "tst_walking_company.moc"

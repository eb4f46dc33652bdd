#include "lessons/api/view/view.h"
#include "sim/effects/drivers/gust.h"
#include "sim/effects/tree/wind_torque.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/script/script.h"
#include "sim/run/track.h"
#include "sim/scene/scene.h"
#include "tests/lessons/support/support.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>
#include <cmath>
#include <numbers>

using namespace support;

/// The wind of step `real_sway`: gusts that spread outwards, and their torque on branches.
class TreeGusts : public QObject
{
    Q_OBJECT

    const lessons::Step m_step = loadLesson(QStringLiteral("swaying_tree")).step(QStringLiteral("real_sway"));

    sim::Scene sceneOf(const Changes &changes = {}) const
    {
        const sim::Script script = scriptOf(m_step, "semi_implicit_euler", 1.0, changes);
        return sim::sceneOf(script, script.values);
    }

private slots:
    void gustsReachFarBranchesLater_data();
    void gustsReachFarBranchesLater();
    void tailOfAGustFollowsItsFront();
    void windTurnsBranchesByTheirCrossComponent_data();
    void windTurnsBranchesByTheirCrossComponent();
    void twigsBendMoreThanTheTrunk();
};

void TreeGusts::gustsReachFarBranchesLater_data()
{
    QTest::addColumn<double>("speed");
    QTest::addColumn<double>("h");
    for (const double speed : {5.0, 12.0, 40.0}) {
        for (const double h : {0.25, 1.0})
            QTest::addRow("%g px/frame, h = %g", speed, h) << speed << h;
    }
}

/// Tests the wind without springs. The first push on a branch comes in the step in which the front reaches
/// its end.
void TreeGusts::gustsReachFarBranchesLater()
{
    QFETCH(double, speed);
    QFETCH(double, h);
    const sim::Vec2 pointer{20, 250};
    sim::Script script = scriptOf(m_step, "semi_implicit_euler", h, {{"gust_speed", speed}});
    script.effectsOff = {"torsion"};
    script.input = {{1, sim::Pointer{pointer, true}}};
    const sim::Scene scene = sim::sceneOf(script, script.values);
    const lessons::View view = m_step.view(scene, script.values);
    sim::Track run(script, 0);
    std::vector<int> firstPush(scene.names.size(), 0);
    const int frames = static_cast<int>(1500.0 / speed);
    const int phases = run.nextInterval()->pipeline.phasesPerStep();
    for (int step = 1; step <= frames / h; ++step) {
        const int stepsPerOutput = run.nextInterval()->pipeline.step.stepsPerOutput;
        run.seek({step / stepsPerOutput, step % stepsPerOutput * phases});
        for (std::size_t i = 0; i < firstPush.size(); ++i) {
            if (firstPush[i] == 0 && run.state().spin[static_cast<int>(i)] != 0.0)
                firstPush[i] = step;
        }
    }
    // Only the trunk and its first child: later branches have been moved by their parents before the front
    // arrives.
    for (const int i : {0, 1, 2}) {
        const double rad = scene.start.angle[i] * std::numbers::pi / 180.0;
        const double length = view.tree->length[static_cast<std::size_t>(i)];
        const sim::Vec2 end = scene.start.positionOf(i) + length * sim::Vec2{std::cos(rad), std::sin(rad)};
        const double distance = sim::length(end - pointer);
        if (i == 0 || i == 1)
            QVERIFY(std::abs(firstPush[static_cast<std::size_t>(i)] - std::ceil(distance / (speed * h))) <=
                    1.0);
    }
    const int earliest = *std::min_element(firstPush.begin(), firstPush.end());
    const int latest = *std::max_element(firstPush.begin(), firstPush.end());
    QVERIFY(earliest > 0);
    QVERIFY((latest - earliest) * h * speed > 200.0); // the width of the crown
}

void TreeGusts::tailOfAGustFollowsItsFront()
{
    sim::GustExtent gust;
    gust = sim::advanceGust(gust, false, 10.0, 1.0);
    QCOMPARE(gust.front, 0.0);
    for (int frame = 0; frame < 5; ++frame)
        gust = sim::advanceGust(gust, true, 10.0, 1.0);
    for (int frame = 0; frame < 3; ++frame)
        gust = sim::advanceGust(gust, false, 10.0, 1.0);
    QCOMPARE(gust.front, 80.0);
    QCOMPARE(gust.tail, 30.0);
    for (const auto &[distance, blows] : {std::pair{20.0, false}, {50.0, true}, {79.0, true}, {90.0, false}})
        QCOMPARE(sim::gustAt(distance, gust, 0.5) > 0.0, blows);
    gust = sim::advanceGust(gust, true, 10.0, 1.0); // a new gust
    QCOMPARE(gust.front, 10.0);
    QCOMPARE(gust.tail, 0.0);
}

void TreeGusts::windTurnsBranchesByTheirCrossComponent_data()
{
    QTest::addColumn<double>("wind"); // degrees, direction of the wind
    QTest::addColumn<double>("turn"); // torque on an upright branch, relative to wind across it
    QTest::newRow("to the right: clockwise") << 0.0 << 1.0;
    QTest::newRow("to the left: counter-clockwise") << 180.0 << -1.0;
    QTest::newRow("along") << -90.0 << 0.0;
    QTest::newRow("half across") << -60.0 << 0.5;
}

void TreeGusts::windTurnsBranchesByTheirCrossComponent()
{
    QFETCH(double, wind);
    QFETCH(double, turn);
    const double rad = wind * std::numbers::pi / 180.0;
    const sim::WindPush push =
        sim::windPush({std::cos(rad), std::sin(rad)}, {0, -1}, 200.0, 5.0, 1.0, 1.0, 2.0);
    QVERIFY(std::abs(push.turn - turn) < 1e-12);
    QVERIFY(std::abs(push.pull - 5.0 / 200.0 * 180.0 / std::numbers::pi * turn / 2.0) < 1e-12);
}

void TreeGusts::twigsBendMoreThanTheTrunk()
{
    sim::Script script = m_step.script();
    script.input = {{1, sim::Pointer{{60, 250}, true}}};
    const Eigen::ArrayXd bend = stateAfter(script, 300).angle - sceneOf().start.angle;
    QVERIFY(bend[0] > 1.0); // away from the pointer, to the right
    QVERIFY(bend.tail(128).mean() > 2.0 * bend[0]);
}

SUITE(tst_tree_gusts, TreeGusts)
#include "tst_tree_gusts.moc"

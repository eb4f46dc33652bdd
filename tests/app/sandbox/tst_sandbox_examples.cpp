// The example scenes of the sandbox: each behaves as intended.

#include "app/model/experiment/experiment.h"
#include "lessons/api/view/view.h"
#include "sim/analysis/energy/stored_energy.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"
#include "tests/app/experiment/experiment_support.h"
#include "tests/suite.h"

#include <QDir>
#include <QTest>

#include <algorithm>
#include <cmath>

using namespace app;

namespace {

constexpr std::int64_t longRun = 10'000; ///< frames

const lessons::Step &sandbox()
{
    return experiment_support::library().sandboxes.front().steps.front();
}

Experiment example(const QString &name)
{
    return readExperiment(QStringLiteral(":/examples/sandbox/%1.json").arg(name),
                          experiment_support::library());
}

/// A run of an example, and its points by name.
struct Run
{
    explicit Run(const QString &name) : track(example(name).script, std::size_t{1} << 20) {}

    const sim::Scene &scene() const { return track.interval().scene; }
    sim::Vec2 at(const char *point) const { return track.state().positionOf(scene().find(point)); }
    void to(std::int64_t frame) { track.seek({frame, 0}); }
    double fastest() const { return track.state().velocity.matrix().rowwise().norm().maxCoeff(); }
    double energy() const
    {
        const sim::StoredEnergyReader reader(scene());
        return reader.read(track.state()).total();
    }
    /// Returns the largest relative error of a stick's length.
    double worstStick() const
    {
        double worst = 0.0;
        for (const sim::BlueprintStick &stick : track.script().values.blueprint->sticks) {
            const double is =
                sim::length(track.state().positionOf(stick.a) - track.state().positionOf(stick.b));
            worst = std::max(worst, std::abs(is / stick.length - 1.0));
        }
        return worst;
    }

    sim::Track track;
};

}

class SandboxExamples : public QObject
{
    Q_OBJECT

private slots:
    void jellyIsDrawnAsSoftMatter()
    {
        const Run jelly("jelly"); // 6 by 5 points
        const lessons::View view = sandbox().view(jelly.scene(), jelly.track.script().values);
        QCOMPARE(view.sheets.size(), std::size_t{5 * 4});
        using Part = lessons::SpringView::Part;
        const auto count = [&](Part part) {
            return std::count_if(view.springs.begin(), view.springs.end(),
                                 [part](const lessons::SpringView &spring) { return spring.part == part; });
        };
        QCOMPARE(count(Part::edge), 2 * (5 + 4));
        QCOMPARE(count(Part::inside), 2 * 5 * 4 + 5 * 3 + 4 * 4); // across, and between two patches
        QCOMPARE(count(Part::alone), 0);
    }
    void springsThatCrossNoneAreCoils()
    {
        const Run wheel("wheel");
        const lessons::View view = sandbox().view(wheel.scene(), wheel.track.script().values);
        QVERIFY(!view.springs.empty());
        for (const lessons::SpringView &spring : view.springs)
            QCOMPARE(spring.part, lessons::SpringView::Part::alone);
    }
    void steadyWindLetsASceneRest_data()
    {
        QTest::addColumn<double>("gusts");
        QTest::newRow("steady") << 0.0;
        QTest::newRow("in gusts") << 0.5;
    }
    void steadyWindLetsASceneRest()
    {
        QFETCH(double, gusts);
        sim::Blueprint plan;
        plan.points = {{"nail", {200, 100}, {}, 1.0, 5.0, true}, {"ball", {200, 160}, {}, 1.0, 10.0, false}};
        plan.springs = {{0, 1, 0.2, 50.0}};
        plan.effects = {"gravity", "breeze", "damping"};
        sim::Script script = newExperiment("sandbox", "build", experiment_support::library()).script;
        script.values.blueprint = std::make_shared<const sim::Blueprint>(plan);
        script.values.set("wind", 0.3);
        script.values.set("gusts", gusts);
        script.values.set("damp", 0.8);
        sim::Track track(std::move(script), std::size_t{1} << 20);
        track.seek({longRun, 0});
        QVERIFY(track.state().positionOf(1).x > 201.0); // the wind has carried it
        QCOMPARE(track.sleep() != nullptr, gusts == 0.0);
    }

    void everyExampleIsInTheList()
    {
        QCOMPARE(experiment_support::library().sandboxes.size(), std::size_t(1));
        QCOMPARE(sandbox().examples.size(),
                 std::size_t(QDir(":/examples/sandbox").entryList(QDir::Files).size()));
        for (const lessons::Example &one : sandbox().examples)
            QVERIFY2(!one.title.isEmpty() && !one.help.isEmpty(), qPrintable(one.file));
    }

    void eachStaysFiniteAndInBounds_data()
    {
        QTest::addColumn<QString>("file");
        for (const lessons::Example &one : sandbox().examples)
            QTest::newRow(qPrintable(one.title)) << one.file;
    }
    void eachStaysFiniteAndInBounds()
    {
        QFETCH(QString, file);
        const Experiment experiment = readExperiment(file, experiment_support::library());
        sim::Track track(experiment.script, std::size_t{1} << 20);
        for (std::int64_t frame = 0; frame <= longRun; frame += 250) {
            track.seek({frame, 0});
            QVERIFY(!track.stop());
            QVERIFY(track.state().position.allFinite());
            QVERIFY2(track.state().position.abs().maxCoeff() < 1500.0, qPrintable(QString::number(frame)));
        }
    }

    void scenesWithoutADriverGainNoEnergy_data()
    {
        QTest::addColumn<QString>("name");
        for (const char *name : {"chain", "bridge", "jelly", "cradle", "ragdoll", "trampoline"})
            QTest::newRow(name) << QString::fromLatin1(name);
    }
    void scenesWithoutADriverGainNoEnergy()
    {
        QFETCH(QString, name);
        Run run(name);
        const double start = run.energy();
        // The potential energy of the fall is the scale of the tolerance.
        const double scale = std::abs(start) + 1.0;
        for (std::int64_t frame = 0; frame <= 2000; frame += 10) {
            run.to(frame);
            QVERIFY2(run.energy() <= start + 0.002 * scale,
                     qPrintable(QStringLiteral("frame %1: %2 > %3").arg(frame).arg(run.energy()).arg(start)));
        }
    }

    void theChainHangsStraight()
    {
        Run run("chain");
        run.to(longRun);
        QVERIFY(run.fastest() < 0.01);
        QVERIFY(std::abs(run.at("p7").x - 270.0) < 0.1);
        QVERIFY(std::abs(run.at("p7").y - 270.0) < 1.0); // 7 sticks of 30 px below the nail at 60
        QVERIFY(run.worstStick() < 0.01);
    }

    void theBridgeCarriesItsLoad()
    {
        Run run("bridge");
        run.to(longRun);
        QVERIFY(run.fastest() < 1e-3);
        QVERIFY(run.at("p4").y > 231.0); // it sags
        QVERIFY(run.at("p4").y < 260.0); // and no more
        // The load hangs on its spring: stretched by m g / k.
        QVERIFY(std::abs(run.at("p17").y - run.at("p4").y - (50.0 + 2.0 * 0.08 / 0.1)) < 0.01);
    }

    void theJellyComesToRestOnTheFloor()
    {
        Run run("jelly");
        run.to(longRun);
        double lowest = 0.0;
        for (int i = 0; i < run.track.state().pointCount(); ++i)
            lowest = std::max(lowest, run.track.state().positionOf(i).y);
        QVERIFY(std::abs(lowest - 375.0) < 0.5); // the floor less half a point
        QVERIFY(run.fastest() < 0.2);
        // It kept its shape: its width is nearly the same.
        QVERIFY(std::abs(sim::length(run.at("p0") - run.at("p5")) - 150.0) < 20.0);
    }

    void theWalkerWalksAndTurnsRound()
    {
        Run run("walker");
        double left = 270.0, right = 270.0;
        for (std::int64_t frame = 0; frame <= 2000; frame += 5) {
            run.to(frame);
            left = std::min(left, run.at("body").x);
            right = std::max(right, run.at("body").x);
            QVERIFY(run.at("body").y < 380.0); // above the ground
        }
        QVERIFY(left < -100.0 && left > -260.0);
        QVERIFY(right > 640.0 && right < 800.0);
    }

    void walkersLegsKeepTheirPhase()
    {
        Run run("walker");
        for (std::int64_t frame = 0; frame <= 4000; frame += 5) {
            run.to(frame);
            const sim::State &now = run.track.state();
            QCOMPARE(now.gaitSpeed[1], now.gaitSpeed[0]); // it turns round with all legs
            QVERIFY(std::abs(now.gait[1] - now.gait[0] - 1.5708) < 1e-9);
        }
    }

    void theCradlePassesItsPushOn()
    {
        Run run("cradle");
        const double drop = std::abs(run.at("p1").x - 208.0);
        double out = 0.0;
        const std::vector<std::pair<const char *, double>> inner = {
            {"p3", 239.0}, {"p5", 270.0}, {"p7", 301.0}};
        for (std::int64_t frame = 45; frame <= 100; ++frame) {
            run.to(frame);
            out = std::max(out, run.at("p9").x - 332.0);
            for (const auto &[ball, home] : inner)
                QVERIFY(std::abs(run.at(ball).x - home) < 12.0);
        }
        QVERIFY(out > 0.9 * drop);
    }

    void theWheelRollsAndStaysRound()
    {
        Run run("wheel");
        run.to(60);
        QVERIFY(run.at("p0").x > 220.0);
        for (std::int64_t frame = 60; frame <= 1000; frame += 20) {
            run.to(frame);
            const sim::Vec2 hub = run.at("p0");
            for (int i = 1; i <= 14; ++i) {
                const double away = sim::length(run.track.state().positionOf(i) - hub);
                QVERIFY2(away > 35.0 && away < 85.0,
                         qPrintable(QStringLiteral("%1: %2").arg(frame).arg(away)));
            }
        }
        QVERIFY(run.worstStick() < 0.05);
    }

    void theClothHangsFromItsNails()
    {
        Run run("cloth");
        run.to(3000);
        for (const char *nail : {"p0", "p5", "p10"})
            QCOMPARE(run.at(nail).y, 60.0);
        QVERIFY(run.at("p2").y > 65.0);             // between them it sags
        QVERIFY(run.at("p82").y > 60.0 + 7 * 26.0); // the lowest row is stretched by its weight
        QVERIFY(run.at("p82").x > 270.0);           // and blown to the right
    }

    void theTreeSwaysInTheWind()
    {
        Run run("tree");
        run.to(1000);
        double least = 1e9, most = -1e9;
        for (std::int64_t frame = 1000; frame <= 1500; frame += 5) {
            run.to(frame);
            least = std::min(least, run.at("p12").x);
            most = std::max(most, run.at("p12").x);
            QVERIFY(run.at("p12").y < 200.0); // it stands
        }
        QVERIFY(least > 270.0); // the wind blows to the right
        QVERIFY(most - least > 5.0);
    }

    void theRagdollLiesStill()
    {
        Run run("ragdoll");
        run.to(longRun);
        QVERIFY(run.fastest() < 0.05);
        // The room is enforced last in a frame. Points on the floor carry the weight above them as an error of their
        // sticks (1.2 px of 44), however often they are enforced before.
        QVERIFY(run.worstStick() < 0.04);
        for (int i = 0; i < run.track.state().pointCount(); ++i)
            QVERIFY(run.track.state().positionOf(i).y > 300.0);
    }

    void theTrampolineCatchesTheBall()
    {
        Run run("trampoline");
        double deepest = 0.0, highest = 1e9;
        bool wasDeep = false;
        for (std::int64_t frame = 0; frame <= 600; ++frame) {
            run.to(frame);
            const double y = run.at("p17").y;
            deepest = std::max(deepest, y);
            wasDeep = wasDeep || y > 290.0;
            if (wasDeep)
                highest = std::min(highest, y);
        }
        QVERIFY(deepest > 290.0 && deepest < 362.0); // it never comes to the floor
        QVERIFY(highest < 250.0);                    // it is thrown up again
        run.to(longRun);
        QVERIFY(run.fastest() < 0.5);
        QVERIFY(run.at("p17").y < 362.0);
    }
};

SUITE(tst_sandbox_examples, SandboxExamples)
#include "tst_sandbox_examples.moc"

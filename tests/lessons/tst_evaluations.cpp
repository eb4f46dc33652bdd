#include "tests/lessons/support/support.h"

#include "sim/analysis/cost/affected_points.h"
#include "sim/analysis/cost/cost.h"
#include "sim/analysis/cost/instrumented_effect.h"
#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/run/track.h"
#include "tests/suite.h"

#include <QTest>

#include <cmath>
#include <map>

using namespace support;

namespace {

/// How often a method computes each kind of effect in one step. Taken from textbooks and the tutorials, not
/// from the implementation.
struct Stages
{
    int forces = 1;
    int drags = 1;         ///< with a damping rate; twice where a symmetric step applies two halves
    int flows = 1;         ///< drivers that advance with time
    bool hasDecay = false; ///< whether the equations of the method contain the damping rates
};

const std::map<std::string, Stages> &stagesByMethod()
{
    static const std::map<std::string, Stages> all = {
        {"published", {1, 1, 1, false}},
        {"semi_implicit_euler", {1, 1, 1, false}},
        {"explicit_euler", {1, 1, 1, false}},
        {"position_verlet", {1, 2, 2, false}},
        {"velocity_verlet", {2, 2, 1, false}},
        {"midpoint", {2, 0, 2, true}},
        {"rk4", {4, 0, 4, true}},
    };
    return all;
}

/// A script whose effects count their calls.
struct CountedScript
{
    explicit CountedScript(sim::Script original) : script(std::move(original))
    {
        const sim::Scene plain = sim::sceneOf(script, script.values);
        effects = plain.effects;
        for (const sim::EffectPtr &effect : effects)
            counters.push_back(std::make_unique<sim::CallCounter>(sim::affectedPoints(*effect, plain.start)));
        script.build = [this, build = script.build](const sim::Values &values) {
            sim::Scene scene = build(values);
            for (std::size_t i = 0; i < scene.effects.size(); ++i)
                scene.effects[i] = sim::instrumented(scene.effects[i], *counters[i]);
            return scene;
        };
    }

    sim::Script script;
    std::vector<sim::EffectPtr> effects;
    std::vector<std::unique_ptr<sim::CallCounter>> counters;
};

bool anyPointMovesByVelocity(const sim::Scene &scene)
{
    for (int i = 0; i < scene.start.pointCount(); ++i) {
        if (scene.start.isDynamic(i) && scene.movesByVelocity(i))
            return true;
    }
    return false;
}

/// Returns how often one step of a method with fixed stages computes `effect`.
int expectedEvaluations(const sim::Effect &effect, const Stages &stages, const sim::Scene &scene)
{
    if (effect.isIdle() || effect.count(scene.start, {0, scene.start.pointCount()}) == 0)
        return 0;
    if (dynamic_cast<const sim::Force *>(&effect) || dynamic_cast<const sim::Torque *>(&effect))
        return stages.forces;
    if (const auto *drag = dynamic_cast<const sim::Drag *>(&effect))
        return drag->dampingRate(0) || !stages.hasDecay ? stages.drags : 1;
    const auto *driver = dynamic_cast<const sim::Driver *>(&effect);
    if (!driver || driver->timing() == sim::DriverTiming::impulsive)
        return 1;
    return stages.hasDecay && !anyPointMovesByVelocity(scene) ? 1 : stages.flows;
}

}

/// Tests how often each effect is computed, for all lesson steps with all compatible methods.
class Evaluations : public QObject
{
    Q_OBJECT

    static constexpr int frames = 6;

    static void addRows(const std::function<bool(const sim::Method &)> &accept)
    {
        addStepAndMethodRows([&](const lessons::Step &step, const sim::Method &method) {
            return accept(method) && fits(step, method);
        });
    }

    static sim::Script scriptOfRow()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, id);
        QFETCH(QString, method);
        return scriptOf(loadLesson(lesson).step(id), method.toStdString(), 1.0);
    }

private slots:
    void effectsAreComputedAtTheStagesOfTheMethod_data()
    {
        addRows([](const sim::Method &method) { return stagesByMethod().count(method.id()) > 0; });
    }
    void effectsAreComputedAtTheStagesOfTheMethod()
    {
        CountedScript counted(scriptOfRow());
        sim::Track track(counted.script, 0, sim::Sleeping::never);
        track.seek({frames, 0});
        QVERIFY(!track.stop());
        const sim::Scene scene = sim::sceneOf(counted.script, counted.script.values);
        const Stages &stages = stagesByMethod().at(counted.script.method->id());
        for (std::size_t i = 0; i < counted.effects.size(); ++i) {
            const sim::Effect &effect = *counted.effects[i];
            const double found = counted.counters[i]->evaluations;
            QVERIFY2(
                std::abs(found - frames * expectedEvaluations(effect, stages, scene)) < 1e-9,
                qPrintable(QString("%1: %2 in %3 frames").arg(effect.id().c_str()).arg(found).arg(frames)));
        }
    }

    /// Adaptive and implicit methods choose their stages. They compute all forces in each, as often as the
    /// run counts.
    void methodsWithVariableStagesComputeAllForces_data()
    {
        addRows([](const sim::Method &method) { return method.evaluationsPerStep() == 0; });
    }
    void methodsWithVariableStagesComputeAllForces()
    {
        CountedScript counted(scriptOfRow());
        sim::Track track(counted.script, 0, sim::Sleeping::never);
        track.seek({frames, 0});
        const sim::Scene scene = sim::sceneOf(counted.script, counted.script.values);
        for (std::size_t i = 0; i < counted.effects.size() && !track.stop(); ++i) {
            const sim::Effect &effect = *counted.effects[i];
            const bool isForce =
                dynamic_cast<const sim::Force *>(&effect) || dynamic_cast<const sim::Torque *>(&effect);
            const bool acts =
                !effect.isIdle() && effect.count(scene.start, {0, scene.start.pointCount()}) > 0;
            const double found = counted.counters[i]->evaluations;
            if (isForce && acts)
                QCOMPARE(found, track.state().forceEvaluations());
            else if (!acts)
                QCOMPARE(found, 0.0);
            else if (dynamic_cast<const sim::Drag *>(&effect))
                QCOMPARE(found, 0.0); // its damping rate is in the equations
        }
    }

    /// CostMeter reports the counted evaluations.
    void costMeterReportsCountedEvaluations_data()
    {
        addRows([](const sim::Method &) { return true; });
    }
    void costMeterReportsCountedEvaluations()
    {
        const sim::Script script = scriptOfRow();
        const sim::Scene scene = sim::sceneOf(script, script.values);
        sim::CostMeter meter(scene, script.method, script.step, scene.start);
        QVERIFY(meter.round());
        const sim::FrameCost cost = meter.result();
        QCOMPARE(cost.rounds, 1);
        QCOMPARE(cost.effects.size() + meter.pipeline().idleEffects.size(), scene.effects.size());
        const auto stages = stagesByMethod().find(script.method->id());
        for (const sim::EffectCost &effectCost : cost.effects) {
            QVERIFY(std::isfinite(effectCost.ns));
            QVERIFY(effectCost.points >= 0 && effectCost.points <= scene.start.pointCount());
            if (stages != stagesByMethod().end())
                QVERIFY2(
                    std::abs(effectCost.evaluations -
                             expectedEvaluations(*effectCost.effect, stages->second, scene)) < 1e-9,
                    qPrintable(
                        QString("%1: %2").arg(effectCost.effect->id().c_str()).arg(effectCost.evaluations)));
        }
    }
};

SUITE(tst_evaluations, Evaluations)
#include "tst_evaluations.moc"

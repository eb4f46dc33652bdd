#include "sim/run/script/script.h"
#include "tests/lessons/support/support.h"

#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/run_step.h"
#include "sim/run/finite.h"
#include "sim/scene/islands.h"
#include "tests/suite.h"

#include <QTest>

#include <algorithm>

using namespace support;

namespace {

/// Composes `script` with one cache block per island. A scene with a single island gets one block with all
/// kernels.
sim::Pipeline islandByIsland(const sim::Scene &scene, const sim::Script &script)
{
    sim::Pipeline pipeline = sim::compose(scene, *script.method, script.step);
    pipeline.blocks = sim::cacheBlocksOf(scene, pipeline.phases, {1, 1});
    if (pipeline.blocks.empty()) {
        pipeline.blocks.push_back({{{0, scene.start.pointCount()}}, {}});
        for (const sim::StepKernel &step : pipeline.kernels)
            pipeline.blocks[0].work.push_back(step.kernel.prepareFor({step.points}));
    }
    return pipeline;
}

}

/// Tests that lessons give the same bits island by island as phase by phase.
class LessonsInBlocks : public QObject
{
    Q_OBJECT

private slots:
    void blocksGiveTheSameBits_data() { addStepAndMethodRows(isDivisible); }
    void blocksGiveTheSameBits()
    {
        QFETCH(QString, lesson);
        QFETCH(QString, id);
        QFETCH(QString, method);
        const sim::Script script = scriptOf(loadLesson(lesson).step(id), method.toStdString(), 1.0);
        const sim::Scene scene = sim::sceneOf(script, script.values);
        const sim::Pipeline pipeline = islandByIsland(scene, script);
        sim::State plain = scene.start;
        sim::State inBlocks = plain;
        sim::ThreadPool pool(2);
        for (std::int64_t frame = 1; frame <= 1000; ++frame) {
            for (sim::State *state : {&plain, &inBlocks}) {
                state->frame = frame;
                if (frame == 300) // the first point is held for a while
                    state->inverseMass[0] = 0.0;
                if (frame == 400)
                    state->inverseMass[0] = scene.start.inverseMass[0];
            }
            for (const sim::Phase &phase : pipeline.phases)
                phase.run(plain);
            sim::runStep(pipeline, inBlocks, pool);
            const sim::PointRange all = {0, scene.start.pointCount()};
            if (!sim::areFinite(plain, all)) { // a run ends here; IEEE 754 leaves the bits of NaN open
                QVERIFY2(!sim::areFinite(inBlocks, all), qPrintable(QString::number(frame)));
                return;
            }
            if (frame % 10 == 0)
                QVERIFY2(sim::sameBits(plain, inBlocks), qPrintable(QString::number(frame)));
        }
    }

private:
    /// Returns whether every phase of `step` with `method` can compute a part of its points.
    static bool isDivisible(const lessons::Step &step, const sim::Method &method)
    {
        try {
            const sim::Script script = scriptOf(step, method.id(), 1.0);
            const sim::Scene scene = sim::sceneOf(script, script.values);
            const sim::Pipeline pipeline = sim::compose(scene, method, script.step);
            return std::all_of(pipeline.phases.begin(), pipeline.phases.end(), [](const sim::Phase &phase) {
                return std::all_of(phase.kernels.begin(), phase.kernels.end(),
                                   [](const sim::Kernel &kernel) { return kernel.prepareFor != nullptr; });
            });
        } catch (const sim::Error &) {
            return false; // step and method are incompatible
        }
    }
};

SUITE(tst_lessons_in_blocks, LessonsInBlocks)
#include "tst_lessons_in_blocks.moc"

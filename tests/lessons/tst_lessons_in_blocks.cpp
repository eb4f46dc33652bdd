#include "sim/run/script/script.h"
#include "tests/lessons/support.h"

#include "sim/base/error.h"
#include "sim/methods/methods.h"
#include "sim/pipeline/run_step.h"
#include "sim/scene/islands.h"

#include <QTest>

#include <algorithm>

using namespace support;

namespace {

/// `script`, composed, with a block for each island; for a scene of one island, which is computed kernel by kernel, one
/// block with all of them.
sim::Pipeline islandByIsland(const sim::Scene &scene, const sim::Script &script)
{
    sim::Pipeline pipeline = sim::compose(scene, *script.method, script.step);
    pipeline.blocks = sim::cacheBlocksOf(scene, pipeline.phases, {1, 1});
    if (pipeline.blocks.empty()) {
        pipeline.blocks.push_back({{{0, scene.start.pointCount()}}, {}});
        for (const sim::StepKernel &one : pipeline.kernels)
            pipeline.blocks[0].work.push_back(one.kernel.prepareFor({one.points}));
    }
    return pipeline;
}

}

/// Every lesson computed island by island: the same as phase by phase.
class InBlocks : public QObject
{
    Q_OBJECT

private slots:
    void everyLessonComesToTheSameBits_data()
    {
        QTest::addColumn<QString>("lesson");
        QTest::addColumn<QString>("id");
        QTest::addColumn<QString>("method");
        for (const QString &lesson : lessonIds()) {
            for (const lessons::Step &step : loadLesson(lesson).steps) {
                for (const sim::MethodPtr &method : sim::allMethods()) {
                    if (divides(step, *method))
                        QTest::addRow("%s/%s by %s", qPrintable(lesson), qPrintable(step.id),
                                      method->id().c_str())
                            << lesson << step.id << QString::fromStdString(method->id());
                }
            }
        }
    }
    void everyLessonComesToTheSameBits()
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
                if (frame == 300) // a hand holds the first point for a while
                    state->inverseMass[0] = 0.0;
                if (frame == 400)
                    state->inverseMass[0] = scene.start.inverseMass[0];
            }
            for (const sim::Phase &phase : pipeline.phases)
                phase.run(plain);
            sim::runStep(pipeline, inBlocks, pool);
            if (frame % 100 == 0)
                QVERIFY2(sim::sameBits(plain, inBlocks), qPrintable(QString::number(frame)));
        }
    }

private:
    /// Whether every phase of `step` by `method` can do a part of its points.
    static bool divides(const lessons::Step &step, const sim::Method &method)
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
            return false; // they do not fit
        }
    }
};

QTEST_GUILESS_MAIN(InBlocks)
#include "tst_lessons_in_blocks.moc"

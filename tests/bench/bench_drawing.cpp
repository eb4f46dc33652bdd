// What painting a tree costs: the whole scene view, 1280 x 800 px, into an image. Time between two pictures is not
// in it, only painting.

#include "tests/app/look_scenes.h"
#include "tests/app/scene_bench.h"

#include <QApplication>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

namespace {

/// A tree of 2^(forks + 1) - 1 branches, `percent` of its size at first; another moment of its sway each time.
void paintTree(benchmark::State &bench, int forks, double enlarged)
{
    look_scenes::Tree tree = look_scenes::tree(forks);
    look_scenes::letSway(tree);
    SceneBench scene({look_scenes::step("tree", tree.scene, tree.look)});
    scene.view.resize(1280, 800);
    for (; enlarged > 1.0; enlarged /= 1.25)
        scene.view.zoomIn();
    for (; enlarged < 1.0; enlarged *= 1.25)
        scene.view.zoomOut();
    QImage image(1280, 800, QImage::Format_RGB32);
    for (auto _ : bench) {
        bench.PauseTiming();
        scene.session.frameForward();
        bench.ResumeTiming();
        scene.view.viewport()->render(&image);
    }
    bench.counters["branches"] = static_cast<double>(tree.scene.start.points());
}

void paintWholeTree(benchmark::State &bench)
{
    paintTree(bench, static_cast<int>(bench.range(0)), 1.0);
}

void paintNearTree(benchmark::State &bench)
{
    paintTree(bench, static_cast<int>(bench.range(0)), 4.0);
}

void paintFarTree(benchmark::State &bench)
{
    paintTree(bench, static_cast<int>(bench.range(0)), 0.25);
}

/// The same view with nothing in it but the sky.
void paintSky(benchmark::State &bench)
{
    paintTree(bench, 0, 1.0);
}

BENCHMARK(paintSky)->Unit(benchmark::kMillisecond);
BENCHMARK(paintWholeTree)->Arg(7)->Arg(11)->Arg(12)->Arg(13)->Arg(14)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK(paintNearTree)->Arg(14)->Arg(16)->Unit(benchmark::kMillisecond);
BENCHMARK(paintFarTree)->Arg(14)->Arg(16)->Unit(benchmark::kMillisecond);

}

int main(int argc, char **argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    QTemporaryDir settings;
    useOwnSettings(settings);
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}

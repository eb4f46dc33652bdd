// The cost of painting the whole scene view, 1280 x 800 px, into an image. Time between two repaints does not
// count. Each row also has percentiles of the frame times in ms; 16.7 is 60 pictures a second. All times are
// processor time, which does not depend on the load of the machine.

#include "lessons/api/creature.h"
#include "lessons/api/view/creature_view.h"
#include "sim/base/cpu_clock.h"
#include "sim/base/random.h"
#include "sim/effects/contacts/walls.h"
#include "sim/effects/drags/damping.h"
#include "sim/effects/fields/gravity.h"
#include "sim/effects/springs/radial_spring.h"
#include "tests/app/scene/drawn_scenes.h"
#include "tests/app/scene/scene_support.h"

#include <QApplication>
#include <QSettings>
#include <QTemporaryDir>

#include <benchmark/benchmark.h>

#include <algorithm>
#include <cmath>

namespace {

constexpr int pictures = 200; ///< per row

/// Paints the view as often as the row asks, at another moment each time, and reports the times.
void paint(benchmark::State &bench, SceneFixture &scene)
{
    QImage image(1280, 800, QImage::Format_RGB32);
    std::vector<double> times; // ms
    for (auto _ : bench) {
        scene.session.playback().frameForward();
        const double start = sim::threadCpuSeconds();
        scene.view.viewport()->render(&image);
        const double took = sim::threadCpuSeconds() - start;
        bench.SetIterationTime(took);
        times.push_back(1e3 * took);
    }
    std::sort(times.begin(), times.end());
    const auto percentile = [&](double share) {
        return times[static_cast<std::size_t>(std::lround(share * static_cast<double>(times.size() - 1)))];
    };
    bench.counters["p50"] = percentile(0.5);
    bench.counters["p90"] = percentile(0.9);
    bench.counters["p99"] = percentile(0.99);
    bench.counters["max"] = times.back();
}

/// Paints a tree of 2^(forks + 1) - 1 branches, `enlarged` times its first size, at another moment of its
/// sway each time.
void paintTree(benchmark::State &bench, int forks, double enlarged)
{
    drawn_scenes::Tree tree = drawn_scenes::tree(forks);
    drawn_scenes::letSway(tree);
    SceneFixture scene({drawn_scenes::step("tree", tree.scene, tree.view)});
    scene.view.resize(1280, 800);
    for (; enlarged > 1.0; enlarged /= 1.25)
        scene.view.zoomIn();
    for (; enlarged < 1.0; enlarged *= 1.25)
        scene.view.zoomOut();
    paint(bench, scene);
    bench.counters["branches"] = static_cast<double>(tree.scene.start.pointCount());
    bench.SetComplexityN(tree.scene.start.pointCount());
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

/// Paints the same view with only the sky.
void paintSky(benchmark::State &bench)
{
    paintTree(bench, 0, 1.0);
}

/// Paints creatures of six points with legs that fall in one room and fill it. `across`: the width of the
/// view in room widths.
void paintCreatures(benchmark::State &bench, int count, double across)
{
    constexpr int feet = 5;
    const double size = std::max(1.0, std::sqrt(count / 15.0));
    const sim::Room room{270.0 - 250.0 * size, 270.0 + 250.0 * size, 380.0, 1.0};
    sim::Scene scene = scenes::crowdByParts(count, feet);
    for (int i = 0; i < count; ++i) {
        scene.start.place(i, {room.left + 60.0 + (500.0 * size - 120.0) * sim::uniform(1, 0, i),
                              320.0 - (360.0 * size - 120.0) * sim::uniform(1, 1, i)});
        for (int foot = i + count; foot < scene.start.pointCount(); foot += count) {
            const double angle = 2.0 * M_PI * sim::uniform(1, 2, foot);
            scene.start.place(foot,
                              scene.start.positionOf(i) + 50.0 * sim::Vec2{std::cos(angle), std::sin(angle)});
        }
    }
    scenes::add<sim::RadialSpring>(scene, scenes::legsByParts(count, feet), 0.2, 50.0);
    scenes::add<sim::Gravity>(scene, 0.5);
    scenes::add<sim::Damping>(scene, 0.9);
    scenes::add<sim::Walls>(scene, room, scenes::halfWidths(scene));
    lessons::View view = lessons::crowdByPartsView(scene, count);
    view.room = room;
    view.stage = QRectF(room.left, room.floor - 360.0 * size, 500.0 * size, 380.0 * size);
    SceneFixture bed({drawn_scenes::step("creatures", scene, view)});
    bed.view.resize(1280, 800);
    bed.view.fit();
    for (; across < 1.0; across *= 1.25)
        bed.view.zoomIn();
    paint(bench, bed);
    bench.counters["points"] = static_cast<double>(scene.start.pointCount());
    bench.SetComplexityN(count);
}

void paintAllCreatures(benchmark::State &bench)
{
    paintCreatures(bench, static_cast<int>(bench.range(0)), 1.0);
}

void paintNearCreatures(benchmark::State &bench)
{
    paintCreatures(bench, static_cast<int>(bench.range(0)), 0.25);
}

void measured(benchmark::internal::Benchmark *bench)
{
    bench->Unit(benchmark::kMillisecond)->UseManualTime()->Iterations(pictures);
}

BENCHMARK(paintSky)->Apply(measured);
BENCHMARK(paintWholeTree)->Arg(7)->Arg(11)->Arg(12)->Arg(13)->Arg(14)->Arg(16)->Apply(measured)->Complexity();
BENCHMARK(paintNearTree)->Arg(14)->Arg(16)->Apply(measured);
BENCHMARK(paintFarTree)->Arg(14)->Arg(16)->Apply(measured);
BENCHMARK(paintAllCreatures)
    ->Arg(1)
    ->Arg(80)
    ->Arg(200)
    ->Arg(833)
    ->Arg(10'000)
    ->Arg(100'000)
    ->Apply(measured)
    ->Complexity();
BENCHMARK(paintNearCreatures)->Arg(833)->Arg(10'000)->Apply(measured);

}

int main(int argc, char **argv)
{
    qputenv("QT_QPA_PLATFORM", "offscreen");
    QApplication application(argc, argv);
    const QTemporaryDir settings;
    QSettings::setDefaultFormat(QSettings::IniFormat);
    QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, settings.path());
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    benchmark::RunSpecifiedBenchmarks();
    benchmark::Shutdown();
    return 0;
}

#include "tests/app/panels/accuracy_support.h"

#include "sim/methods/methods.h"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <thread>

using namespace app;

namespace accuracy_support {

namespace {

constexpr int rungs = 8;
constexpr double mostExact = 1e-9; ///< px

sim::AccuracyRow rowOf(const sim::MethodPtr &method, int rung, std::size_t number)
{
    const bool adaptive = method->stepping() == sim::Stepping::adaptive;
    sim::AccuracyRow row;
    row.setup.method = method;
    row.setup.step = adaptive ? sim::StepSize::withTolerance(std::pow(10.0, -rung))
                              : sim::StepSize::ofLength(1.0 / (1 << rung));
    row.outcome = sim::Outcome::measured;
    row.error = std::max(mostExact, 4.0 * std::pow(0.5, method->order() * rung));
    row.evaluations = std::pow(2.0, rung);
    row.nsPerFrame = 50.0 * (1.0 + 0.1 * static_cast<double>(number)) * row.evaluations;
    row.spread = 0.02 * row.nsPerFrame;
    for (int frame = 0; frame <= 20; ++frame)
        row.errorAt.push_back(row.error * frame / 20.0);
    return row;
}

}

sim::Accuracy madeUp(const sim::Script &script, const sim::StudyPlan &plan)
{
    sim::Accuracy found;
    found.span = plan.frames;
    found.horizon = plan.frames;
    found.reference.method = "made_up";
    found.reference.disagreement = 2e-11;
    const std::vector<sim::MethodPtr> methods = sim::allMethods();
    for (std::size_t i = 0; i < methods.size(); ++i) {
        for (int rung = 0; rung < rungs; ++rung)
            found.rows.push_back(rowOf(methods[i], rung, i));
    }
    found.rows.front().outcome = sim::Outcome::unstable;
    found.rows.front().nsPerFrame = 0.0;
    const sim::Scene scene = sim::sceneOf(script, script.values);
    for (std::int64_t frame = 0; frame <= found.horizon; ++frame) {
        std::vector<sim::Vec2> places;
        for (int i = 0; i < scene.start.pointCount(); ++i)
            places.push_back(scene.start.positionOf(i) + sim::Vec2{3.0, 4.0});
        found.reference.trajectories.push_back(std::move(places));
    }
    sim::markFront(found.rows);
    return found;
}

StudyFunction madeUpAtOnce()
{
    return [](const sim::Script &script, const sim::StudyPlan &plan, const sim::StudyProgress &) {
        return madeUp(script, plan);
    };
}

StudyFunction Puppet::function()
{
    return [this](const sim::Script &script, const sim::StudyPlan &plan, const sim::StudyProgress &progress) {
        ++begun;
        const sim::Accuracy found = madeUp(script, plan);
        do {
            if (!progress(found, 0.5)) {
                ++stopped;
                return found;
            }
            std::this_thread::sleep_for(std::chrono::milliseconds(1));
        } while (held);
        return found;
    };
}

AccuracyFixture::AccuracyFixture()
{
    panel.setShowsAll(true);
    tests::show(panel, {560, 560});
}

bool AccuracyFixture::measured()
{
    return QTest::qWaitFor([this] { return study.stage() == AccuracyStudy::Stage::done; }, 20'000);
}

QPoint AccuracyFixture::spotOf(const std::string &id, sim::StepSize step)
{
    const auto &rows = study.accuracy()->rows;
    for (const Spot &spot : plot().spots()) {
        if (rows[spot.row].setup.method->id() == id && rows[spot.row].setup.step == step)
            return plot().onScreen(spot).toPoint();
    }
    qFatal("%s has no such spot", id.c_str());
}

}

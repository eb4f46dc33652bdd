#pragma once

#include "app/model/code_listing.h"
#include "app/model/effect_lines.h"
#include "app/ui/effects/effect_list.h"
#include "app/ui/effects/effects_panel.h"
#include "tests/app/effects_bench.h"
#include "tests/app/panels_bench.h"

#include <QToolButton>
#include <QtTest>

#include <atomic>
#include <thread>

/// What the suites of the ledger of effects share: the panel on a made-up meter, and hands for it.
namespace effects_panel_bench {

using namespace app;
using namespace effects_bench;

/// 31.4 ns for a spring, 4.6 ns for anything else, 10 ns for the rest.
inline sim::FrameCost madeUp(const sim::Scene &scene)
{
    sim::FrameCost cost;
    cost.rounds = 9;
    cost.ns = 46.0;
    cost.spread = 2.0;
    cost.restNs = 10.0;
    cost.restSpread = 0.2;
    for (const sim::EffectPtr &effect : scene.effects) {
        const bool isSpring = effect->kind() == sim::EffectKind::spring;
        cost.effects.push_back({effect, 6, 1.0, isSpring ? 31.4 : 4.6, 0.3});
    }
    return cost;
}

/// A meter that is told when to end.
struct Meter
{
    std::atomic<int> begun = 0;
    std::atomic<int> stopped = 0;
    std::atomic<bool> held = false;

    CostFunction function()
    {
        return [this](const CostSubject &about, const sim::ShouldContinue &shouldContinue,
                      const std::function<void(const sim::FrameCost &)> &tell) {
            ++begun;
            do {
                tell(madeUp(about.interval->scene));
                std::this_thread::sleep_for(std::chrono::milliseconds(1));
                if (!shouldContinue()) {
                    ++stopped;
                    return;
                }
            } while (held);
        };
    }
};

struct Bench
{
    Bench()
    {
        show(panel, {620, 320});
        settle();
    }
    Session &session() { return world.session; }
    const sim::Timeline &run() { return world.session.timeline(); }
    bool settle()
    {
        return QTest::qWaitFor([this] { return panel.isSettled(); }, 20'000);
    }
    int row(const QString &id) const
    {
        const auto &lines = panel.list().lines().lines();
        for (std::size_t i = 0; i < lines.size(); ++i) {
            if (lines[i].id == id)
                return static_cast<int>(i);
        }
        return -1;
    }
    EffectLine line(const QString &id) const
    {
        return row(id) < 0 ? EffectLine{} : panel.list().lines().lines()[static_cast<std::size_t>(row(id))];
    }
    QModelIndex index(const QString &id) const { return panel.list().lines().index(row(id)); }
    void clickSwitch(const QString &id)
    {
        const QRect rect = EffectDelegate::switchRect(panel.list().visualRect(index(id)));
        QTest::mouseClick(panel.list().viewport(), Qt::LeftButton, {}, rect.center());
        QCoreApplication::processEvents();
    }
    bool hasPhase(const std::string &id) const
    {
        const auto &phases = world.session.timeline().track().nextInterval()->pipeline.phases;
        return std::any_of(phases.begin(), phases.end(),
                           [&](const sim::Phase &phase) { return phase.id == id; });
    }
    bool showsSource(const QString &file)
    {
        const CodeListing listing =
            listingOf(session().step(), *run().track().nextInterval(), *run().script().method);
        return std::any_of(listing.sections.begin(), listing.sections.end(),
                           [&](const CodeSection &section) { return section.files().contains(file); });
    }

    Meter reader;
    World world{legLibrary()};
    EffectsPanel panel{world.session, world.theme, reader.function()};
};

const char *springFile = "sim/effects/pairs/spring.h";

}

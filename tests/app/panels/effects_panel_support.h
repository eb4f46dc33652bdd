#pragma once

#include "app/model/analysis/effect_lines.h"
#include "app/model/code/code_listing.h"
#include "app/ui/effects/effect_list.h"
#include "app/ui/effects/effects_panel.h"
#include "tests/app/model/effects_support.h"
#include "tests/app/support/panel_fixture.h"

#include <QToolButton>
#include <QtTest>

#include <atomic>
#include <thread>

/// Shared by the suites of the panel of effects: the panel with made-up costs.
namespace effects_panel_support {

using namespace app;
using namespace effects_support;
using namespace tests;

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

/// A measurement that a test can hold up.
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

struct EffectsFixture : SessionFixture
{
    EffectsFixture() : SessionFixture(legLibrary())
    {
        show(panel, {620, 320});
        settle();
    }

    const sim::Timeline &run() { return session.timeline(); }
    /// Waits until all effects are measured. Returns whether that came to an end.
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
        const auto &phases = session.timeline().track().nextInterval()->pipeline.phases;
        return std::any_of(phases.begin(), phases.end(),
                           [&](const sim::Phase &phase) { return phase.id == id; });
    }
    bool showsSource(const QString &file)
    {
        const CodeListing listing =
            listingOf(session.step(), *run().track().nextInterval(), *run().script().method);
        return std::any_of(listing.sections.begin(), listing.sections.end(),
                           [&](const CodeSection &section) { return section.files().contains(file); });
    }

    Meter meter;
    EffectsPanel panel{session.run(), session.editor(), session.playback(), theme, meter.function()};
};

inline const char *springFile = "sim/effects/pairs/spring.h";

}

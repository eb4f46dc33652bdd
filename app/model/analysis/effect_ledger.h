#pragma once

#include "app/model/analysis/cost_monitor.h"
#include "app/model/analysis/effect_lines.h"
#include "app/model/session/run_editor.h"

namespace app {

/// The effects of the open scene with their costs, and the effects that other lessons know. Measures while a view
/// shows it.
class EffectLedger : public QObject
{
    Q_OBJECT

public:
    /// Measures costs on `thread`.
    EffectLedger(const OpenRun &run, RunEditor &editor, const Playback &playback,
                 CostFunction function = measureCost, std::shared_ptr<QThreadPool> thread = makeJobThread(),
                 QObject *parent = nullptr);

    /// Sets whether any view shows the effects.
    void setActive(bool isActive);
    std::vector<EffectLine> lines() const;
    /// Returns "0.0460\u2009µs a frame, ±0.0020, measured now", or the current activity if there are no results yet.
    QString caption() const;
    const CostMonitor &costs() const { return m_costs; }
    CostMonitor &costs() { return m_costs; }
    void switchEffect(const QString &id, bool on);
    /// Returns whether all lessons have reported the effects that they know.
    bool knowsAll() const { return m_knowsAll; }

signals:
    void changed();

private:
    void requestKnownEffects();
    const std::vector<sim::EffectPtr> &listed() const;

    const OpenRun &m_run;
    RunEditor &m_editor;
    const Playback &m_playback;
    CostMonitor m_costs;
    /// All effects of the interval at the cursor. They are cached because a large scene takes time to set up.
    mutable std::vector<sim::EffectPtr> m_listed;
    mutable std::weak_ptr<const sim::ComposedInterval> m_listedIn;
    std::vector<KnownEffect> m_known;
    bool m_knowsAll = false;
    BackgroundJob m_request; ///< for the effects that lessons know
};

}

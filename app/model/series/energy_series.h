#pragma once

#include "app/model/run/idle_task.h"
#include "app/model/series/frame_series.h"
#include "app/model/session/open_run.h"
#include "app/model/session/playback.h"
#include "sim/analysis/energy/ledger.h"

#include <QObject>

namespace app {

/// The energy and momentum balances of the computed output steps, each from a starting frame to its output step. They
/// are counted in slices of a few milliseconds, and only while they are watched. A change of the run makes the affected
/// balances be counted again.
class EnergySeries : public QObject, public FrameSeries<sim::Balance>
{
    Q_OBJECT

public:
    /// The largest number of stored output steps. Longer runs keep the last ones.
    static constexpr std::size_t mostSteps = 20'000;
    /// If the cursor is farther ahead than this, in output steps, counting restarts near it. Counting the whole run
    /// would take too long.
    static constexpr std::int64_t mostAhead = 20'000;
    /// Scenes with more points than this are not counted.
    static constexpr int mostPoints = 20'000;

    explicit EnergySeries(const OpenRun &run, const Playback &playback, QObject *parent = nullptr);

    void setActive(bool isActive);
    const OpenRun &run() const { return m_run; }

    /// Returns the frame at which counting starts.
    std::int64_t start() const { return m_start; }
    /// Returns why the scene at the cursor has no energy to count. Empty if it has.
    std::optional<sim::NoEnergy> whyNot() const { return m_whyNot; }

signals:
    /// Balances were added or dropped, or the reason for their absence has changed.
    void changed();

private:
    static std::optional<sim::NoEnergy> whyNone(const sim::Scene &scene);
    void restartAt(std::int64_t frame);
    void restart() { restartAt(0); }
    void follow(const Change &change);
    void followCursor();
    /// Drops the balances from `frame` on, because the run has changed there.
    void dropFrom(std::int64_t frame);
    void fill() { m_idleTask.run(); }
    /// Counts the next output step. Returns false if there is none.
    bool countNext();

    const OpenRun &m_run;
    const Playback &m_playback;
    sim::Ledger m_ledger;
    IdleTask m_idleTask;
    std::int64_t m_start = 0;
    std::optional<sim::NoEnergy> m_whyNot;
    bool m_isActive = false;
    bool m_stale = true; ///< whether the run has changed since it was last watched
};

}

#pragma once

#include "app/model/jobs/background_job.h"
#include "app/model/session/open_run.h"
#include "app/model/session/playback.h"
#include "sim/analysis/cost/cost.h"

#include <QObject>
#include <QTimer>

#include <functional>

namespace app {

/// The frame to measure: the one that follows a given state.
struct CostSubject
{
    sim::Script script;
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state;
};

/// A function that measures the cost, on another thread. It reports results while it measures, and stops when
/// `shouldContinue` returns false.
/// @throws sim::Error if the scene cannot be computed
using CostFunction = std::function<void(const CostSubject &, const sim::ShouldContinue &shouldContinue,
                                        const std::function<void(const sim::FrameCost &)> &report)>;

/// Runs rounds of a sim::CostMeter for one second, but at least a few rounds.
void measureCost(const CostSubject &subject, const sim::ShouldContinue &shouldContinue,
                 const std::function<void(const sim::FrameCost &)> &report);

/// Measures the cost of the session's next frame on another thread while a view shows it. Each measurement takes one
/// second. It starts after each change of the run, and when playback stops.
class CostMonitor : public QObject
{
    Q_OBJECT

public:
    enum class Stage {
        none,      ///< no results for the present scene
        due,       ///< a measurement will start when the scene stops changing
        measuring, ///< results are arriving
        done,
    };

    /// Measures on `thread`. Measurements that could disturb each other share a thread.
    explicit CostMonitor(const OpenRun &run, const Playback &playback, CostFunction function = measureCost,
                         std::shared_ptr<QThreadPool> thread = makeJobThread(), QObject *parent = nullptr);

    /// Sets whether any view shows the cost.
    void setActive(bool isActive);
    /// Measures the state at the cursor again.
    void measureAgain();

    Stage stage() const;
    /// Returns the cost of the present effects, method and step at frame(); null if nothing was measured.
    const sim::FrameCost *cost() const { return m_cost ? &*m_cost : nullptr; }
    std::int64_t frame() const { return m_subject.frame; }
    /// Returns whether no timer and no thread is active.
    bool isAtRest() const { return !m_settleTimer.isActive() && !m_measurement.isRunning(); }

    static constexpr int settleMilliseconds = 300; ///< a run that changes is not measured before
    static constexpr int mostMilliseconds =
        1000; ///< of one measurement, but the first rounds may take longer
    static constexpr int leastRounds = 5;
    static constexpr int reportMilliseconds = 100; ///< between two reports

signals:
    void changed();

private:
    /// The subject of a measurement.
    struct Subject
    {
        QString step; ///< lesson and step
        sim::Script script;
        std::int64_t frame = 0;
    };

    Subject currentSubject() const;
    void followRun();
    void followPlaying();
    void startLater();
    void start();
    void stop();

    const OpenRun &m_run;
    const Playback &m_playback;
    CostFunction m_function;
    QTimer m_settleTimer;
    Subject m_subject; ///< the subject of m_cost, or of the current measurement
    std::optional<sim::FrameCost> m_cost;
    bool m_isActive = false;
    bool m_isDone = false;
    BackgroundJob m_measurement;
};

}

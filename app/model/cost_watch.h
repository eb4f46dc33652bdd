#pragma once

#include "app/model/session.h"
#include "sim/analysis/cost/cost.h"

#include <QObject>
#include <QThreadPool>
#include <QTimer>

#include <atomic>
#include <functional>

namespace app {

/// The frame that is measured: the next one from a state on.
struct CostSubject
{
    sim::Script script;
    std::shared_ptr<const sim::ComposedInterval> interval;
    sim::State state;
};

/// Who measures: reports what is known after each round, and leaves off when `goesOn` says no. Runs on a thread of its
/// own; throws sim::Error where the scene cannot be computed.
using CostFunction = std::function<void(const CostSubject &, const sim::ShouldContinue &shouldContinue,
                                        const std::function<void(const sim::FrameCost &)> &tell)>;

/// Rounds of a sim::CostMeter, for a second and at least a few.
void measureCost(const CostSubject &subject, const sim::ShouldContinue &shouldContinue,
                 const std::function<void(const sim::FrameCost &)> &tell);

/// What the next frame of the session costs, measured on a thread of its own while somebody watches: for a second after
/// each change of the run and whenever it has stopped playing. Then it rests.
class CostWatch : public QObject
{
    Q_OBJECT

public:
    enum class Stage {
        none,      ///< nothing is known of the scene as it is now
        due,       ///< it will be measured when it has stopped changing
        measuring, ///< rounds come in
        done,
    };

    explicit CostWatch(Session &session, CostFunction function = measureCost, QObject *parent = nullptr);
    /// Stops what is under way and waits for it.
    ~CostWatch() override;

    void setWatched(bool watched);
    /// Measures the state at the cursor anew.
    void measureAgain();

    Stage stage() const;
    /// Of the effects, method and step in use, at frame(); null where nothing was measured.
    const sim::FrameCost *cost() const { return m_cost ? &*m_cost : nullptr; }
    std::int64_t frame() const { return m_about.frame; }
    /// Whether no timer and no thread is busy.
    bool isAtRest() const { return !m_later.isActive() && !m_job; }

    static constexpr int settleMilliseconds = 300; ///< a run that changes is not measured before
    static constexpr int mostMilliseconds = 1000;  ///< of one measurement, but for its first rounds
    static constexpr int leastRounds = 5;
    static constexpr int tellMilliseconds = 100; ///< between two reports

signals:
    void changed();

private:
    struct Job
    {
        std::atomic<bool> stop = false;
    };
    /// What a measurement is about.
    struct About
    {
        QString step; ///< lesson and step
        sim::Script script;
        std::int64_t frame = 0;
    };

    About here() const;
    void follow();
    void followPlaying();
    void startLater();
    void start();
    void stop();
    void take(const std::shared_ptr<Job> &job, const sim::FrameCost &cost);
    void end(const std::shared_ptr<Job> &job);

    Session &m_session;
    CostFunction m_function;
    QThreadPool m_pool;
    QTimer m_later;
    std::shared_ptr<Job> m_job;
    About m_about; ///< of m_cost, or of what is under way
    std::optional<sim::FrameCost> m_cost;
    bool m_watched = false;
    bool m_isDone = false;
};

}

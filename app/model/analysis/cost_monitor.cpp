#include "app/model/analysis/cost_monitor.h"

#include "app/model/run/same_run.h"
#include "sim/base/error.h"
#include "sim/run/script/composed_interval.h"

#include <QElapsedTimer>

namespace app {

namespace {

/// Returns whether the cost of one run is a fair estimate for the other: the same effects with the same steps.
bool sameWork(const sim::Script &a, const sim::Script &b)
{
    return a.method == b.method && a.step == b.step && a.effectsOff == b.effectsOff;
}

}

void measureCost(const CostSubject &subject, const sim::ShouldContinue &shouldContinue,
                 const std::function<void(const sim::FrameCost &)> &report)
{
    sim::CostMeter meter(subject.interval->scene, subject.script.method, subject.script.step, subject.state);
    QElapsedTimer clock, sinceReport;
    clock.start();
    sinceReport.start();
    int rounds = 0;
    while ((rounds < CostMonitor::leastRounds || !clock.hasExpired(CostMonitor::mostMilliseconds)) &&
           meter.round(shouldContinue)) {
        ++rounds;
        if (rounds == CostMonitor::leastRounds || sinceReport.hasExpired(CostMonitor::reportMilliseconds)) {
            report(meter.result());
            sinceReport.start();
        }
    }
    if (rounds > 0 && shouldContinue())
        report(meter.result());
}

CostMonitor::CostMonitor(const OpenRun &run, const Playback &playback, CostFunction function,
                         std::shared_ptr<QThreadPool> thread, QObject *parent)
    : QObject(parent), m_run(run), m_playback(playback), m_function(std::move(function)),
      m_measurement(std::move(thread))
{
    m_settleTimer.setSingleShot(true);
    m_settleTimer.setInterval(settleMilliseconds);
    connect(&m_settleTimer, &QTimer::timeout, this, &CostMonitor::start);
    run.onChange(ChangeKind::step | ChangeKind::run, this, &CostMonitor::followRun);
    run.onChange(ChangeKind::playing, this, &CostMonitor::followPlaying);
}

CostMonitor::Subject CostMonitor::currentSubject() const
{
    return {m_run.lesson().id + '/' + m_run.step().id, withoutInput(m_run.timeline().script()),
            m_run.timeline().cursor().frame};
}

CostMonitor::Stage CostMonitor::stage() const
{
    if (m_measurement.isRunning())
        return Stage::measuring;
    if (m_settleTimer.isActive())
        return Stage::due;
    return m_isDone ? Stage::done : Stage::none;
}

void CostMonitor::setActive(bool isActive)
{
    if (isActive == m_isActive)
        return;
    m_isActive = isActive;
    if (isActive && !m_isDone)
        startLater();
    else if (!isActive)
        stop();
}

void CostMonitor::followRun()
{
    const Subject now = currentSubject();
    stop();
    m_isDone = false;
    if (now.step != m_subject.step || !sameWork(now.script, m_subject.script))
        m_cost.reset();
    if (m_isActive)
        startLater();
    emit changed();
}

void CostMonitor::followPlaying()
{
    // Contacts with a wall cost more than free motion, so the cost is measured again at the new position.
    if (m_isActive && !m_playback.isPlaying() && m_run.timeline().cursor().frame != m_subject.frame)
        startLater();
}

void CostMonitor::startLater()
{
    m_settleTimer.start();
    emit changed();
}

void CostMonitor::measureAgain()
{
    if (m_isActive)
        start();
}

void CostMonitor::stop()
{
    m_settleTimer.stop();
    m_measurement.cancel();
}

void CostMonitor::start()
{
    stop();
    m_isDone = false;
    m_subject = currentSubject();
    const sim::Track &track = m_run.timeline().track();
    CostSubject subject{m_run.timeline().script(), track.nextInterval(), {}};
    const std::int64_t frame = track.cursor().frame;
    subject.state =
        track.stateAfterInput(track.cursor().phase > 0 ? track.stateAt(frame) : track.state(), frame);
    m_measurement.start(
        [this, subject = std::move(subject), function = m_function](const BackgroundJob::Context &job) {
            function(subject, job.shouldContinue(), [&](const sim::FrameCost &cost) {
                job.report([this, cost] {
                    m_cost = cost;
                    emit changed();
                });
            });
        },
        [this](std::future<void> end) {
            m_isDone = true;
            try {
                end.get();
            } catch (const sim::Error &) {
                // The scene cannot be set up: the session reports the reason.
            }
            emit changed();
        });
    emit changed();
}

}

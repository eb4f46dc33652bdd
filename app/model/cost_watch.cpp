#include "app/model/cost_watch.h"

#include "app/model/same_run.h"
#include "sim/base/error.h"
#include "sim/run/script/composed_interval.h"

#include <QElapsedTimer>

namespace app {

namespace {

/// Whether figures of one still tell what the other costs, about: the same effects by the same steps.
bool sameWork(const sim::Script &a, const sim::Script &b)
{
    return a.method == b.method && a.step == b.step && a.effectsOff == b.effectsOff;
}

}

void measureCost(const CostSubject &subject, const sim::ShouldContinue &shouldContinue,
                 const std::function<void(const sim::FrameCost &)> &tell)
{
    sim::CostMeter meter(subject.interval->scene, subject.script.method, subject.script.step, subject.state);
    QElapsedTimer clock, sinceTold;
    clock.start();
    sinceTold.start();
    int rounds = 0;
    while ((rounds < CostWatch::leastRounds || !clock.hasExpired(CostWatch::mostMilliseconds)) &&
           meter.round(shouldContinue)) {
        ++rounds;
        if (rounds == CostWatch::leastRounds || sinceTold.hasExpired(CostWatch::tellMilliseconds)) {
            tell(meter.result());
            sinceTold.start();
        }
    }
    if (rounds > 0 && shouldContinue())
        tell(meter.result());
}

CostWatch::CostWatch(Session &session, CostFunction function, QObject *parent)
    : QObject(parent), m_session(session), m_function(std::move(function))
{
    m_pool.setMaxThreadCount(1);
    m_later.setSingleShot(true);
    m_later.setInterval(settleMilliseconds);
    connect(&m_later, &QTimer::timeout, this, &CostWatch::start);
    connect(&session, &Session::runChanged, this, &CostWatch::follow);
    connect(&session, &Session::stepOpened, this, &CostWatch::follow);
    connect(&session, &Session::playingChanged, this, &CostWatch::followPlaying);
}

CostWatch::~CostWatch()
{
    stop();
    m_pool.waitForDone();
}

CostWatch::About CostWatch::here() const
{
    return {m_session.lesson().id + '/' + m_session.step().id, withoutInput(m_session.timeline().script()),
            m_session.timeline().cursor().frame};
}

CostWatch::Stage CostWatch::stage() const
{
    if (m_job)
        return Stage::measuring;
    if (m_later.isActive())
        return Stage::due;
    return m_isDone ? Stage::done : Stage::none;
}

void CostWatch::setWatched(bool watched)
{
    if (watched == m_watched)
        return;
    m_watched = watched;
    if (watched && !m_isDone)
        startLater();
    else if (!watched)
        stop();
}

void CostWatch::follow()
{
    const About now = here();
    stop();
    m_isDone = false;
    if (now.step != m_about.step || !sameWork(now.script, m_about.script))
        m_cost.reset();
    if (m_watched)
        startLater();
    emit changed();
}

void CostWatch::followPlaying()
{
    // What touches a wall costs more than what hangs in the air: where it has come to, it is measured again.
    if (m_watched && !m_session.isPlaying() && m_session.timeline().cursor().frame != m_about.frame)
        startLater();
}

void CostWatch::startLater()
{
    m_later.start();
    emit changed();
}

void CostWatch::measureAgain()
{
    if (m_watched)
        start();
}

void CostWatch::stop()
{
    m_later.stop();
    if (m_job)
        m_job->stop = true;
    m_job.reset();
}

void CostWatch::start()
{
    stop();
    m_isDone = false;
    m_about = here();
    m_job = std::make_shared<Job>();
    const sim::Track &track = m_session.timeline().track();
    CostSubject subject{m_session.timeline().script(), track.nextInterval(), {}};
    const std::int64_t frame = track.cursor().frame;
    subject.state =
        track.stateAfterInput(track.cursor().phase > 0 ? track.stateAt(frame) : track.state(), frame);
    m_pool.start([this, job = m_job, subject = std::move(subject), function = m_function] {
        const auto tell = [&](const sim::FrameCost &cost) {
            QMetaObject::invokeMethod(
                this, [this, job, cost] { take(job, cost); }, Qt::QueuedConnection);
        };
        try {
            function(
                subject, [&] { return !job->stop; }, tell);
        } catch (const sim::Error &) {
            // No such scene: the session says why.
        }
        QMetaObject::invokeMethod(
            this, [this, job] { end(job); }, Qt::QueuedConnection);
    });
    emit changed();
}

void CostWatch::take(const std::shared_ptr<Job> &job, const sim::FrameCost &cost)
{
    if (job != m_job)
        return;
    m_cost = cost;
    emit changed();
}

void CostWatch::end(const std::shared_ptr<Job> &job)
{
    if (job != m_job)
        return;
    m_job.reset();
    m_isDone = true;
    emit changed();
}

}

#include "app/model/analysis/stability_preview.h"

#include <algorithm>
#include <utility>

namespace app {

StabilityPreview::StabilityPreview(const OpenRun &run, const Preview &preview, QObject *parent)
    : QObject(parent), m_run(run), m_preview(preview)
{
    m_due.setSingleShot(true);
    m_lateTimer.setSingleShot(true);
    m_lateTimer.setInterval(lateMilliseconds);
    connect(&m_lateTimer, &QTimer::timeout, this, [this] {
        m_isLate = true;
        emit changed();
    });
    connect(&m_due, &QTimer::timeout, this, &StabilityPreview::startReading);
    run.onChange(ChangeKind::preview, this, &StabilityPreview::followPreview);
}

void StabilityPreview::followPreview()
{
    if (!std::exchange(m_wasOpen, isOpen()) && !isOpen())
        return; // the moment is only marked, not shown
    if (!isOpen()) {
        m_due.stop();
        m_reading.reset();
        setOnTime();
    } else if (isCurrent()) {
        setOnTime();
    } else {
        if (!m_isLate && !m_lateTimer.isActive())
            m_lateTimer.start();
        if (!m_readingJob.isRunning() && !m_due.isActive())
            m_due.start(m_sinceReading.isValid() ? std::max<int>(0, m_pause - int(m_sinceReading.elapsed()))
                                                 : 0);
    }
    emit changed();
}

void StabilityPreview::setOnTime()
{
    m_lateTimer.stop();
    m_isLate = false;
}

void StabilityPreview::startReading()
{
    const sim::Timeline &shown = m_preview.run();
    std::shared_ptr<const sim::ComposedInterval> interval;
    const sim::State state = shown.track().preview(interval); // both of the next output step
    m_readingJob.start(
        [script = shown.script(), interval, state](const BackgroundJob::Context &) {
            return timedReading([&] { return readStability(script, interval, state); });
        },
        [this, at = shown.cursor()](std::future<TimedReading> result) { receive(at, result.get()); });
}

void StabilityPreview::receive(sim::Cursor at, const TimedReading &result)
{
    m_pause = result.pause();
    m_sinceReading.start();
    if (!isOpen())
        return;
    m_reading = result.reading;
    m_readAt = at;
    if (isCurrent())
        setOnTime();
    else
        m_due.start(m_pause);
    emit changed();
}

}

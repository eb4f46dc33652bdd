#include "app/model/stability_look.h"

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr int shareOfTime = 4; ///< a reading is followed by a pause this many times as long

}

StabilityLook::StabilityLook(Session &session, QObject *parent) : QObject(parent), m_session(session)
{
    m_pool.setMaxThreadCount(1);
    m_due.setSingleShot(true);
    m_patience.setSingleShot(true);
    m_patience.setInterval(patienceMilliseconds);
    connect(&m_patience, &QTimer::timeout, this, [this] {
        m_isLate = true;
        emit changed();
    });
    connect(&m_due, &QTimer::timeout, this, &StabilityLook::read);
    connect(&session, &Session::glanceChanged, this, &StabilityLook::follow);
}

StabilityLook::~StabilityLook()
{
    m_pool.waitForDone();
}

void StabilityLook::follow()
{
    if (!std::exchange(m_isLooking, isLooking()) && !m_isLooking)
        return; // a moment is marked, and not shown
    if (!m_isLooking) {
        m_due.stop();
        m_reading.reset();
        beOnTime();
    } else if (isCurrent()) {
        beOnTime();
    } else {
        if (!m_isLate && !m_patience.isActive())
            m_patience.start();
        if (!m_reads && !m_due.isActive())
            m_due.start(m_sinceRead.isValid() ? std::max<int>(0, m_pause - int(m_sinceRead.elapsed())) : 0);
    }
    emit changed();
}

void StabilityLook::beOnTime()
{
    m_patience.stop();
    m_isLate = false;
}

void StabilityLook::read()
{
    m_reads = true;
    const sim::Timeline &shown = m_session.shown();
    std::shared_ptr<const sim::ComposedInterval> interval;
    const sim::State state = shown.track().preview(interval); // both of the row to come
    m_pool.start([this, script = shown.script(), interval, state, at = shown.cursor()] {
        QElapsedTimer clock;
        clock.start();
        auto reading = std::make_shared<const StabilityReading>(readStability(script, interval, state));
        const int took = static_cast<int>(clock.elapsed());
        QMetaObject::invokeMethod(
            this, [this, at, reading, took] { take(at, reading, took); }, Qt::QueuedConnection);
    });
}

void StabilityLook::take(sim::Cursor at, std::shared_ptr<const StabilityReading> reading, int took)
{
    m_reads = false;
    m_pause = shareOfTime * took;
    m_sinceRead.start();
    if (!isLooking())
        return;
    m_reading = std::move(reading);
    m_readAt = at;
    if (isCurrent())
        beOnTime();
    else
        m_due.start(m_pause);
    emit changed();
}

}

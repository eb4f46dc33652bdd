#pragma once

#include "app/model/session.h"
#include "app/model/stability_reading.h"

#include <QElapsedTimer>
#include <QObject>
#include <QThreadPool>
#include <QTimer>

namespace app {

/// How far the step in use is from its limit at the moment that somebody looks at, read on a thread of its own: a hand
/// that moves on never waits for it, and where readings take long there are fewer of them. Where nobody looks, nothing is
/// computed.
class StabilityLook : public QObject
{
    Q_OBJECT

public:
    explicit StabilityLook(Session &session, QObject *parent = nullptr);
    /// Waits for a reading under way.
    ~StabilityLook() override;

    /// Whether somebody looks at another moment than the run's.
    bool isLooking() const { return m_session.isGlancing(); }
    /// The last reading since they began to look; null before the first.
    const StabilityReading *reading() const { return m_reading.get(); }
    /// Whether it is of the moment that is looked at.
    bool isCurrent() const { return m_reading && m_readAt == m_session.shown().cursor(); }
    /// Whether that one is still to come after a while: most are there before anybody sees that they were not.
    bool isLate() const { return m_isLate; }
    std::int64_t frame() const { return m_session.shown().cursor().frame; }

    static constexpr int patienceMilliseconds = 120;

signals:
    void changed();

private:
    void follow();
    void beOnTime();
    void read();
    void take(sim::Cursor at, std::shared_ptr<const StabilityReading> reading, int took);

    Session &m_session;
    QThreadPool m_pool;
    QTimer m_due;
    QTimer m_patience; ///< runs for a while after the moment changed
    QElapsedTimer m_sinceRead;
    int m_pause = 0; ///< ms, to keep after the last reading
    bool m_reads = false;
    bool m_isLooking = false;
    bool m_isLate = false;
    sim::Cursor m_readAt;
    std::shared_ptr<const StabilityReading> m_reading;
};

}

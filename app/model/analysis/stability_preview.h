#pragma once

#include "app/model/analysis/stability_reading.h"
#include "app/model/jobs/background_job.h"
#include "app/model/session/open_run.h"
#include "app/model/session/preview.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace app {

/// Computes how far the present step is from its limit, at the moment of a preview. It works on another thread, so
/// pointer movement never waits for it. Slow readings become less frequent. Without a preview it computes nothing.
class StabilityPreview : public QObject
{
    Q_OBJECT

public:
    explicit StabilityPreview(const OpenRun &run, const Preview &preview, QObject *parent = nullptr);

    /// Returns whether a preview of another moment is open.
    bool isOpen() const { return m_preview.isActive(); }
    /// Returns the last reading since the preview began; null before the first.
    const StabilityReading *reading() const { return m_reading.get(); }
    /// Returns whether the reading belongs to the previewed moment.
    bool isCurrent() const { return m_reading && m_readAt == m_preview.run().cursor(); }
    /// Returns whether the reading is still missing after a short wait. Most readings arrive before the delay is
    /// visible.
    bool isLate() const { return m_isLate; }
    std::int64_t frame() const { return m_preview.run().cursor().frame; }

    static constexpr int lateMilliseconds = 120;

signals:
    void changed();

private:
    void followPreview();
    void setOnTime();
    void startReading();
    void receive(sim::Cursor at, const TimedReading &result);

    const OpenRun &m_run;
    const Preview &m_preview;
    QTimer m_due;
    QTimer m_lateTimer; ///< runs for a while after the moment changed
    QElapsedTimer m_sinceReading;
    int m_pause = 0; ///< ms to wait after the last reading
    bool m_wasOpen = false;
    bool m_isLate = false;
    sim::Cursor m_readAt;
    std::shared_ptr<const StabilityReading> m_reading;
    BackgroundJob m_readingJob;
};

}

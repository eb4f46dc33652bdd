#pragma once

#include "app/model/analysis/map_plane.h"
#include "app/model/analysis/stability_preview.h"
#include "app/model/analysis/stability_reading.h"
#include "app/model/analysis/tried_spot.h"
#include "app/model/jobs/background_job.h"
#include "app/model/session/open_run.h"
#include "app/model/session/preview.h"
#include "app/model/session/run_editor.h"
#include "sim/analysis/stability/growth_map.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace app {

/// Monitors the stability of the session's step on another thread. It computes a new reading after each change, at most
/// ten times a second and with at most a fifth of a processor. Without changes it computes nothing.
class StabilityMonitor : public QObject
{
    Q_OBJECT

public:
    explicit StabilityMonitor(const OpenRun &run, RunEditor &editor, const Preview &preview,
                              QObject *parent = nullptr);

    const OpenRun &run() const { return m_run; }
    /// Returns the last reading; null before the first.
    const StabilityReading *reading() const { return m_reading.get(); }
    /// Returns the readings for the moment of a preview.
    const StabilityPreview &preview() const { return m_preview; }
    /// Returns whether the reading belongs to the present state of the session.
    bool isCurrent() const { return !m_due.isActive() && !m_readingJob.isRunning(); }
    /// Returns whether a map is being computed or will be soon.
    bool isMapping() const { return m_mapDue.isActive() || m_mapJob.isRunning(); }

    /// Sets whether remedies are shown, so that readings include them.
    void setDetailed(bool detailed);
    void adopt(const sim::Remedy &remedy);

    /// Returns the nearest settings to `spot` that are possible in the open step.
    TriedSpot settable(const TriedSpot &spot) const { return app::settable(m_run.step(), spot); }
    /// Applies the settings as the fields would. The previous run becomes the comparison run.
    void adopt(const TriedSpot &spot);

    /// Returns whether the open step can have a map. Its scene needs the parameter "k", and "damp" for the `damping`
    /// plane. The method must have a limit. Something must oscillate, or do so if k were not 0.
    bool canMap(MapPlane plane) const;
    /// Returns whether no part of the scene has a stiffness for any parameter values.
    bool nothingSwings() const;
    /// Requests a map, which is updated whenever the session is idle. Empty: stop computing maps.
    void requestMap(std::optional<MapPlane> plane);
    std::optional<MapPlane> mapPlane() const { return m_plane; }
    /// Returns the rows known so far; null if there are none.
    const sim::GrowthMap *map() const { return m_map.get(); }
    /// Returns the settings that the learner has tried in this step, oldest first. The last one is the present setting.
    const std::vector<TriedSpot> &tried() const { return m_tried; }

    static constexpr int pauseMilliseconds = 100; ///< between two readings
    static constexpr int restMilliseconds = 300;  ///< before a map is computed
    static constexpr int columns = 49;            ///< of a map
    static constexpr int rows = 33;

signals:
    void changed();
    void mapChanged();

private:
    struct Subject;
    struct Offers;

    static StabilityReading readingOf(const Subject &subject, const std::optional<Offers> &offers,
                                      const BackgroundJob::Context &job);

    Subject currentSubject() const;
    void followCursor();
    void followRun();
    void reset();
    void startReading();
    void receive(const TimedReading &result);
    void startMap();
    void stopMap();
    void noteSpot();
    sim::MapAxis across() const;
    sim::MapAxis up() const;

    const OpenRun &m_run;
    RunEditor &m_editor;
    StabilityPreview m_preview;
    QTimer m_due;              ///< active while a reading is due
    QTimer m_mapDue;           ///< the same for a map
    bool m_hasChanged = false; ///< the session, since the reading began
    bool m_detailed = false;
    int m_pause = 0; ///< ms to wait after the last reading
    QElapsedTimer m_sinceReading;
    std::shared_ptr<const StabilityReading> m_reading;
    std::shared_ptr<const sim::GrowthMap> m_map;
    std::optional<MapPlane> m_plane;
    std::vector<TriedSpot> m_tried;
    bool m_adopting = false; ///< only some settings of a spot are applied so far
    BackgroundJob m_readingJob;
    BackgroundJob m_mapJob;
};

}

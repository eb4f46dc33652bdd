#pragma once

#include "app/model/analysis/tried_spot.h"
#include "app/model/jobs/background_job.h"
#include "app/model/session/open_run.h"
#include "app/model/session/run_editor.h"
#include "sim/analysis/settling/settling.h"

#include <QObject>
#include <QTimer>

namespace app {

/// Computes how long the session's run takes to come to rest, for each stiffness and damping: a map. It works on another
/// thread, and only while a view shows the map and something else than these two numbers has changed.
class SettlingMonitor : public QObject
{
    Q_OBJECT

public:
    SettlingMonitor(const OpenRun &run, RunEditor &editor, Playback &playback, QObject *parent = nullptr);

    const OpenRun &run() const { return m_run; }
    /// Sets whether any view shows the map.
    void setActive(bool isActive);
    bool isActive() const { return m_isActive; }
    /// Returns whether the open step can have a map: it needs stiffness and damping, and few points.
    bool canMap() const;
    /// Returns whether a map is being computed or will be soon.
    bool isMapping() const { return m_due.isActive() || m_job.isRunning(); }
    /// Returns the cells computed so far; null before the first ones.
    const sim::SettlingMap *map() const { return m_map.get(); }
    /// Returns the frame of the last input, from which frames are counted.
    std::int64_t countedFrom() const;
    /// Returns whether the run has input that comes too late to be in the map.
    bool leavesInputOut() const;

    /// Returns the settings that the learner has tried in this step, oldest first. The last one is the present setting.
    const std::vector<TriedSpot> &tried() const { return m_tried; }
    /// Returns the nearest settings to `spot` that are possible in the open step.
    TriedSpot settable(const TriedSpot &spot) const { return app::settable(m_run.step(), spot); }
    /// Restarts the run with the stiffness and damping of `spot` and the same input, as one edit. Playback continues.
    void adopt(const TriedSpot &spot);

    static constexpr int restMilliseconds = 300;       ///< before a map is computed
    static constexpr int reportMilliseconds = 100;     ///< between two reports
    static constexpr int longestMilliseconds = 20'000; ///< after these, a map stays as coarse as it is
    static constexpr int columns = 61;                 ///< of a map: 20 for each power of ten
    static constexpr int rows = 49;                    ///< 0.02 apart, as the field of damping shows them
    static constexpr std::int64_t mostInput = 1200;    ///< frames; later input is left out
    static constexpr int mostPoints = 500;

signals:
    void changed();

private:
    /// What a map is about.
    struct Question
    {
        sim::Script script;
        sim::MapAxis x;
        sim::MapAxis y;
    };

    Question question() const;
    bool isAnswered() const;
    void followRun();
    void reset();
    void start();
    void stop();
    void noteSpot();
    TriedSpot present() const;

    const OpenRun &m_run;
    RunEditor &m_editor;
    Playback &m_playback;
    QTimer m_due; ///< active while a map is due
    bool m_isActive = false;
    std::optional<Question> m_question; ///< of the map that is known or being computed
    std::shared_ptr<const sim::SettlingMap> m_map;
    std::vector<TriedSpot> m_tried;
    BackgroundJob m_job;
};

}

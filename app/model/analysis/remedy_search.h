#pragma once

#include "app/model/jobs/background_job.h"
#include "app/model/session/open_run.h"
#include "app/model/session/run_editor.h"
#include "sim/analysis/stability/remedies/trial_runs.h"

#include <QObject>

namespace app {

/// Searches for remedies when the session's run has failed. The trial runs are computed on another thread.
class RemedySearch : public QObject
{
    Q_OBJECT

public:
    explicit RemedySearch(const OpenRun &run, const RunEditor &editor, QObject *parent = nullptr);

    /// Returns why the run ended, while the cursor is at its end; null everywhere else.
    const sim::Stop *stop() const;
    bool isSearching() const { return m_search.isRunning(); }
    const std::vector<sim::Remedy> &found() const { return m_found; }

signals:
    /// The run stopped at another place or no longer stops, or the remedies are known now.
    void changed();

private:
    /// Drops the results, because they belong to an earlier run.
    void reset();
    /// Starts the search when the cursor reaches the end of a stopped run for the first time.
    void update();
    void begin();

    const OpenRun &m_run;
    const RunEditor &m_editor;
    bool m_hasBegun = false; ///< the search for this run
    bool m_wasStopped = false;
    std::vector<sim::Remedy> m_found;
    BackgroundJob m_search;
};

/// Explains the consequences of a remedy for a stopped run, in one or two sentences.
QString remedyHelp(const sim::Remedy &remedy);

}

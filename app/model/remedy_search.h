#pragma once

#include "app/model/session.h"
#include "sim/analysis/stability/remedies/trial_runs.h"

#include <QObject>

#include <thread>

namespace app {

/// What mends the session's run where that has stopped by itself, tried out on a thread of its own.
class RemedySearch : public QObject
{
    Q_OBJECT

public:
    explicit RemedySearch(Session &session, QObject *parent = nullptr);
    /// Stops a search and waits for its thread.
    ~RemedySearch() override;

    /// Where the run ends, while the cursor stands there; null everywhere else.
    const sim::Stop *stop() const;
    bool isSearching() const { return m_run && !m_isDone; }
    const std::vector<sim::Remedy> &found() const { return m_found; }

signals:
    /// Another stop, or none, or what mends it is known now.
    void changed();

private:
    struct Run;

    /// What was found belongs to a run that is no more.
    void forget();
    /// Looks for remedies when the cursor is at a stop for the first time.
    void look();
    void begin();

    Session &m_session;
    std::thread m_thread;
    std::shared_ptr<Run> m_run; ///< the search about this run; null before it came to a stop
    bool m_isDone = false;
    bool m_wasStopped = false;
    std::vector<sim::Remedy> m_found;
};

/// What comes of using a remedy where a run has stopped, in a sentence or two.
QString remedyHelp(const sim::Remedy &remedy);

}

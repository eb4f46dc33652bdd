#pragma once

#include "app/model/jobs/background_job.h"
#include "app/model/listing/code_judge.h"
#include "app/model/session/session.h"

#include <QHash>
#include <QObject>

#include <optional>

namespace app {

/// The task in the step's listing that the learner writes. The desk empties the place in the listing, judges each
/// text that compiles, tells hints, and ticks the task once it is done.
class TaskDesk : public QObject
{
    Q_OBJECT

public:
    /// `session` must outlive this object.
    explicit TaskDesk(Session &session, QObject *parent = nullptr);

    /// Returns the task that the learner writes; null if there is none.
    const lessons::CodeTask *task() const;
    bool isDone(const lessons::CodeTask &task) const;
    /// Starts the task `id` of the open step: replaces the learner's text by the listing with an empty place. It can be
    /// undone. An unknown `id` changes nothing.
    void start(const QString &id);
    /// Stops writing. The learner's text stays.
    void stop();

    /// Returns how many hints are shown.
    int hintsShown() const { return m_sheet.hints; }
    /// Shows one more hint, if there is one.
    void showNextHint();
    /// Replaces the learner's text by the listing. The task is not ticked for it.
    void showSolution();
    bool isSolutionShown() const { return m_sheet.isSolutionShown; }

    /// Returns whether the judge is at work.
    bool isJudging() const { return m_job.isRunning(); }
    /// Returns the judgement on the present text. Empty while there is none: the text does not compile, the place is
    /// still empty, or the judge is at work.
    const std::optional<Verdict> &verdict() const { return m_verdict; }
    /// Returns what a learner should know about the present text, in one or two sentences. May be empty.
    QString sentence() const;

signals:
    /// The task, its hints or its judgement changed.
    void changed();

private:
    /// A task and how far the learner is with it.
    struct Sheet
    {
        QString task; ///< id; empty: none
        QString text; ///< of the learner, as last seen
        int hints = 0;
        int begun = 0; ///< number of undo entries after the place was emptied
        bool isSolutionShown = false;
    };

    void openStep();
    void followText();
    void judgeText();
    void receive(std::future<std::optional<Verdict>> verdict);

    Session &m_session;
    Sheet m_sheet;
    QString m_step;                    ///< that m_sheet belongs to
    QHash<QString, Sheet> m_handovers; ///< of steps that were open before
    std::optional<Verdict> m_verdict;
    bool m_writes = false; ///< whether this object changes the text
    BackgroundJob m_job;
};

}

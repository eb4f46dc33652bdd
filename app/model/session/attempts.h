#pragma once

#include "app/model/catalog/lesson_library.h"
#include "app/model/catalog/progress.h"
#include "app/model/learning/proofs.h"
#include "lessons/api/checks/budget.h"
#include "lessons/api/step.h"
#include "sim/run/timeline.h"

#include <QElapsedTimer>
#include <QObject>
#include <QSet>

namespace app {

/// Finds out which of a step's things to try are done, and ticks them. It keeps the run that earned a tick, for the
/// learner's notebook.
class Attempts : public QObject
{
    Q_OBJECT

public:
    /// `progress` has the ticks, and `proofs` their runs. All arguments must outlive it.
    Attempts(Progress &progress, Proofs &proofs, const LessonLibrary &library)
        : m_progress(progress), m_proofs(proofs), m_library(library)
    {
    }

    /// How the time is told that a run takes, for things to try within a budget; measured, unless said otherwise.
    void setTiming(lessons::TimeMeasurement timing) { m_timing = std::move(timing); }
    /// Sets whether the run is the learner's own. A run that the program has set up, for example for a prediction, ticks
    /// nothing. If the learner then changes that run, a thing to try that was already done in it counts only after it has
    /// stopped being done once.
    void setOwnRun(bool isOwn) { m_isOwnRun = isOwn; }

    /// Ticks what is done at the moment of `timeline`, a run of this step, which plays or stands.
    void check(const QString &lesson, const lessons::Step &step, const sim::Timeline &timeline, bool plays);
    /// Returns what is still to do for the thing to try with this number, which a learner has begun: one or two
    /// sentences of Markdown. Empty if nothing is missing, or before the learner begins. In a run that the program has set
    /// up, they say why it does not count, once the run is paused.
    QString todo(const QString &lesson, const lessons::Step &step, int number, const sim::Timeline &timeline,
                 bool plays) const;
    /// Whether one of the things to try that are not done is done later if the learner does nothing. What sleeps is looked
    /// into at once; where too many points move, it may be.
    bool mayBeDoneByWaiting(const QString &lesson, const lessons::Step &step,
                            const sim::Timeline &timeline) const;

signals:
    /// Something asks for a measurement, and the last one was just now: to be checked again, even if nothing moves any
    /// more.
    void checkDue();

private:
    void scheduleCheck();
    /// Keeps the run up to its cursor as the proof of a tick. A run that no file can store is not kept.
    void keepProof(const QString &key, const QString &lesson, const lessons::Step &step,
                   const sim::Timeline &timeline);

    Progress &m_progress;
    Proofs &m_proofs;
    const LessonLibrary &m_library;
    QSet<QString> m_unkept; ///< keys of ticks whose run was too long to keep
    QSet<QString> m_given;  ///< things to try that a run did which the program has set up, by step and number
    lessons::TimeMeasurement m_timing = lessons::measureTime;
    bool m_isOwnRun = true;
    bool m_isCheckScheduled = false; ///< whether checkDue() is on its way
    QElapsedTimer m_sinceMeasured;   ///< since a budget was last looked at
};

}

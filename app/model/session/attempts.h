#pragma once

#include "app/model/catalog/progress.h"
#include "lessons/api/checks/budget.h"
#include "lessons/api/step.h"
#include "sim/run/timeline.h"

#include <QElapsedTimer>
#include <QObject>

namespace app {

/// Finds out which of a step's things to try are done, and ticks them.
class Attempts : public QObject
{
    Q_OBJECT

public:
    /// `progress` has the ticks, and must outlive it.
    explicit Attempts(Progress &progress) : m_progress(progress) {}

    /// How the time is told that a run takes, for things to try within a budget; measured, unless said otherwise.
    void setTiming(lessons::TimeMeasurement timing) { m_timing = std::move(timing); }
    /// Sets whether the run is the learner's own. A run that the program has set up ticks nothing.
    void setOwnRun(bool isOwn) { m_isOwnRun = isOwn; }

    /// Ticks what is done at the moment of `timeline`, a run of this step, which plays or stands.
    void check(const QString &lesson, const lessons::Step &step, const sim::Timeline &timeline, bool plays);
    /// Returns what is still to do for the thing to try with this number, which a learner has begun: one or two
    /// sentences of Markdown. Empty where nothing is missing, and where nobody has begun.
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

    Progress &m_progress;
    lessons::TimeMeasurement m_timing = lessons::measureTime;
    bool m_isOwnRun = true;
    bool m_isCheckScheduled = false; ///< whether checkDue() is on its way
    QElapsedTimer m_sinceMeasured;   ///< since a budget was last looked at
};

}

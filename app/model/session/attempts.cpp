#include "app/model/session/attempts.h"

#include "app/model/experiment/experiment_line.h"
#include "app/model/learning/notes.h"
#include "app/model/run/run_program.h"

#include <QTimer>

#include <algorithm>
#include <utility>
#include <vector>

namespace app {

namespace {

/// What a run costs is measured no more often than this.
constexpr int measureAgainMilliseconds = 500;

/// How many frames later it is looked whether something to try is done by waiting. What sleeps is there at once; what does not
/// yet is computed if its points are not too many.
constexpr int manyPoints = 1000;
constexpr std::int64_t laterFrames[] = {10, 30, 100, 300, 1000};

QString numberedKey(const QString &lesson, const lessons::Step &step, int number)
{
    return QStringLiteral("%1/%2/%3").arg(lesson, step.id).arg(number);
}

}

void Attempts::check(const QString &lesson, const lessons::Step &step, const sim::Timeline &timeline,
                     bool plays)
{
    const bool mayMeasure =
        !m_sinceMeasured.isValid() || m_sinceMeasured.elapsed() >= measureAgainMilliseconds;
    const auto keeps = [&](const lessons::Budget &budget) {
        if (!mayMeasure) {
            scheduleCheck();
            return false;
        }
        const bool kept = lessons::staysWithin(budget, timeline.script(), m_timing);
        m_sinceMeasured.start();
        return kept;
    };
    for (int i = 0; i < static_cast<int>(step.tries.size()); ++i) {
        const lessons::Try &one = step.tries[static_cast<std::size_t>(i)];
        const QString key = Notes::keyOf(lesson, step.id, QStringLiteral("try"), one.id);
        // A tick from before runs were kept gets its run when the learner does the thing again.
        const bool isWanted =
            !m_progress.isDone(lesson, step.id, i) ||
            (!one.budget && !one.id.isEmpty() && !m_unkept.contains(key) && !m_proofs.has(key));
        if (!isWanted || (one.onlyWhilePaused && plays))
            continue;
        const QString number = numberedKey(lesson, step, i);
        if (!one.isDone(timeline)) {
            if (m_isOwnRun)
                m_given.remove(number);
        } else if (!m_isOwnRun) {
            m_given.insert(number);
        } else if (!m_given.contains(number) && (!one.budget || keeps(*one.budget))) {
            keepProof(key, lesson, step, timeline);
            m_progress.markDone(lesson, step.id, i);
        }
    }
}

void Attempts::keepProof(const QString &key, const QString &lesson, const lessons::Step &step,
                         const sim::Timeline &timeline)
{
    const auto lineOfRun = [&](const sim::Script &script) {
        const std::int64_t frames = std::max<std::int64_t>(1, timeline.cursor().frame);
        return experimentLine({lesson, step.id, frames, script}, m_library);
    };
    try {
        Proof proof{.run = lineOfRun(timeline.script()), .at = timeline.cursor()};
        if (const sim::Track *comparison = timeline.comparison()) {
            proof.beside = lineOfRun(comparison->script());
            proof.fork = timeline.forkFrame();
        }
        m_proofs.keep(key, proof);
    } catch (const UserError &) { // too long for a file, or a number is not finite
    }
    if (!m_proofs.has(key))
        m_unkept.insert(key);
}

QString Attempts::todo(const QString &lesson, const lessons::Step &step, int number,
                       const sim::Timeline &timeline, bool plays) const
{
    const lessons::Try &one = step.tries[static_cast<std::size_t>(number)];
    if (m_progress.isDone(lesson, step.id, number))
        return {};
    const bool isDone = one.isDone(timeline);
    const bool wasGiven = isDone && m_given.contains(numberedKey(lesson, step, number));
    if (!plays && (wasGiven || (!m_isOwnRun && one.conditions.hasBegun(timeline))))
        return tr("this run was set up for you. Undo brings your own run back: do it there.");
    if (!m_isOwnRun)
        return {};
    if (!isDone && programOf(timeline.script().method) && one.conditions.waitsForPhase(timeline))
        return tr("your code computes this run, and it has no phases. Press **Reset listing** on the page "
                  "**Listing**. Undo brings your code back.");
    if (!isDone && programOf(timeline.script().method) && one.conditions.waitsForStep(timeline))
        return tr("your code computes this run, in steps of 1 frame. Press **Reset listing** on the page "
                  "**Listing**, then choose the step. Undo brings your code back.");
    if (!isDone)
        return one.conditions.todo(timeline);
    if (one.onlyWhilePaused && plays)
        return tr("stop here: press **Space**.");
    if (one.budget && !m_isCheckScheduled)
        return tr("the error is too large, or a frame takes too long. Try another method or step.");
    return {};
}

void Attempts::scheduleCheck()
{
    if (std::exchange(m_isCheckScheduled, true))
        return;
    QTimer::singleShot(measureAgainMilliseconds, this, [this] {
        m_isCheckScheduled = false;
        emit checkDue();
    });
}

bool Attempts::mayBeDoneByWaiting(const QString &lesson, const lessons::Step &step,
                                  const sim::Timeline &timeline) const
{
    std::vector<const lessons::Try *> open;
    for (int i = 0; i < static_cast<int>(step.tries.size()); ++i) {
        const lessons::Try &one = step.tries[static_cast<std::size_t>(i)];
        if (!m_progress.isDone(lesson, step.id, i) && !one.isDone(timeline))
            open.push_back(&one);
    }
    if (open.empty())
        return false;
    if (timeline.state().pointCount() > manyPoints && !timeline.isFinished())
        return true; // to find out takes too long before it sleeps
    sim::Timeline later = timeline;
    for (const std::int64_t frames : laterFrames) {
        later.seek({timeline.cursor().frame + frames, 0});
        for (const lessons::Try *one : open) {
            if (one->isDone(later))
                return true;
        }
    }
    return false;
}

}

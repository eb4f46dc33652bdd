#include "app/model/session/session.h"

#include <algorithm>

namespace app {

Session::Session(const LessonLibrary &library, QObject *parent)
    : QObject(parent), m_run(library, m_changes), m_preview(m_run, [this] { return isBusy(); }),
      m_companion(m_run, m_preview), m_playback(m_run, m_preview, m_companion, m_attempts),
      m_comparisons(m_run, m_history),
      m_editor(m_run, m_preview, m_companion, m_playback, m_comparisons, m_history), m_code(m_run, m_editor),
      m_rule(m_run, m_editor), m_lines(m_run, m_preview, m_playback, m_code),
      m_presentation(m_run, m_preview, m_companion, m_lines)
{
    m_playback.setLines([this] { return m_lines.ahead(); }, [this](int lines) { m_lines.stopAt(lines); });
    m_editor.begin(step().script(), {}, {});
    m_playback.breakpoints().followListing(m_code.text());
    m_changes.setPreparation([this](ChangeKinds kinds) { prepare(kinds); });
}

bool Session::isBusy() const
{
    return m_playback.isPlaying() || m_playback.goal() || m_comparisons.isComputing() ||
           m_editor.input().isActive() || m_companion.isComing();
}

void Session::prepare(ChangeKinds kinds)
{
    const Change change{kinds};
    if (change.isAny(ChangeKind::run))
        m_playback.wakeUp();
    if (change.isAny(ChangeKind::step | ChangeKind::run | ChangeKind::code))
        m_playback.breakpoints().followListing(m_code.text());
    if (change.isAny(ChangeKind::step | ChangeKind::run | ChangeKind::cursor | ChangeKind::code))
        m_lines.follow();
    if (change.isAny(ChangeKind::step | ChangeKind::run | ChangeKind::cursor | ChangeKind::playing)) {
        m_preview.endIfShown();
        m_playback.checkAttempts();
    }
    if (m_preview.isActive())
        m_companion.follow(); // a companion run that takes longer is not shown
    else
        m_companion.followSoon();
}

bool Session::isStepDone(const LessonEntry &lesson, const lessons::Step &step) const
{
    for (int i = 0; i < static_cast<int>(step.tries.size()); ++i) {
        if (!m_progress.isDone(lesson.id, step.id, i))
            return false;
    }
    for (const lessons::CodeTask &task : step.codeTasks) {
        if (!m_progress.isWritten(lesson.id, step.id, task.id))
            return false;
    }
    return !step.tries.empty() || !step.codeTasks.empty();
}

void Session::openStep(const QString &lessonId, const QString &stepId)
{
    for (std::size_t i = 0; i < library().entries(); ++i) {
        const LessonEntry &entry = library().entry(i);
        for (std::size_t j = 0; j < entry.steps.size(); ++j) {
            if (entry.id != lessonId || entry.steps[j].id != stepId)
                continue;
            const ChangeNotifier::Batch batch(m_changes);
            leave();
            m_history.stack().clear();
            m_run.setStep(i, j);
            const auto handover = m_handovers.find(m_run.key());
            if (handover != m_handovers.end())
                m_editor.begin(handover->second.script, handover->second.at, handover->second.branches,
                               handover->second.draft);
            else
                m_editor.begin(step().script(), {}, {});
            return;
        }
    }
}

void Session::openFollowing()
{
    if (!m_run.following())
        return;
    const bool isSameLesson = m_run.stepNumber() + 1 < lesson().steps.size();
    openStep(isSameLesson ? lesson().id : library().lessons[m_run.lessonNumber() + 1].id,
             m_run.following()->id);
}

void Session::openPreceding()
{
    if (!m_run.preceding())
        return;
    const bool isSameLesson = m_run.stepNumber() > 0;
    openStep(isSameLesson ? lesson().id : library().lessons[m_run.lessonNumber() - 1].id,
             m_run.preceding()->id);
}

void Session::open(const Experiment &experiment)
{
    sim::Timeline trial(experiment.script); // throws before anything has changed
    const ChangeNotifier::Batch batch(m_changes);
    openStep(experiment.lesson, experiment.step);
    m_editor.begin(experiment.script, {}, m_comparisons.renumbered(experiment.branches), experiment.draft);
    m_history.stack().clear();
}

Experiment Session::experiment() const
{
    return {lesson().id,
            step().id,
            std::max<std::int64_t>(1, timeline().computed()),
            timeline().script(),
            m_comparisons.branches().marked(),
            m_run.draft()};
}

std::optional<Experiment> Session::experimentOf(const QString &lesson, const QString &step) const
{
    const auto found = m_handovers.find(OpenRun::keyOf(lesson, step));
    if (found == m_handovers.end())
        return std::nullopt;
    return Experiment{lesson,
                      step,
                      std::max<std::int64_t>(1, found->second.at.frame),
                      found->second.script,
                      found->second.branches.marked(),
                      found->second.draft};
}

void Session::leave()
{
    m_playback.pause();
    input().releaseAll();
    m_handovers.insert_or_assign(m_run.key(), StepHandover{timeline().script(), timeline().cursor(),
                                                           m_comparisons.branches(), m_run.draft()});
}

QString Session::todo(int number) const
{
    return m_attempts.todo(lesson().id, step(), number, timeline(), m_playback.isPlaying());
}

void Session::cancelComputing()
{
    m_playback.pause();
    m_comparisons.cancel();
}

}

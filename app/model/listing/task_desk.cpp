#include "app/model/listing/task_desk.h"

#include "app/model/catalog/lists.h"
#include "app/model/listing/learner_code.h"

#include <QScopedValueRollback>

namespace app {

TaskDesk::TaskDesk(Session &session, QObject *parent) : QObject(parent), m_session(session)
{
    session.onChange(ChangeKind::step, this, &TaskDesk::openStep);
    session.onChange(ChangeKind::code, this, &TaskDesk::followText);
    connect(&session.code(), &LearnerCode::wasReset, this, [this] {
        if (!m_writes)
            stop();
    });
    m_step = m_session.run().key();
}

const lessons::CodeTask *TaskDesk::task() const
{
    return findById(m_session.step().codeTasks, m_sheet.task);
}

bool TaskDesk::isDone(const lessons::CodeTask &task) const
{
    return m_session.progress().isWritten(m_session.lesson().id, m_session.step().id, task.id);
}

void TaskDesk::start(const QString &id)
{
    const lessons::CodeTask *found = findById(m_session.step().codeTasks, id);
    if (!found)
        return;
    m_job.cancel();
    m_verdict.reset();
    m_sheet = {};
    {
        const QScopedValueRollback writes(m_writes, true);
        LearnerCode &code = m_session.code();
        if (!code.isInUse())
            code.reset(); // the run follows what the learner writes
        m_session.editor().endGesture();
        code.removeLines(*found);
        m_session.editor().endGesture();
    }
    m_sheet.task = id;
    m_sheet.text = m_session.code().text();
    m_sheet.begun = m_session.editor().undoStack().index();
    emit changed();
}

void TaskDesk::stop()
{
    if (m_sheet.task.isEmpty())
        return;
    m_job.cancel();
    m_verdict.reset();
    m_sheet = {};
    emit changed();
}

void TaskDesk::showNextHint()
{
    if (!task() || m_sheet.hints >= task()->hints.size())
        return;
    ++m_sheet.hints;
    emit changed();
}

void TaskDesk::showSolution()
{
    if (!task())
        return;
    m_job.cancel();
    m_verdict.reset();
    m_sheet.isSolutionShown = true;
    {
        const QScopedValueRollback writes(m_writes, true);
        m_session.editor().endGesture();
        m_session.code().write(m_session.step().listing.text);
        m_session.editor().endGesture();
    }
    m_sheet.text = m_session.code().text();
    emit changed();
}

void TaskDesk::openStep()
{
    m_job.cancel();
    m_verdict.reset();
    if (!m_sheet.task.isEmpty())
        m_handovers.insert(m_step, m_sheet);
    m_step = m_session.run().key();
    m_sheet = m_handovers.take(m_step);
    // The run of the step can be another one now, with another text.
    if (!m_sheet.task.isEmpty() && m_sheet.text != m_session.code().text())
        m_sheet = {};
    m_sheet.begun = 0; // the undo entries of the step are gone
    if (task())
        judgeText();
    emit changed();
}

void TaskDesk::followText()
{
    const QString text = m_session.code().text();
    if (m_writes || !task() || text == m_sheet.text)
        return;
    if (m_session.editor().undoStack().index() < m_sheet.begun) {
        stop(); // the emptying of the place was undone
        return;
    }
    m_sheet.text = text;
    judgeText();
    emit changed();
}

void TaskDesk::judgeText()
{
    m_job.cancel();
    m_verdict.reset(); // it was on another text
    const QString text = m_session.code().text();
    if (m_sheet.isSolutionShown || !m_session.code().program() ||
        text == m_session.step().listing.emptied(*task()))
        return;
    // The lessons outlive the session, and with it this job.
    m_job.start(
        [&step = m_session.step(), &task = *task(), text](const BackgroundJob::Context &context) {
            return judge(step, task, text, context.shouldContinue());
        },
        [this](std::future<std::optional<Verdict>> verdict) { receive(std::move(verdict)); });
}

void TaskDesk::receive(std::future<std::optional<Verdict>> verdict)
{
    try {
        m_verdict = verdict.get();
    } catch (const std::exception &error) { // the lesson is at fault
        m_verdict.reset();
        m_session.showMessage(QString::fromUtf8(error.what()));
    }
    if (m_verdict && m_verdict->kind == Verdict::Kind::right) {
        const QString &lesson = m_session.lesson().id, &step = m_session.step().id;
        m_session.proofs().keep(Notes::keyOf(lesson, step, QStringLiteral("code"), m_sheet.task),
                                {.code = m_session.code().text()});
        m_session.progress().markWritten(lesson, step, m_sheet.task);
    }
    emit changed();
}

QString TaskDesk::sentence() const
{
    if (!task())
        return {};
    if (m_sheet.isSolutionShown)
        return tr("This is the solution. To get the tick, start again and write it yourself.");
    if (m_verdict)
        return sentenceFor(*m_verdict, *task());
    return isJudging() ? tr("Trying your code …") : QString();
}

}

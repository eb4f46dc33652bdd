#include "app/model/sandbox/sandbox_visit.h"

#include "app/model/sandbox/sandbox.h"

namespace app {

void SandboxVisit::note()
{
    if (m_session.isSandbox())
        return;
    m_lesson = m_session.lesson().id;
    m_step = m_session.step().id;
}

void SandboxVisit::comeBackTo(const QString &lesson, const QString &step)
{
    m_lesson = lesson;
    m_step = step;
}

void SandboxVisit::go()
{
    const LessonEntry *sandbox = sandboxOf(m_session.library());
    if (sandbox && !m_session.isSandbox())
        m_session.openStep(sandbox->id, sandbox->steps.front().id);
}

void SandboxVisit::comeBack()
{
    if (!m_session.isSandbox() || m_session.library().lessons.empty())
        return;
    const LessonEntry &first = m_session.library().lessons.front();
    m_lesson.isEmpty() ? m_session.openStep(first.id, first.steps.front().id)
                       : m_session.openStep(m_lesson, m_step);
}

}

#include "app/model/workshop_trip.h"

#include "app/model/workshop.h"

namespace app {

void WorkshopTrip::note()
{
    if (m_session.isWorkshop())
        return;
    m_lesson = m_session.lesson().id;
    m_step = m_session.step().id;
}

void WorkshopTrip::comeBackTo(const QString &lesson, const QString &step)
{
    m_lesson = lesson;
    m_step = step;
}

void WorkshopTrip::go()
{
    const LessonEntry *workshop = workshopOf(m_session.library());
    if (workshop && !m_session.isWorkshop())
        m_session.openStep(workshop->id, workshop->steps.front().id);
}

void WorkshopTrip::comeBack()
{
    if (!m_session.isWorkshop() || m_session.library().lessons.empty())
        return;
    const LessonEntry &first = m_session.library().lessons.front();
    m_lesson.isEmpty() ? m_session.openStep(first.id, first.steps.front().id)
                       : m_session.openStep(m_lesson, m_step);
}

}

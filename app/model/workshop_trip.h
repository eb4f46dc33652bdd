#pragma once

#include <QString>

namespace app {

class Session;

/// The way from a step to the workshop, and back to that step.
class WorkshopTrip
{
public:
    /// `session` must outlive it.
    explicit WorkshopTrip(Session &session) : m_session(session) {}

    /// Remembers the open step as the one to come back to, unless it is the workshop.
    void note();
    /// Remembers this step as the one to come back to.
    void comeBackTo(const QString &lesson, const QString &step);
    /// Opens the workshop, if one is installed.
    void go();
    /// Leaves the workshop for the step that was open before, or for the first one of all.
    void comeBack();

private:
    Session &m_session;
    QString m_lesson; ///< ids of the step to come back to
    QString m_step;
};

}

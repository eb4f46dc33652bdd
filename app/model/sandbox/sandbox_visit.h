#pragma once

#include <QString>

namespace app {

class Session;

/// Remembers the step from which the learner went to the sandbox, and goes back to it.
class SandboxVisit
{
public:
    /// `session` must outlive it.
    explicit SandboxVisit(Session &session) : m_session(session) {}

    /// Remembers the open step as the one to return to, unless it is the sandbox.
    void note();
    /// Remembers this step as the one to return to.
    void comeBackTo(const QString &lesson, const QString &step);
    /// Opens the sandbox, if one is installed.
    void go();
    /// Leaves the sandbox for the remembered step, or else for the first step of all.
    void comeBack();

private:
    Session &m_session;
    QString m_lesson; ///< ids of the step to return to
    QString m_step;
};

}

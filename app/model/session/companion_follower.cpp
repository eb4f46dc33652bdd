#include "app/model/session/companion_follower.h"

#include <QTimer>

#include <utility>

namespace app {

void CompanionFollower::open()
{
    m_companion.reset();
    if (m_run.step().companion)
        m_companion.emplace(*m_run.step().companion);
    follow();
}

bool CompanionFollower::follow()
{
    m_isThere =
        !m_companion || m_companion->follow(m_run.timeline().script(), m_preview.run().cursor().frame);
    return m_isThere;
}

void CompanionFollower::followSoon()
{
    if (follow() || std::exchange(m_isDue, true))
        return;
    QTimer::singleShot(0, this, [this] {
        m_isDue = false;
        m_run.changes().announce(ChangeKind::cursor);
    });
}

}

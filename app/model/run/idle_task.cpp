#include "app/model/run/idle_task.h"

#include <QElapsedTimer>

#include <algorithm>

namespace app {

IdleTask::IdleTask(Work work) : m_work(std::move(work))
{
    m_timer.setSingleShot(true);
    QObject::connect(&m_timer, &QTimer::timeout, &m_timer, [this] { runSlice(); });
}

IdleTask::IdleTask(std::function<bool()> next, std::function<void()> changed)
    : IdleTask([this, next = std::move(next), changed = std::move(changed)](double milliseconds) {
          QElapsedTimer clock;
          clock.start();
          bool any = false, isTimeOver = false;
          while (!isTimeOver && next()) {
              any = true;
              isTimeOver = static_cast<double>(clock.nsecsElapsed()) > 1e6 * milliseconds;
          }
          if (isTimeOver)
              goOn();
          if (any)
              changed();
      })
{
}

void IdleTask::goOn()
{
    m_timer.start(0);
}

void IdleTask::runSlice()
{
    m_work(m_timer.interval() > 0 ? small : whole);
}

void IdleTask::runWhileMoved()
{
    const bool breathes = m_timer.isActive() && m_timer.interval() > 0;
    const int left = breathes ? std::max(1, m_timer.remainingTime()) : breath;
    m_work(atOnce);
    if (m_timer.isActive())
        m_timer.start(left);
}

}

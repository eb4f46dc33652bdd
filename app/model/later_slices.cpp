#include "app/model/later_slices.h"

#include <algorithm>

namespace app {

LaterSlices::LaterSlices(std::function<void()> call)
{
    m_timer.setSingleShot(true);
    QObject::connect(&m_timer, &QTimer::timeout, &m_timer, std::move(call));
}

void LaterSlices::afterMove(const std::function<void()> &call)
{
    const bool breathes = m_timer.isActive() && m_timer.interval() > 0;
    const int left = breathes ? std::max(1, m_timer.remainingTime()) : breath;
    call();
    if (m_timer.isActive())
        m_timer.start(left);
}

}

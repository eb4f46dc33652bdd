#include "app/model/run/frame_clock.h"

#include <algorithm>

namespace app {

namespace {

// After the window was hidden or the machine was busy, at most this many frames are caught up at once.
constexpr double mostFramesAtOnce = 12.0;

}

FrameClock::FrameClock(QObject *parent) : QObject(parent)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &FrameClock::tick);
}

void FrameClock::setSpeed(double speed)
{
    m_speed = std::clamp(speed, slowest, fastest);
    // At most 60 ticks per second. Slower playback wakes up only when a frame is due.
    const double perSecond = std::min(60.0, framesPerSecond * m_speed);
    m_timer.setInterval(static_cast<int>(1000.0 / perSecond));
}

void FrameClock::play()
{
    m_isPlaying = true;
    setSpeed(m_speed);
    m_owed = 0.0;
    m_clock.start();
    m_timer.start();
}

void FrameClock::pause()
{
    m_isPlaying = false;
    m_timer.stop();
}

void FrameClock::wait()
{
    m_timer.stop();
}

void FrameClock::goOn()
{
    if (isWaiting())
        play();
}

void FrameClock::tick()
{
    m_owed += static_cast<double>(m_clock.restart()) / 1000.0 * framesPerSecond * m_speed;
    m_owed = std::min(m_owed, mostFramesAtOnce);
    const int frames = static_cast<int>(m_owed + 0.1);
    if (frames <= 0)
        return;
    m_owed = std::max(0.0, m_owed - frames);
    emit due(frames);
}

}

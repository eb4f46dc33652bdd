#include "app/model/player.h"

#include <algorithm>

namespace app {

namespace {

// A window that was hidden or a machine that was busy does not catch up for more than this.
constexpr double mostFramesAtOnce = 12.0;

}

Player::Player(QObject *parent) : QObject(parent)
{
    m_timer.setTimerType(Qt::PreciseTimer);
    connect(&m_timer, &QTimer::timeout, this, &Player::tick);
}

void Player::setSpeed(double speed)
{
    m_speed = std::clamp(speed, slowest, fastest);
    // At most 60 pictures a second; slower runs wake up only when a frame is due.
    const double perSecond = std::min(60.0, framesPerSecond * m_speed);
    m_timer.setInterval(static_cast<int>(1000.0 / perSecond));
}

void Player::play()
{
    m_isPlaying = true;
    setSpeed(m_speed);
    m_owed = 0.0;
    m_clock.start();
    m_timer.start();
}

void Player::pause()
{
    m_isPlaying = false;
    m_timer.stop();
}

void Player::wait()
{
    m_timer.stop();
}

void Player::goOn()
{
    if (isWaiting())
        play();
}

void Player::tick()
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

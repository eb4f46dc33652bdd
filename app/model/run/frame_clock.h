#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace app {

/// A clock that reports how many frames are due during playback. Its timer is stopped while the clock is paused or
/// waiting.
class FrameClock : public QObject
{
    Q_OBJECT

public:
    static constexpr double framesPerSecond = 30.0;
    static constexpr double slowest = 0.1;
    static constexpr double fastest = 4.0;

    explicit FrameClock(QObject *parent = nullptr);

    bool isPlaying() const { return m_isPlaying; }
    /// Returns whether playback is on, but reports no frames until goOn() is called.
    bool isWaiting() const { return m_isPlaying && !m_timer.isActive(); }
    double speed() const { return m_speed; }
    void setSpeed(double speed);
    void play();
    void pause();
    /// Stops the time until goOn() while playing.
    void wait();
    void goOn();

signals:
    void due(int frames);

private:
    void tick();

    bool m_isPlaying = false;
    QTimer m_timer;
    QElapsedTimer m_clock;
    double m_speed = 1.0;
    double m_owed = 0.0; ///< frames
};

}

#pragma once

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

namespace app {

/// Says how many frames are due while playing. Nothing runs while it is paused, or while it waits.
class Player : public QObject
{
    Q_OBJECT

public:
    static constexpr double framesPerSecond = 30.0;
    static constexpr double slowest = 0.1;
    static constexpr double fastest = 4.0;

    explicit Player(QObject *parent = nullptr);

    bool isPlaying() const { return m_isPlaying; }
    /// Whether it plays, but says nothing until it is told to go on.
    bool isWaiting() const { return m_isPlaying && !m_timer.isActive(); }
    double speed() const { return m_speed; }
    void setSpeed(double speed);
    void play();
    void pause();
    /// While playing: time stands still until goOn().
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

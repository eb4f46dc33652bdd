#pragma once

#include <QObject>
#include <QStringList>
#include <QWidget>

#include <random>

/// Somebody who presses any key and clicks anywhere, in a window and in whatever opens from it. What waits for an answer
/// (a dialog, a menu) gets some keys and is closed then.
class RandomHand : public QObject
{
    Q_OBJECT

public:
    RandomHand(QWidget &window, unsigned seed);

    /// Does one thing.
    void act();
    /// What was done last, for a message.
    QString last() const { return m_done.join(QStringLiteral(", ")); }

private:
    int below(int n) { return static_cast<int>(m_dice() % static_cast<unsigned>(n)); }
    void note(const QString &what);
    /// A window that is open, mostly the main one.
    QWidget *someWindow();
    /// A place that can be seen in one of them; null if there is none.
    QWidget *somewhere(QPoint &at);
    void key();
    void type();
    void click();
    void drag();
    void wheel();
    void hover();
    void command();
    void resize();
    /// Gives what waits a key.
    void answer();

    QWidget &m_window;
    std::mt19937 m_dice;
    QStringList m_done;
    int m_answered = 0; ///< keys for what waits now
};

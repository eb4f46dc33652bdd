#pragma once

#include <QObject>
#include <QStringList>
#include <QWidget>

#include <random>

/// A user who presses random keys and clicks random places, in a window and in all that opens from it. A dialog or menu
/// that waits for an answer gets some keys and is then closed.
class RandomUser : public QObject
{
    Q_OBJECT

public:
    RandomUser(QWidget &window, unsigned seed);

    /// Sends one random input.
    void act();
    /// Returns the last inputs, for a message.
    QString last() const { return m_done.join(QStringLiteral(", ")); }

private:
    int below(int n) { return static_cast<int>(m_dice() % static_cast<unsigned>(n)); }
    void note(const QString &what);
    /// Returns an open window, mostly the main one.
    QWidget *someWindow();
    /// Returns a visible widget at a random place in one of them, and the place in it; null if there is none.
    QWidget *somewhere(QPoint &at);
    void key();
    void type();
    void click();
    void drag();
    void wheel();
    void hover();
    void command();
    void resize();
    /// Sends a key to the dialog or menu that waits.
    void answer();

    QWidget &m_window;
    std::mt19937 m_dice;
    QStringList m_done;
    int m_answered = 0; ///< keys for what waits now
};

#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QList>
#include <QString>

/// What something takes, in ms.
struct Took
{
    double passed = 0.0; ///< by the clock
    double work = 0.0;   ///< of processor time of this thread: what a busy machine does not add to
};

/// The larger of each.
Took longer(Took a, Took b);

/// Counts from when it is made.
class Stopwatch
{
public:
    Stopwatch();
    Took took() const;

private:
    QElapsedTimer m_clock;
    double m_before; ///< ms of processor time
};

/// Keeps in mind which events took the most work. An event that another one sends is part of that.
class WatchedApplication : public QApplication
{
public:
    using QApplication::QApplication;

    struct Delivery
    {
        Took took;
        QString what;
    };

    bool notify(QObject *receiver, QEvent *event) override;
    /// The three with the most work since the last call, the most first.
    QList<Delivery> slowest();

private:
    bool m_isWithin = false;
    QList<Delivery> m_slow;
};

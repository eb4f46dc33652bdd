#pragma once

#include <QApplication>
#include <QElapsedTimer>
#include <QList>
#include <QString>

/// The duration of something, ms.
struct Took
{
    double passed = 0.0; ///< wall-clock time
    double work = 0.0;   ///< processor time of this thread, which does not depend on the load of the machine
};

/// Returns the larger of each time.
Took longer(Took a, Took b);

/// A stopwatch that starts when it is constructed.
class Stopwatch
{
public:
    Stopwatch();
    Took took() const;

private:
    QElapsedTimer m_clock;
    double m_before; ///< ms of processor time
};

/// An application that records the events that took the most time. The time of an event includes the events
/// that it sends.
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
    /// Returns the three longest events since the last call, the longest first.
    QList<Delivery> slowest();

private:
    bool m_isWithin = false;
    QList<Delivery> m_slow;
};

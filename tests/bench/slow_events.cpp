#include "tests/bench/slow_events.h"

#include <algorithm>
#include <ctime>
#include <utility>

namespace {

constexpr double leastWork = 1.0; ///< ms; shorter events are not recorded

/// Returns the processor time of this thread, ms.
double threadTime()
{
    timespec time{};
    clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return 1e3 * static_cast<double>(time.tv_sec) + 1e-6 * static_cast<double>(time.tv_nsec);
}

}

Took longer(Took a, Took b)
{
    return {std::max(a.passed, b.passed), std::max(a.work, b.work)};
}

Stopwatch::Stopwatch() : m_before(threadTime())
{
    m_clock.start();
}

Took Stopwatch::took() const
{
    return {static_cast<double>(m_clock.nsecsElapsed()) / 1e6, threadTime() - m_before};
}

bool WatchedApplication::notify(QObject *receiver, QEvent *event)
{
    if (m_isWithin)
        return QApplication::notify(receiver, event);
    m_isWithin = true;
    // The event may delete both.
    const char *const name = receiver->metaObject()->className();
    const char *const owner = receiver->parent() ? receiver->parent()->metaObject()->className() : "nobody";
    const QEvent::Type type = event->type();
    const Stopwatch watch;
    const bool answer = QApplication::notify(receiver, event);
    const Took took = watch.took();
    m_isWithin = false;
    if (took.work > leastWork)
        m_slow.push_back(
            {took, QString("%1 for %2 of %3").arg(QVariant::fromValue(type).toString(), name, owner)});
    return answer;
}

QList<WatchedApplication::Delivery> WatchedApplication::slowest()
{
    std::sort(m_slow.begin(), m_slow.end(),
              [](const Delivery &a, const Delivery &b) { return a.took.work > b.took.work; });
    return std::exchange(m_slow, {}).mid(0, 3);
}

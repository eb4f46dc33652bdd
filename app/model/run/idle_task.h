#pragma once

#include <QTimer>

#include <functional>

namespace app {

/// Runs work in slices of a few milliseconds between window events, until no work is left. While the user drags the
/// cursor it does less, so that each moment is painted before more work is done.
class IdleTask
{
public:
    /// Does part of the work for about `milliseconds`, and calls goOn() if some is left.
    using Work = std::function<void(double milliseconds)>;

    explicit IdleTask(Work work);
    /// Does the work piece by piece: calls `next`, which returns false if nothing is left, and `changed` after each slice
    /// in which something was done.
    IdleTask(std::function<bool()> next, std::function<void()> changed);

    /// Runs one full slice now.
    void run() { m_work(whole); }
    /// Runs a very small slice while the user drags the cursor. The next slice follows after a short pause, even if
    /// the user keeps dragging.
    void runWhileMoved();
    /// Schedules the next slice for the next turn of the event loop.
    void goOn();
    void stop() { m_timer.stop(); }
    bool isDue() const { return m_timer.isActive(); }

private:
    static constexpr double whole = 4.0;  ///< ms
    static constexpr double small = 2.0;  ///< ms, after a pause
    static constexpr double atOnce = 1.0; ///< ms, before the result of a move is painted
    static constexpr int breath = 8;      ///< ms

    void runSlice();

    Work m_work;
    QTimer m_timer;
};

}

#pragma once

#include <QTimer>

#include <functional>

namespace app {

/// Goes on with some work as long as that asks for it, a few milliseconds at a time, between what the window has to do.
/// While somebody drags the cursor it holds back, so that each moment is painted before anything is read on.
class LaterSlices
{
public:
    /// Does some of the work, for about so many milliseconds, and calls goOn() if there is more.
    using Work = std::function<void(double milliseconds)>;

    explicit LaterSlices(Work work);

    /// What fits into one turn, now.
    void run() { m_work(whole); }
    /// The same while the cursor is moved by hand: very little, and the next slice comes after a breath. A hand that moves on
    /// does not put it off for ever.
    void runWhileMoved();
    /// There is more: the next slice comes in the next turn.
    void goOn();
    void stop() { m_timer.stop(); }
    bool isDue() const { return m_timer.isActive(); }

private:
    static constexpr double whole = 4.0;  ///< ms
    static constexpr double small = 2.0;  ///< ms, after a breath
    static constexpr double atOnce = 1.0; ///< ms, before what a move has changed is painted
    static constexpr int breath = 8;      ///< ms

    void runSlice();

    Work m_work;
    QTimer m_timer;
};

}

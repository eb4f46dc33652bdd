#pragma once

#include <QTimer>

#include <functional>

namespace app {

/// Calls a function again and again as long as it asks for that, each time for a few milliseconds, between what the window
/// has to do. While somebody drags the cursor it waits a little, so that each moment is painted before it is read on.
class LaterSlices
{
public:
    static constexpr double slice = 4.0; ///< ms: so long a call should take
    /// So long it should take where it is called while the cursor moves.
    static constexpr double atOnce = 1.0;
    static constexpr int breath = 8; ///< ms after a move until it goes on

    explicit LaterSlices(std::function<void()> call);

    /// Calls in the next turn.
    void goOn() { m_timer.start(0); }
    void stop() { m_timer.stop(); }
    bool isDue() const { return m_timer.isActive(); }
    /// Runs `call`, which may ask for more, for a cursor that was moved by hand: more comes after a breath. A hand that moves
    /// on does not put it off for ever.
    void afterMove(const std::function<void()> &call);

private:
    QTimer m_timer;
};

}

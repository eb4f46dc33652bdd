#pragma once

#include "app/model/session/playback.h"

#include <QDeadlineTimer>

namespace app {

/// Limits how often numbers change while the run plays: at most ten times a second, because faster changes cannot be read.
class NumberPace
{
public:
    /// `playback` must outlive it.
    explicit NumberPace(const Playback &playback) : m_playback(playback) {}

    /// Returns whether the numbers may change now.
    bool isDue() const { return !m_playback.isPlaying() || m_next.hasExpired(); }
    /// The numbers change now. A little less than 100 ms later they may change again, so that every third frame is shown
    /// although the timer of the playback is not exact.
    void restart() { m_next.setRemainingTime(90); }
    /// The numbers may change at once.
    void reset() { m_next = {}; }

private:
    const Playback &m_playback;
    QDeadlineTimer m_next;
};

}

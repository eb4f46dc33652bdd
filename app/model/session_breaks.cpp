// Where a session stops by itself.

#include "app/model/session.h"

#include <QElapsedTimer>

#include <algorithm>

namespace app {

namespace {

constexpr qint64 sliceMilliseconds = 12;

}

void Session::watchBreakpoints()
{
    connect(&m_breakpoints, &Breakpoints::changed, this, [this] {
        m_watch.watch(m_breakpoints.all(), step());
        if (!isResting())
            return;
        m_player.goOn(); // it may come to something now
        emit playingChanged();
    });
    connect(this, &Session::moved, this, [this] {
        if (m_hit && m_hit->at != m_timeline->at())
            m_hit.reset();
    });
}

void Session::stopFor(const BreakHit &hit)
{
    pause();
    m_hit = hit;
}

std::optional<BreakHit> Session::stepRow()
{
    const sim::Cursor rowEnd{m_timeline->at().frame + m_timeline->track().rowFrames(), 0};
    if (m_watch.isWatching())
        return m_watch.run(*m_timeline, rowEnd);
    m_timeline->seek(rowEnd);
    return std::nullopt;
}

void Session::runTo(sim::Cursor cursor)
{
    pause();
    if (!m_watch.isWatching() || cursor <= m_timeline->at()) {
        goTo(cursor);
        return;
    }
    wakeUp();
    m_goingTo = cursor;
    m_stopsOnTheWay = true;
    approach();
    checkTries();
    emit moved();
}

void Session::runOn()
{
    QElapsedTimer clock;
    clock.start();
    const int rowFrames = m_timeline->track().rowFrames();
    const sim::Cursor goal{m_goingTo->frame / rowFrames * rowFrames, m_goingTo->phase};
    const auto isThere = [&] {
        const std::optional<sim::Stop> &stop = m_timeline->stop();
        return m_timeline->at() >= goal || (stop && m_timeline->at().frame >= stop->frame);
    };
    std::optional<BreakHit> hit;
    while (!hit && !isThere() && clock.elapsed() < sliceMilliseconds) {
        const sim::Cursor rowEnd{m_timeline->at().frame + rowFrames, 0};
        if (m_timeline->isOver() && !m_watch.mayStillStop(*m_timeline))
            m_timeline->seek(goal);
        else
            hit = m_watch.run(*m_timeline, std::min(goal, rowEnd));
    }
    if (!hit && !isThere()) {
        approachLater();
        return;
    }
    m_goingTo.reset();
    if (hit)
        stopFor(*hit);
}

}

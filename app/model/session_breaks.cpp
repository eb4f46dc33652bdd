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
        if (m_hit && m_hit->at != m_timeline->cursor())
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
    const sim::Cursor outputEnd{m_timeline->cursor().frame + m_timeline->track().framesPerOutput(), 0};
    if (m_watch.isWatching())
        return m_watch.run(*m_timeline, outputEnd);
    m_timeline->seek(outputEnd);
    return std::nullopt;
}

void Session::runTo(sim::Cursor cursor)
{
    pause();
    if (!m_watch.isWatching() || cursor <= m_timeline->cursor()) {
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
    const int framesPerOutput = m_timeline->track().framesPerOutput();
    const sim::Cursor goal{m_goingTo->frame / framesPerOutput * framesPerOutput, m_goingTo->phase};
    const auto isThere = [&] {
        const std::optional<sim::Stop> &stop = m_timeline->stop();
        return m_timeline->cursor() >= goal || (stop && m_timeline->cursor().frame >= stop->frame);
    };
    std::optional<BreakHit> hit;
    while (!hit && !isThere() && clock.elapsed() < sliceMilliseconds) {
        const sim::Cursor outputEnd{m_timeline->cursor().frame + framesPerOutput, 0};
        if (m_timeline->isFinished() && !m_watch.mayStillStop(*m_timeline))
            m_timeline->seek(goal);
        else
            hit = m_watch.run(*m_timeline, std::min(goal, outputEnd));
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

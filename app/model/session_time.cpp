// The time of a session: playing, stepping, and going to a moment.

#include "app/model/sentences.h"
#include "app/model/session.h"

#include <QElapsedTimer>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr qint64 sliceMilliseconds = 12;
constexpr std::int64_t sliceSteps = 64;

}

void Session::setSpeed(double speed)
{
    m_player.setSpeed(speed);
    emit playingChanged();
}

void Session::play()
{
    if (isPlaying())
        return;
    m_goingTo.reset();
    m_player.play();
    emit playingChanged();
}

void Session::pause()
{
    m_goingTo.reset();
    if (!isPlaying())
        return;
    m_player.pause();
    emit playingChanged();
}

void Session::togglePlaying()
{
    isPlaying() ? pause() : play();
}

void Session::frameForward()
{
    pause();
    advance(1);
}

void Session::frameBack()
{
    pause();
    m_timeline->stepRowBack();
    checkTries();
    emit moved();
}

void Session::phaseForward()
{
    pause();
    m_timeline->stepPhase();
    checkTries();
    emit moved();
}

void Session::phaseBack()
{
    pause();
    m_timeline->stepPhaseBack();
    checkTries();
    emit moved();
}

void Session::goTo(sim::Cursor cursor)
{
    m_goingTo = {std::max<std::int64_t>(0, cursor.frame), cursor.phase};
    approach();
    checkTries();
    emit moved();
}

void Session::approach()
{
    if (!m_goingTo)
        return;
    QElapsedTimer clock;
    clock.start();
    const int rowFrames = m_timeline->track().rowFrames();
    const std::int64_t target = m_goingTo->frame;
    const std::int64_t slice =
        std::max<std::int64_t>(1, sliceSteps / m_timeline->script().step.perRow) * rowFrames;
    // Frames that were computed before, and every way back, cost one seek at the most.
    if (target <= m_timeline->computed())
        m_timeline->seek({target, 0});
    while (m_timeline->at().frame + rowFrames <= target && clock.elapsed() < sliceMilliseconds &&
           !m_timeline->stop())
        m_timeline->seek({std::min(target, m_timeline->at().frame + slice), 0});
    const bool isThere = m_timeline->at().frame + rowFrames > target || m_timeline->stop();
    if (bringCompanion() && isThere) {
        const int phase = m_goingTo->phase;
        m_goingTo.reset();
        if (phase > 0)
            m_timeline->seek({m_timeline->at().frame, phase});
        return;
    }
    // One call at a time, however often the goal changes meanwhile.
    if (std::exchange(m_approachDue, true))
        return;
    QTimer::singleShot(0, this, [this] {
        m_approachDue = false;
        approach();
        checkTries();
        emit moved();
    });
}

void Session::rewind()
{
    pause();
    goTo({});
}

void Session::startAfresh()
{
    pause();
    sim::Script before = m_timeline->script();
    start(step().script(), {});
    remember({tr("Start afresh"), {}}, std::move(before));
}

void Session::advance(int frames)
{
    const bool wasStopped = m_timeline->stop().has_value();
    for (int i = 0; i < frames; ++i) {
        m_timeline->stepRow();
        checkTries();
    }
    const std::optional<sim::Stop> &stop = m_timeline->stop();
    if (stop && m_timeline->at().frame == stop->frame) {
        if (isPlaying() || !wasStopped)
            emit said(sentenceFor(*stop));
        pause();
    }
    emit moved();
}

}

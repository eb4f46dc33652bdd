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

/// How many frames later it is looked whether something to try is done by waiting. What sleeps is there at once; what does not
/// yet is computed if its points are not too many.
constexpr int manyPoints = 1000;
constexpr std::int64_t laterFrames[] = {10, 30, 100, 300, 1000};

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
    wakeUp();
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
    wakeUp();
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
           !m_timeline->stop()) {
        const std::int64_t next = m_timeline->isOver() ? target : m_timeline->at().frame + slice;
        m_timeline->seek({std::min(target, next), 0});
    }
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
    start(step().script(), {});
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
    waitIfOver();
}

void Session::wakeUp()
{
    m_foresight.forget();
    m_ghostForesight.forget();
    m_player.goOn();
}

bool Session::isOver()
{
    const sim::Track *ghost = m_timeline->ghost();
    const sim::Track *companion = m_companion ? m_companion->track() : nullptr;
    return m_timeline->at().frame >= m_timeline->computed() && m_companionIsThere &&
           (!companion || companion->isOver()) && m_foresight.isOver(m_timeline->track()) &&
           (!ghost || m_ghostForesight.isOver(*ghost));
}

void Session::waitIfOver()
{
    if (!isPlaying() || !isOver() || timeAloneGetsSomethingDone())
        return;
    m_player.wait();
    emit playingChanged();
}

bool Session::timeAloneGetsSomethingDone() const
{
    const std::vector<lessons::Try> &tries = step().tries;
    const auto isOpen = [&](int i) {
        const lessons::Try &one = tries[static_cast<std::size_t>(i)];
        return !m_progress.isDone(lesson().id, step().id, i) && !one.done(*m_timeline);
    };
    std::vector<int> open;
    for (int i = 0; i < static_cast<int>(tries.size()); ++i) {
        if (isOpen(i))
            open.push_back(i);
    }
    if (open.empty())
        return false;
    if (m_timeline->now().points() > manyPoints && !m_timeline->isOver())
        return true; // to find out takes too long before it sleeps
    sim::Timeline later = *m_timeline;
    for (const std::int64_t frames : laterFrames) {
        later.seek({m_timeline->at().frame + frames, 0});
        for (const int i : open) {
            if (tries[static_cast<std::size_t>(i)].done(later))
                return true;
        }
    }
    return false;
}

}

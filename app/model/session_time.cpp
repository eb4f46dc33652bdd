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
constexpr std::int64_t slicePoints =
    100'000; ///< points times steps that are computed in one go, if that is less
constexpr qint64 mostMilliseconds =
    25; ///< of computing between two pictures while playing; drawing needs time, too
constexpr int framesToJudge = 45;   ///< due while playing, after which a run that falls behind is said to
constexpr double fallsBehind = 0.8; ///< of what is due

/// The input that a run of `step` with the values of `script` begins with.
std::vector<sim::Event> openingInput(const lessons::Step &step, const sim::Script &script)
{
    return step.prepareScript ? step.scriptWith(script.values, script.method).input
                              : std::vector<sim::Event>();
}

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
    lookNoMore();
    m_goingTo.reset();
    m_due = m_played = 0;
    wakeUp();
    m_player.play();
    emit playingChanged();
}

void Session::pause()
{
    lookNoMore();
    m_goingTo.reset();
    if (!isPlaying())
        return;
    m_player.pause();
    checkTries(); // some are done only while the run stands
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
    const sim::Cursor at = m_timeline->cursor();
    goTo({at.phase > 0 ? at.frame : at.frame - m_timeline->track().framesPerOutput(), 0});
}

void Session::phaseForward()
{
    pause();
    m_timeline->nextPhase();
    checkTries();
    emit moved();
}

void Session::phaseBack()
{
    pause();
    m_timeline->previousPhase();
    checkTries();
    emit moved();
}

void Session::goTo(sim::Cursor cursor)
{
    lookNoMore();
    m_goingTo = {std::max<std::int64_t>(0, cursor.frame), cursor.phase};
    m_stopsOnTheWay = false;
    wakeUp();
    approach();
    checkTries();
    emit moved();
}

void Session::approach()
{
    if (!m_goingTo)
        return;
    if (m_stopsOnTheWay) {
        runOn();
        return;
    }
    QElapsedTimer clock;
    clock.start();
    const int framesPerOutput = m_timeline->track().framesPerOutput();
    const std::int64_t target = m_goingTo->frame;
    const std::int64_t steps = std::min(sliceSteps, slicePoints / m_timeline->state().pointCount());
    const std::int64_t slice =
        std::max<std::int64_t>(1, steps / m_timeline->script().step.stepsPerOutput) * framesPerOutput;
    // Back, or far on, to the nearest moment that is kept.
    const std::int64_t kept = m_timeline->track().cachedFrameBefore(target);
    if (target < m_timeline->cursor().frame || kept > m_timeline->cursor().frame)
        m_timeline->seek({kept, 0});
    else if (m_timeline->cursor().phase > 0 && target == m_timeline->cursor().frame)
        m_timeline->seek({target, 0});
    const auto isThere = [&] {
        const std::optional<sim::Stop> &stop = m_timeline->stop();
        return m_timeline->cursor().frame + framesPerOutput > target ||
               (stop && m_timeline->cursor().frame >= stop->frame);
    };
    while (!isThere() && clock.elapsed() < sliceMilliseconds) {
        const std::int64_t next = m_timeline->isFinished() ? target : m_timeline->cursor().frame + slice;
        m_timeline->seek({std::min(target, next), 0});
    }
    if (bringCompanion() && isThere()) {
        const int phase = m_goingTo->phase;
        m_goingTo.reset();
        if (phase > 0)
            m_timeline->seek({m_timeline->cursor().frame, phase});
        return;
    }
    approachLater();
}

void Session::approachLater()
{
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

void Session::judgePace(int due, int played)
{
    const bool isJudged = m_due >= framesToJudge;
    m_due += due;
    m_played += played;
    if (isPlaying() && !isJudged && m_due >= framesToJudge && m_played < fallsBehind * m_due)
        emit said(tr("Too much to compute for 30 frames a second: it plays slower than that. The run stays "
                     "the same."));
}

void Session::restart()
{
    pause();
    letGo();
    letUp();
    if (hasInput()) {
        sim::Script script = m_timeline->script();
        script.values = m_timeline->values();
        script.input = openingInput(step(), script);
        m_timeline->seek({});
        edit({tr("Restart"), tr("the restart")},
             [&](sim::Timeline &timeline) { return timeline.replaceScript(std::move(script)); });
        showBeside(0); // a ghost would do again what is to be gone
        emit said(tr("A fresh run. The run as it was is under “Runs”, and undo (Ctrl+Z) brings it back."));
    }
    goTo({});
}

void Session::repeat()
{
    pause();
    goTo({});
    play();
}

bool Session::hasInput() const
{
    return m_timeline->script().input != openingInput(step(), m_timeline->script());
}

std::optional<sim::Vec2> Session::recordedHand() const
{
    if (!isGlancing() && (m_holding || m_pointerDown || m_timeline->hasPendingInput()))
        return {};
    const sim::State &now = shown().state();
    if (now.hold.point >= 0)
        return now.positionOf(now.hold.point);
    return now.input.pointerDown ? now.input.pointer : std::nullopt;
}

void Session::startTimeByHand()
{
    const sim::Cursor at = m_timeline->cursor();
    const bool isAtAnEnd = at.phase == 0 && (at.frame == 0 || at.frame >= m_timeline->computed());
    if (isPlaying() || isWorkshop() || m_timeline->stop() || !isAtAnEnd)
        return;
    play();
    emit said(tr("Time runs while your hand moves things. Space stops it."));
}

void Session::sayThatTimeStands()
{
    if (!isPlaying())
        emit said(tr("Time stands still. Space lets it run from here."));
}

void Session::startAfresh()
{
    pause();
    startAnew({tr("Start afresh"), {}}, step().script());
}

void Session::advance(int frames)
{
    const bool wasStopped = m_timeline->stop().has_value();
    QElapsedTimer clock;
    clock.start();
    int played = 0;
    std::optional<BreakHit> hit;
    for (; !hit && played < frames && (played == 0 || clock.elapsed() < mostMilliseconds); ++played) {
        hit = stepRow();
        checkTries();
    }
    if (hit)
        stopFor(*hit);
    else
        judgePace(frames, played);
    const std::optional<sim::Stop> &stop = m_timeline->stop();
    if (stop && m_timeline->cursor().frame == stop->frame) {
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
    m_hit.reset();
    m_player.goOn();
}

bool Session::isOver()
{
    const sim::Track *ghost = m_timeline->comparison();
    const sim::Track *companion = m_companion ? m_companion->track() : nullptr;
    return m_timeline->cursor().frame >= m_timeline->computed() && m_companionIsThere &&
           (!companion || companion->isFinished()) && m_foresight.isOver(m_timeline->track()) &&
           (!ghost || m_ghostForesight.isOver(*ghost));
}

void Session::waitIfOver()
{
    if (!isPlaying() || !isOver() || m_watch.mayStillStop(*m_timeline) ||
        m_attempts.mayBeDoneByWaiting(lesson().id, step(), *m_timeline))
        return;
    m_player.wait();
    emit playingChanged();
}

}

#include "app/model/session/playback.h"

#include "app/model/listing/listing_frame.h"
#include "app/model/run/run_program.h"

#include <QElapsedTimer>
#include <QTimer>

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr qint64 seekMilliseconds = 12;
constexpr std::int64_t seekSteps = 64;
constexpr std::int64_t seekPoints =
    100'000;                            ///< points times steps that are computed in one go, if that is less
constexpr qint64 playMilliseconds = 25; ///< of computing between two repaints; painting needs time, too
constexpr int framesToJudge = 45;       ///< due frames, after which slow playback is reported
constexpr double fallsBehind = 0.8;     ///< of the due frames

}

Playback::Playback(OpenRun &run, Preview &preview, CompanionFollower &companion, Attempts &attempts)
    : m_run(run), m_preview(preview), m_companion(companion), m_attempts(attempts)
{
    connect(&m_clock, &FrameClock::due, this, &Playback::advance);
    connect(&m_attempts, &Attempts::checkDue, this, &Playback::checkAttempts);
    connect(&m_breakpoints, &Breakpoints::changed, this, [this] {
        m_monitor.watch(m_breakpoints.all(), m_run.step());
        if (!isWaiting())
            return;
        m_clock.goOn(); // the run may reach a breakpoint now
        m_run.changes().announce(ChangeKind::playing);
    });
}

void Playback::open()
{
    stopSeeking();
    m_end.reset();
    m_breakpoints.open(m_run.key());
    m_monitor.watch(m_breakpoints.all(), m_run.step());
}

bool Playback::isPlaying() const
{
    const auto *seeking = std::get_if<Seeking>(&m_state);
    return std::holds_alternative<Playing>(m_state) || (seeking && seeking->thenPlays);
}

std::optional<std::int64_t> Playback::goal() const
{
    const auto *seeking = std::get_if<Seeking>(&m_state);
    return seeking ? std::optional(seeking->goal.frame) : std::nullopt;
}

void Playback::setSpeed(double speed)
{
    m_clock.setSpeed(speed);
    m_run.changes().announce(ChangeKind::playing);
}

void Playback::play()
{
    if (isPlaying())
        return;
    const ChangeNotifier::Batch batch(m_run.changes());
    m_preview.endIfShown();
    wakeUp();
    m_state = Playing{};
    m_clock.play();
    m_run.changes().announce(ChangeKind::playing);
}

void Playback::pause()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    m_preview.endIfShown();
    const bool wasPaused = std::holds_alternative<Paused>(m_state);
    m_clock.pause();
    m_state = Paused{};
    if (!wasPaused)
        m_run.changes().announce(ChangeKind::playing);
}

void Playback::togglePlaying()
{
    isPlaying() ? pause() : play();
}

void Playback::repeat()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    pause();
    goTo({});
    play();
}

void Playback::startForInput()
{
    const sim::Timeline &timeline = m_run.timeline();
    const sim::Cursor at = timeline.cursor();
    const bool isAtAnEnd = at.phase == 0 && (at.frame == 0 || at.frame >= timeline.computed());
    if (isPlaying() || m_run.step().points == lessons::PointSource::scene || timeline.stop() || !isAtAnEnd)
        return;
    play();
    m_run.showMessage(tr("The run plays while you drag. Press Space to stop it."));
}

void Playback::reportIfPaused()
{
    if (!isPlaying())
        m_run.showMessage(tr("The run is paused. Press Space to play from here."));
}

void Playback::frameForward()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    pause();
    advance(1);
}

void Playback::frameBack()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    pause();
    const sim::Cursor at = m_run.timeline().cursor();
    goTo({at.phase > 0 ? at.frame : at.frame - m_run.timeline().track().framesPerOutput(), 0});
}

void Playback::phaseForward()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    pause();
    m_hit.reset();
    m_run.timeline().nextPhase();
    m_run.changes().announce(ChangeKind::cursor);
}

void Playback::phaseBack()
{
    const ChangeNotifier::Batch batch(m_run.changes());
    pause();
    m_hit.reset();
    m_run.timeline().previousPhase();
    m_run.changes().announce(ChangeKind::cursor);
}

void Playback::goTo(sim::Cursor cursor)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    m_preview.endIfShown();
    wakeUp();
    const bool thenPlays = isPlaying();
    m_clock.pause();
    m_state = Seeking{{std::max<std::int64_t>(0, cursor.frame), cursor.phase}, false, thenPlays};
    seekSlice();
}

void Playback::goToPaused(sim::Cursor cursor)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    goTo(cursor);
    auto *seeking = std::get_if<Seeking>(&m_state);
    if (!seeking || !std::exchange(seeking->thenPlays, false))
        return;
    m_run.changes().announce(ChangeKind::playing);
}

void Playback::runTo(sim::Cursor cursor)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    pause();
    if (!m_monitor.isWatching() || cursor <= m_run.timeline().cursor()) {
        goTo(cursor);
        return;
    }
    wakeUp();
    m_state = Seeking{cursor, true, false};
    seekSlice();
}

void Playback::runToLine(int lines)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    pause();
    m_hit.reset();
    if (const std::optional<BreakHit> hit = m_monitor.hitBeforeLine(m_run.timeline(), lines))
        stopAt(*hit);
    else if (m_stopAtLine)
        m_stopAtLine(lines);
}

void Playback::stopSeeking()
{
    const auto *seeking = std::get_if<Seeking>(&m_state);
    if (!seeking)
        return;
    if (seeking->thenPlays)
        arrive();
    else
        m_state = Paused{};
}

void Playback::wakeUp()
{
    m_rest.forget();
    m_comparisonRest.forget();
    m_hit.reset();
    m_clock.goOn();
}

void Playback::checkAttempts()
{
    m_attempts.setOwnRun(!m_run.isGiven());
    m_attempts.check(m_run.lesson().id, m_run.step(), m_run.timeline(), isPlaying());
}

void Playback::arrive()
{
    const Seeking seeking = std::get<Seeking>(std::exchange(m_state, Paused{}));
    if (!seeking.thenPlays)
        return;
    m_state = Playing{};
    m_clock.play();
}

void Playback::seekSlice()
{
    const auto *found = std::get_if<Seeking>(&m_state);
    if (!found)
        return;
    const Seeking seeking = *found;
    if (seeking.stopsAtBreakpoints) {
        runSlice(seeking);
        m_run.changes().announce(ChangeKind::cursor);
        return;
    }
    QElapsedTimer clock;
    clock.start();
    sim::Timeline &timeline = m_run.timeline();
    const int framesPerOutput = timeline.track().framesPerOutput();
    const std::int64_t target = seeking.goal.frame;
    const std::int64_t steps = std::min(seekSteps, seekPoints / timeline.state().pointCount());
    const std::int64_t slice =
        std::max<std::int64_t>(1, steps / timeline.script().step.stepsPerOutput) * framesPerOutput;
    // Start at the keyframe before the goal, if that is nearer than the cursor.
    const std::int64_t kept = timeline.track().cachedFrameBefore(target);
    if (target < timeline.cursor().frame || kept > timeline.cursor().frame)
        timeline.seek({kept, 0});
    else if (timeline.cursor().phase > 0 && target == timeline.cursor().frame)
        timeline.seek({target, 0});
    const auto isThere = [&] {
        const std::optional<sim::Stop> &stop = timeline.stop();
        return timeline.cursor().frame + framesPerOutput > target ||
               (stop && timeline.cursor().frame >= stop->frame);
    };
    while (!isThere() && clock.elapsed() < seekMilliseconds) {
        const std::int64_t next = timeline.isFinished() ? target : timeline.cursor().frame + slice;
        timeline.seek({std::min(target, next), 0});
    }
    if (m_companion.follow() && isThere()) {
        arrive();
        if (seeking.goal.phase > 0)
            timeline.seek({timeline.cursor().frame, seeking.goal.phase});
    } else {
        seekLater();
    }
    m_run.changes().announce(ChangeKind::cursor);
}

void Playback::runSlice(const Seeking &seeking)
{
    QElapsedTimer clock;
    clock.start();
    sim::Timeline &timeline = m_run.timeline();
    const int framesPerOutput = timeline.track().framesPerOutput();
    const sim::Cursor goal{seeking.goal.frame / framesPerOutput * framesPerOutput, seeking.goal.phase};
    const auto isThere = [&] {
        const std::optional<sim::Stop> &stop = timeline.stop();
        return timeline.cursor() >= goal || (stop && timeline.cursor().frame >= stop->frame);
    };
    std::optional<BreakHit> hit;
    while (!hit && !isThere() && clock.elapsed() < seekMilliseconds) {
        const sim::Cursor outputEnd{timeline.cursor().frame + framesPerOutput, 0};
        if (timeline.isFinished() && !m_monitor.mayStillStop(timeline))
            timeline.seek(goal);
        else
            hit = m_monitor.run(timeline, std::min(goal, outputEnd));
    }
    if (!hit && !isThere()) {
        seekLater();
        return;
    }
    arrive();
    if (hit)
        stopAt(*hit);
}

void Playback::seekLater()
{
    // One call at a time, even if the goal changes meanwhile.
    if (std::exchange(m_isSliceDue, true))
        return;
    QTimer::singleShot(0, this, [this] {
        m_isSliceDue = false;
        const ChangeNotifier::Batch batch(m_run.changes());
        seekSlice();
    });
}

void Playback::stopAt(const BreakHit &hit)
{
    pause();
    m_hit = hit;
    if (hit.lines > 0 && m_stopAtLine)
        m_stopAtLine(hit.lines);
}

void Playback::stopAtMistake()
{
    const std::shared_ptr<const ListingFrame> frame = m_linesAhead ? m_linesAhead().frame : nullptr;
    if (!frame || !frame->error() || !m_stopAtLine)
        return;
    int last = frame->count() - 1;
    for (int i = last; i > 0; --i) {
        if (frame->line(i).line == frame->error()->line) {
            last = i;
            break;
        }
    }
    if (last > 0)
        m_stopAtLine(last);
}

void Playback::setLines(std::function<LinesAhead()> ahead, std::function<void(int)> stopAtLine)
{
    m_linesAhead = ahead;
    m_monitor.setLines(std::move(ahead));
    m_stopAtLine = std::move(stopAtLine);
}

std::optional<BreakHit> Playback::advanceOneOutput()
{
    sim::Timeline &timeline = m_run.timeline();
    const sim::Cursor outputEnd{timeline.cursor().frame + timeline.track().framesPerOutput(), 0};
    m_hit.reset();
    if (m_monitor.isWatching())
        return m_monitor.run(timeline, outputEnd);
    timeline.seek(outputEnd);
    return std::nullopt;
}

void Playback::advance(int frames)
{
    const ChangeNotifier::Batch batch(m_run.changes());
    sim::Timeline &timeline = m_run.timeline();
    const bool wasStopped = timeline.stop().has_value();
    QElapsedTimer clock;
    clock.start();
    int played = 0;
    std::optional<BreakHit> hit;
    bool isAtEnd = false;
    for (; !hit && !isAtEnd && played < frames && (played == 0 || clock.elapsed() < playMilliseconds);
         ++played) {
        const std::int64_t before = timeline.cursor().frame;
        hit = advanceOneOutput();
        isAtEnd = m_end && before < *m_end && timeline.cursor().frame >= *m_end;
        checkAttempts();
    }
    if (isAtEnd) {
        m_end.reset();
        pause();
    }
    if (hit)
        stopAt(*hit);
    else if (auto *playing = std::get_if<Playing>(&m_state))
        judgePace(*playing, frames, played);
    const std::optional<sim::Stop> &stop = timeline.stop();
    if (stop && timeline.cursor().frame == stop->frame) {
        const bool isNews = isPlaying() || !wasStopped;
        if (isNews)
            m_run.showMessage(endSentence(timeline.track()));
        pause();
        if (isNews)
            stopAtMistake();
    }
    m_run.changes().announce(ChangeKind::cursor);
    waitIfOver();
}

void Playback::judgePace(Playing &playing, int due, int played)
{
    const bool isJudged = playing.due >= framesToJudge;
    playing.due += due;
    playing.played += played;
    if (!isJudged && playing.due >= framesToJudge && playing.played < fallsBehind * playing.due)
        m_run.showMessage(tr("Too much to compute at 30 frames a second: the run plays more slowly. Its "
                             "numbers stay the same."));
}

bool Playback::isOver()
{
    const sim::Timeline &timeline = m_run.timeline();
    const sim::Track *comparison = timeline.comparison();
    const sim::Track *companion = m_companion.track();
    return timeline.cursor().frame >= timeline.computed() && m_companion.isThere() &&
           (!companion || companion->isFinished()) && m_rest.isOver(timeline.track()) &&
           (!comparison || m_comparisonRest.isOver(*comparison));
}

void Playback::waitIfOver()
{
    if (!isPlaying() || m_end || !isOver() || m_monitor.mayStillStop(m_run.timeline()) ||
        m_attempts.mayBeDoneByWaiting(m_run.lesson().id, m_run.step(), m_run.timeline()))
        return;
    m_clock.wait();
    m_run.changes().announce(ChangeKind::playing);
}

}

#pragma once

#include "app/model/breakpoints/breakpoint_monitor.h"
#include "app/model/run/frame_clock.h"
#include "app/model/run/rest_detector.h"
#include "app/model/session/attempts.h"
#include "app/model/session/companion_follower.h"

#include <QObject>

#include <functional>
#include <optional>
#include <variant>

namespace app {

/// Moves the run's cursor: playing, stepping, and going to a moment, with breakpoints on the way.
class Playback : public QObject
{
    Q_OBJECT

public:
    Playback(OpenRun &run, Preview &preview, CompanionFollower &companion, Attempts &attempts);

    bool isPlaying() const;
    /// Returns whether playback is on, but everything is at rest: time stands still until the next change.
    bool isWaiting() const { return m_clock.isWaiting(); }
    double speed() const { return m_clock.speed(); }
    /// Sets the speed, 0.1 to 4 times 30 frames per second. It never changes the step size.
    void setSpeed(double speed);
    void play();
    void pause();
    /// Pauses at frame `end` when the run comes to it by playing. Until then, playback does not wait at rest. Empty: it goes
    /// on. Another step, and a pause at `end`, forget it.
    void setEnd(std::optional<std::int64_t> end) { m_end = end; }
    void togglePlaying();
    /// Plays again from frame 0, with all recorded input.
    void repeat();
    /// Starts playback for a user who takes hold of something while time is paused: at the start of the run and at its
    /// end. Inside a frame, in the past, and in a scene that the user builds, time stays paused.
    void startForInput();
    /// While time is paused, tells so to a user whose pointer acts on the scene.
    void reportIfPaused();

    // Each of these pauses first.
    void frameForward();
    void frameBack();
    void phaseForward();
    void phaseBack();
    /// Goes on to a moment after the cursor as playback does: it stops at breakpoints on the way.
    void runTo(sim::Cursor cursor);

    /// Goes on inside the next frame until `lines` lines of the listing have run, or to a breakpoint before.
    void runToLine(int lines);

    /// Goes to a moment. A distant one is approached in slices, so that the window never waits; see goal(). Playback
    /// goes on from there.
    void goTo(sim::Cursor cursor);
    /// As goTo(), but pauses if the moment is not reached at once.
    void goToPaused(sim::Cursor cursor);
    /// Returns the frame to which the run is on its way.
    std::optional<std::int64_t> goal() const;

    /// The breakpoints of the open step.
    Breakpoints &breakpoints() { return m_breakpoints; }
    const Breakpoints &breakpoints() const { return m_breakpoints; }
    /// Sets how conditions on variables of the listing are watched: `ahead` returns the lines after the cursor, and
    /// `stopAtLine` shows the run after that many of them.
    void setLines(std::function<LinesAhead()> ahead, std::function<void(int)> stopAtLine);
    /// Forgets the breakpoint that stopped the run, because it goes on.
    void clearBreakHit() { m_hit.reset(); }
    /// Returns the breakpoint that stopped the run where it is, if nothing has changed since.
    const std::optional<BreakHit> &breakHit() const { return m_hit; }

    /// Starts over for the open step: its breakpoints are watched, and no goal is left.
    void open();
    /// Gives up the way to a goal. The cursor stays where it is.
    void stopSeeking();
    /// Goes on if playback waits, because the run has changed.
    void wakeUp();
    /// Ticks off the things to try that are done at the cursor.
    void checkAttempts();

private:
    struct Paused
    {
    };
    struct Playing
    {
        int due = 0;    ///< frames since playback started
        int played = 0; ///< of these
    };
    struct Seeking
    {
        sim::Cursor goal;
        bool stopsAtBreakpoints = false;
        bool thenPlays = false;
    };

    void advance(int frames);
    /// Advances by one output step, or to a breakpoint in it.
    std::optional<BreakHit> advanceOneOutput();
    void stopAt(const BreakHit &hit);
    /// Shows the run before the line of the listing that stops the next frame, with the values that led there.
    void stopAtMistake();
    /// Reports once, after a while, that playback falls behind.
    void judgePace(Playing &playing, int due, int played);
    void waitIfOver();
    bool isOver();
    void seekSlice();
    void runSlice(const Seeking &seeking);
    void arrive();
    void seekLater();

    OpenRun &m_run;
    Preview &m_preview;
    CompanionFollower &m_companion;
    Attempts &m_attempts;
    FrameClock m_clock;
    std::variant<Paused, Playing, Seeking> m_state;
    RestDetector m_rest, m_comparisonRest;
    Breakpoints m_breakpoints;
    BreakpointMonitor m_monitor;
    std::optional<BreakHit> m_hit;
    std::optional<std::int64_t> m_end; ///< where playback pauses
    std::function<LinesAhead()> m_linesAhead;
    std::function<void(int)> m_stopAtLine;
    bool m_isSliceDue = false; ///< whether the next slice of seeking is scheduled
};

}

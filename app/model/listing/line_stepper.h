#pragma once

#include "app/listing/listing_method.h"
#include "app/model/listing/learner_code.h"
#include "app/model/listing/listing_frame.h"
#include "app/model/session/playback.h"

#include <QObject>

#include <cstddef>
#include <memory>
#include <optional>
#include <vector>

namespace app {

/// Moves through the lines of a listing. The run's cursor is between two frames then, and index() counts the lines of the
/// next frame that have run. Any other move of the cursor sets it back to 0.
///
/// ChangeKind::cursor announces each step: the scene shows the bodies as the lines have left them.
class LineStepper : public QObject
{
    Q_OBJECT

public:
    LineStepper(OpenRun &run, const Preview &preview, Playback &playback, const LearnerCode &code)
        : m_run(run), m_preview(preview), m_playback(playback), m_code(code)
    {
    }

    /// Returns whether the lines of LearnerCode::text() can be stepped through: they compute the run.
    bool isAvailable() const { return m_code.isRunning(); }
    /// Returns how many lines of the next frame have run. 0: the cursor is between two frames.
    int index() const { return m_index; }
    /// Returns the number of lines of the next frame, as they run. 0 if lines are not available.
    int count() const;
    /// Returns the next frame, which the arrow and the strip of the timeline show. Null if lines are not available.
    std::shared_ptr<const ListingFrame> nextFrame() const;
    /// Returns the frame whose values are shown beside their lines, and how many of its lines have run. Inside a frame
    /// that is the frame itself, between two frames the one before. Without a frame at the start, and while lines are not
    /// available.
    struct Shown
    {
        std::shared_ptr<const ListingFrame> frame; ///< null: no values
        int index = 0;                             ///< lines of it that have run
        bool isInside = false;                     ///< whether the frame is not finished yet
    };
    Shown shown() const;
    /// Returns the line of the text that runs next, from 1; 0 if lines are not available or the run ends here.
    int nextLine() const;
    /// Returns the state as the lines have left it. Empty between two frames.
    const std::optional<sim::State> &state() const { return m_state; }

    // Each of these pauses first.
    /// Runs one line: into functions and loops, and from the last line into the next frame.
    void forward();
    /// Goes back one line, also into the frame before.
    void back();
    /// Runs the next line with all calls in it.
    void stepOver();
    /// Runs to the end of the function, or to the end of the frame.
    void stepOut();
    /// Runs on until `line` of the text (from 1) is next, in this frame or else in the frame after it, or to a breakpoint
    /// before. Returns whether the line runs in one of these frames; if not, says so.
    bool runTo(int line);
    /// Goes to a line of the next frame by the number of lines before it, 0 to count(). count() is the next frame.
    void goTo(int index);

    /// Returns the next frame with the lines of it that have run, for breakpoints.
    LinesAhead ahead() const;
    /// Shows the run after `index` lines of the next frame, where a breakpoint has stopped it.
    void stopAt(int index) { set(index); }
    /// Forgets the place inside a frame if the cursor or the run has changed.
    void follow();

private:
    /// A traced frame, with everything that it depends on.
    struct Traced
    {
        std::shared_ptr<const sim::ComposedInterval> interval;
        std::shared_ptr<const listing::Program> program;
        sim::State start;
        std::shared_ptr<const ListingFrame> frame;
    };

    /// Stops playing, and goes to the start of the frame if the cursor is between two phases. Returns whether it was.
    bool pauseOutsidePhases();
    void set(int index);
    /// Goes to the last line of the frame that back() has gone back to, as soon as the run is there.
    void arrive();
    /// Returns the frame after `frame` of `track`, traced from `end`, the state there. `traced` caches it.
    std::shared_ptr<const ListingFrame> frameFrom(const sim::Track &track, const sim::State &end,
                                                  std::int64_t frame, Traced &traced) const;
    /// Returns the variables that `program` remembers at `frame` of a run that another method computes.
    std::vector<std::byte> memoryAt(const sim::Script &script,
                                    const std::shared_ptr<const listing::Program> &program,
                                    std::int64_t frame) const;

    OpenRun &m_run;
    const Preview &m_preview;
    Playback &m_playback;
    const LearnerCode &m_code;
    int m_index = 0;
    std::int64_t m_at = -1;          ///< the frame that m_index belongs to
    std::int64_t m_goesToEndOf = -1; ///< the frame that back() is on its way to; -1: none
    std::optional<sim::State> m_state;
    mutable Traced m_next, m_last;
    /// A run of the listing, for the variables that it remembers while its step's own method computes the run.
    mutable std::optional<sim::Track> m_remembered;
};

}

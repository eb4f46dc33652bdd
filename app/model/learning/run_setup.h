#pragma once

#include "app/model/breakpoints/condition.h"
#include "app/model/catalog/lesson_library.h"
#include "lessons/api/step.h"
#include "sim/run/script/composed_interval.h"
#include "sim/run/track.h"

#include <functional>
#include <optional>

namespace app {

/// Returns the step that a document calls "lesson/step"; null if there is none.
const lessons::Step *stepCalled(const QString &name, const LessonLibrary &library);
/// Returns the run of `step` as published, with what `setup` changes. RunSetup::step is ignored.
/// @throws UserError if a parameter, a choice, a body or a method does not exist, or a value is out of range
/// @throws sim::Error if there is no such run
sim::Script scriptFor(const lessons::RunSetup &setup, const lessons::Step &step);

/// Returns `script`, a run of `step`, with what `setup` changes. Its input is added to that of `script`.
/// @throws UserError, sim::Error as above
sim::Script scriptWith(const lessons::RunSetup &setup, const lessons::Step &step, sim::Script script);

/// A run that is followed frame by frame, to ask for conditions and numbers at each one. It keeps no past.
class FollowedRun
{
public:
    /// `step` must outlive this object.
    /// @throws sim::Error if there is no such run
    FollowedRun(const lessons::Step &step, sim::Script script) : m_step(step), m_track(std::move(script), 0)
    {
    }

    /// Parses a condition or a number for this run, at frame 0.
    /// @throws UserError as Condition::parse()
    Condition condition(const QString &text) const { return Condition::parse(text, names()); }
    MomentNumber number(const QString &text) const { return MomentNumber::parse(text, names()); }

    /// Goes on by a frame, or by an output step of the method. Returns whether the run goes on there; a run that fails
    /// stays at its last frame.
    bool advance();
    std::int64_t frame() const { return m_track.cursor().frame; }
    const sim::State &state() const { return m_track.state(); }
    const sim::Scene &scene() const { return m_track.interval().scene; }
    ConditionMoment moment() const { return {state(), frame(), nullptr, {}, &m_track}; }
    /// Returns the point with this name.
    /// @throws UserError if there is none
    int point(const QString &body) const;

private:
    ConditionNames names() const;

    const lessons::Step &m_step;
    sim::Track m_track;
};

/// Where a run ends.
struct RunEnd
{
    std::int64_t frame = 0;
    bool isReached = false; ///< whether RunSetup::until held; true if there is none
};

/// Follows `run` to the end that `setup` names: the first frame from 1 on at which `until` holds, at the latest
/// RunSetup::frames. Calls `visit` at each frame, also at the first. Returns nothing if cancelled.
/// @throws UserError if `until` is not a condition
std::optional<RunEnd> runToEnd(FollowedRun &run, const lessons::RunSetup &setup,
                               const sim::ShouldContinue &shouldContinue = {},
                               const std::function<void()> &visit = {});

}

#pragma once

#include "app/ui/theme/theme.h"
#include "app/ui/time/timeline_axis.h"

#include <QPainter>
#include <QRectF>
#include <QRegion>

#include <optional>

namespace app {

/// Some frames in a row in which the learner did something.
struct Stretch
{
    std::int64_t from = 0;
    std::int64_t to = 0;
    sim::EffectKind kind = sim::EffectKind::driver; ///< wind, or a hand
    bool goesOn = false;                            ///< it ends where the run does
};

/// The run as it was before a change to its past.
struct OldRun
{
    std::int64_t fork = 0; ///< the last frame that both runs share
    std::int64_t end = 0;
    QString name;
    int id = 0;
    bool isKept = false;
};

/// Where other runs, which are not shown beside this one, leave it.
struct Fork
{
    std::int64_t at = 0; ///< the last frame that they share with the run
    std::vector<int> branches;
};

/// What the upper part of the timeline shows of a run.
struct RunView
{
    std::int64_t at = 0;
    std::int64_t computed = 0;
    std::vector<Stretch> input;
    std::optional<OldRun> old;
    std::vector<Fork> forks; ///< by frame
    bool playing = false;
};

/// Heights, in px from the top of the timeline.
struct TimelinePlaces
{
    static constexpr int height = 98;
    static constexpr double track = 25.0;
    static constexpr double oldRun = 40.0;
    static constexpr int fan = 48;
    static constexpr int strip = 60;
    static constexpr int stripHeight = 28;
};

/// What hangs below the track.
enum class Below { fan, nothing };
/// Tick labels, track, old run, head and, if it is wanted, the fan; not the phase strip.
void paintTimeline(QPainter &painter, const TimelineAxis &axis, const RunView &view, const Theme &theme,
                   Below below);

/// A thin line through the track, at a frame that the mouse is at.
void paintPointed(QPainter &painter, const TimelineAxis &axis, std::int64_t frame, const Theme &theme);

/// Where the old run's dots and name are.
QRectF oldRunArea(const TimelineAxis &axis, const OldRun &old, const Theme &theme);
/// Where the mark of a fork can be pressed: under the track, so that it keeps nobody from scrubbing.
QRectF forkArea(const TimelineAxis &axis, const Fork &fork);

/// What looks different when nothing but the cursor and what is computed change from `was` to `is`.
QRegion changedByMove(const TimelineAxis &axis, const RunView &was, const RunView &is, const Theme &theme);

}

#pragma once

#include "app/ui/theme/theme.h"
#include "app/ui/time/timeline_axis.h"

#include <QPainter>
#include <QRectF>
#include <QRegion>

#include <optional>

namespace app {

/// Consecutive frames with the same input of the learner.
struct Stretch
{
    std::int64_t from = 0;
    std::int64_t to = 0;
    sim::EffectKind kind = sim::EffectKind::driver; ///< wind, or a hand
    bool goesOn = false;                            ///< whether it lasts until the end of the run
};

/// The comparison run: the run before a change to its past.
struct ComparisonRun
{
    std::int64_t fork = 0; ///< the last frame that both runs share
    std::int64_t end = 0;
    QString name;
    int id = 0;
};

/// A place where hidden branches part from the run.
struct Fork
{
    std::int64_t at = 0; ///< the last frame that they share with the run
    std::vector<int> branches;
};

/// The contents of the upper part of the timeline.
struct RunView
{
    std::int64_t at = 0;
    std::int64_t computed = 0;
    std::vector<Stretch> input;
    std::optional<ComparisonRun> comparison;
    std::vector<Fork> forks; ///< sorted by frame
    bool playing = false;
};

/// Heights, px from the top of the timeline.
struct TimelinePlaces
{
    static constexpr int height = 98;
    static constexpr double labels = 14.0; ///< the baseline; the focus ring is above
    static constexpr double track = 29.0;
    static constexpr double comparisonRun = 44.0;
    static constexpr int fan = 52;
    static constexpr int strip = 64;
    static constexpr int stripHeight = 28;
};

/// The part below the track: the fan to the phase strip, or nothing.
enum class Below { fan, nothing };
/// Paints tick labels, track, comparison run, playhead and, if wanted, the fan, but not the phase strip.
void paintTimeline(QPainter &painter, const TimelineAxis &axis, const RunView &view, const Theme &theme,
                   Below below);

/// Paints a thin line through the track, at the previewed frame.
void paintPointed(QPainter &painter, const TimelineAxis &axis, std::int64_t frame, const Theme &theme);

/// Returns the area of the dots and the name of the comparison run.
QRectF comparisonRunArea(const TimelineAxis &axis, const ComparisonRun &comparison, const Theme &theme);
/// Returns the area where the mark of a fork can be clicked: below the track, so that scrubbing works everywhere.
QRectF forkArea(const TimelineAxis &axis, const Fork &fork);

/// Returns the area that changes when only the cursor and the computed part change from `was` to `is`.
QRegion changedByMove(const TimelineAxis &axis, const RunView &was, const RunView &is, const Theme &theme);

}

#pragma once

#include <QFlags>
#include <QMetaType>

#include <cstdint>
#include <limits>

namespace app {

/// The kinds of changes that a session announces. One change can be of several kinds.
enum class ChangeKind : unsigned {
    step = 1U << 0U,   ///< a step was opened, or its run was replaced as a whole: everything is new
    run = 1U << 1U,    ///< parameters, method, step size, input or comparison run: phases and code may differ
    cursor = 1U << 2U, ///< the cursor moved, or the state at the cursor is another
    playing = 1U << 3U,   ///< playback started, paused, waits, or has another speed
    selection = 1U << 4U, ///< another body is selected
    preview = 1U << 5U,   ///< another moment is marked or shown, or none any longer
    code = 1U << 6U,      ///< the text of the listing, or whether it computes the run
    texts = 1U << 7U,     ///< titles and texts of steps
};

Q_DECLARE_FLAGS(ChangeKinds, ChangeKind)

inline constexpr ChangeKinds everyChange = ChangeKinds::fromInt(~0U);

/// A change of a session. All that one edit changes is announced as one change.
struct Change
{
    /// The `firstFrame` of a change that leaves all states of the run as they were.
    static constexpr std::int64_t noFrame = std::numeric_limits<std::int64_t>::max();

    ChangeKinds kinds;
    /// The first frame of the run whose state can differ from before. Cached samples of earlier frames stay valid.
    std::int64_t firstFrame = noFrame;

    /// Returns whether the change is of at least one of these kinds.
    bool isAny(ChangeKinds of) const { return (kinds & of) != 0; }
};

}

Q_DECLARE_OPERATORS_FOR_FLAGS(app::ChangeKinds) // not in app, where it would hide Qt's own operators
Q_DECLARE_METATYPE(app::Change)

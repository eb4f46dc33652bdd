#pragma once

#include "app/model/listing/listing_frame.h"

#include <QString>
#include <QStringList>

#include <vector>

namespace app {

/// The values that a line of the listing has set, shown beside it.
struct LineChip
{
    int line = 0;           ///< of the text, from 1
    QString text;           ///< "angle = 1.57", "velocity = (0.4, −2.1)"
    QStringList shorter;    ///< for places that are too narrow for `text`, longest first
    QString tip;            ///< one sentence with the value before
    bool isChanged = false; ///< whether the line that ran last set it to another value
    bool isInScope =
        true; ///< whether the name exists where the run has stopped; if not, the value is an earlier one
    friend bool operator==(const LineChip &, const LineChip &) = default;
};

/// A loop that runs, shown beside its first line.
struct LoopNote
{
    int line = 0; ///< of the text, from 1
    QString text; ///< "i = 2 of 5", or "2 of 5" for a loop without a counter
    friend bool operator==(const LoopNote &, const LoopNote &) = default;
};

/// Everything that stands beside the lines of a listing.
struct LineValues
{
    std::vector<LineChip> chips; ///< at most one per line, by line
    std::vector<LoopNote> loops; ///< around the next line, the outermost first
    QStringList calls;           ///< "frame", "grow", "grow"; the innermost last
    QString message; ///< the mistake that stopped the frame, or why lines are missing; may be empty
    friend bool operator==(const LineValues &, const LineValues &) = default;
};

/// Returns the values after `index` lines of `frame`. If all have run, there are no loops, and the only call is "frame".
LineValues valuesAfter(const ListingFrame &frame, int index);

/// Returns the value as a reader sees it: "1.57", "(3.2, −14)", "true", "feet[2]". `more`: decimals more than usual.
QString shownText(const listing::Value &value, int more = 0);

}

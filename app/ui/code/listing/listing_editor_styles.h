#pragma once

namespace app {

// Scintilla numbers, and a width, that the files of ListingEditor share.

constexpr int mistakeIndicator = 8; ///< under mistakes
constexpr int dragIndicator = 9;    ///< under parameters and numbers that can be dragged
constexpr int useIndicator = 10;    ///< round the names that stand for a body

/// Markers: the background of the next line, and of its margin.
enum ListingMarker { nextText, nextMargin };

/// Returns whether letters are smaller in a view of this width, in px, so that fewer lines are wrapped.
constexpr bool isNarrow(int width)
{
    return width < 440;
}

}

#pragma once

namespace app {

// What the files of CodeView call by number.

constexpr int toComeIndicator = 9; ///< under what is still to come in a frame
constexpr int spotIndicator = 10;  ///< under what can be changed

/// Markers: what is behind a row's text, and behind its margins.
enum Marker { regionText, regionMargin, lineText, lineMargin };

/// Styles beyond those of Ink: numbers in the margin.
enum NumberStyle { number = 20, numberInRegion, numberOnLine };

}

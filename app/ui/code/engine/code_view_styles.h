#pragma once

namespace app {

// Scintilla numbers that the files of CodeView share.

constexpr int toComeIndicator = 9; ///< under code that the current frame has yet to run
constexpr int spotIndicator = 10;  ///< under numbers that can be changed

/// Markers: the backgrounds of a row's text and of its margins.
enum Marker { regionText, regionMargin, lineText, lineMargin };

/// Styles of the line numbers in the margin, in addition to those of Ink.
enum NumberStyle { number = 20, numberInRegion, numberOnLine };

}

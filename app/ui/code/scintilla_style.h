#pragma once

#include <QColor>
#include <QFont>

#include <Qsci/qsciscintilla.h>

namespace app {

class Theme;

/// The height of a line of code, px.
constexpr int codeRowPixels = 20;

/// The margins of a view of code, px from its left edge. Line numbers are first.
struct CodeMargins
{
    static constexpr int symbol = 30; ///< an arrow, a breakpoint or a sign
    static constexpr int bar = 43;    ///< a bar in the colour of the effect, or of a changed line
    static constexpr int barWidth = 3;
    static constexpr int text = 53; ///< the code
};

/// Sets up what views of code have in common: margins, of which the first has `numbers`, keyboard focus, and styles that
/// the program sets itself. The markers in `marginMarkers`, one bit each, are drawn in the other margins.
void setUpCode(QsciScintilla &view, QsciScintilla::MarginType numbers, int marginMarkers);

/// Returns `font` with the size that shows it `pixels` px high in `view`. Scintilla has no font sizes in pixels.
QFont inPoints(const QsciScintilla &view, QFont font, double pixels);

/// Defines a style of Scintilla, for example one of Ink.
void defineStyle(QsciScintilla &view, int style, const QFont &font, const QColor &ink, const QColor &paper);

/// Gives a view of code its fonts and colours: the styles of Ink, line numbers, the selection, and the height of lines.
/// Letters of the code are `letterPixels` high.
void styleCode(QsciScintilla &view, const Theme &theme, double letterPixels = 13.0);

}

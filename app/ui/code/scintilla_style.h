#pragma once

#include <QColor>
#include <QFont>

class QsciScintilla;

namespace app {

class Theme;

/// The height of a line of code, px.
constexpr int codeRowPixels = 20;

/// Returns `font` with the size that shows it `pixels` px high in `view`. Scintilla has no font sizes in pixels.
QFont inPoints(const QsciScintilla &view, QFont font, double pixels);

/// Defines a style of Scintilla, for example one of Ink.
void defineStyle(QsciScintilla &view, int style, const QFont &font, const QColor &ink, const QColor &paper);

/// Gives a view of code its fonts and colours: the styles of Ink, line numbers, the selection, and the height of lines.
/// Letters of the code are `letterPixels` high.
void styleCode(QsciScintilla &view, const Theme &theme, double letterPixels = 13.0);

}

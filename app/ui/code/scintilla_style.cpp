#include "app/ui/code/scintilla_style.h"

#include "app/ui/code/code_colors.h"
#include "app/ui/code/code_scintilla.h"
#include "app/ui/theme/theme.h"

namespace app {

namespace {

using Base = QsciScintillaBase;

constexpr double numberPixels = 11.5;

void makeRowsAsHigh(QsciScintilla &view, int pixels)
{
    view.setExtraAscent(0);
    view.setExtraDescent(0);
    const int spare = pixels - view.textHeight(0);
    view.setExtraAscent((spare + 1) / 2);
    view.setExtraDescent(spare / 2);
}

}

void setUpCode(QsciScintilla &view, QsciScintilla::MarginType numbers, int marginMarkers)
{
    view.setUtf8(true);
    view.setFrameShape(QFrame::NoFrame);
    view.setFocusPolicy(Qt::StrongFocus);
    view.setCaretLineVisible(false);
    view.setMinimumSize(160, 3 * codeRowPixels);
    send(view, Base::SCI_SETLEXER, Base::SCLEX_CONTAINER);
    send(view, Base::SCI_SETMARGINLEFT, 0, 0);
    const int edges[] = {0, CodeMargins::symbol, CodeMargins::bar, CodeMargins::bar + CodeMargins::barWidth,
                         CodeMargins::text};
    for (int margin = 0; margin < 4; ++margin) {
        view.setMarginType(margin, margin == 0 ? numbers : QsciScintilla::SymbolMargin);
        view.setMarginWidth(margin, edges[margin + 1] - edges[margin]);
        view.setMarginMarkerMask(margin, margin == 0 ? 0 : marginMarkers);
        view.setMarginSensitivity(margin, false);
        send(view, Base::SCI_SETMARGINCURSORN, margin, Base::SC_CURSORARROW);
    }
    view.setMarginWidth(4, 0);
}

QFont inPoints(const QsciScintilla &view, QFont font, double pixels)
{
    font.setPointSizeF(pixels * 72.0 / view.logicalDpiY());
    return font;
}

void defineStyle(QsciScintilla &view, int style, const QFont &font, const QColor &ink, const QColor &paper)
{
    send(view, Base::SCI_STYLESETFONT, style, font.family().toUtf8());
    send(view, Base::SCI_STYLESETSIZEFRACTIONAL, style,
         qRound(font.pointSizeF() * int(Base::SC_FONT_SIZE_MULTIPLIER)));
    send(view, Base::SCI_STYLESETWEIGHT, style, font.weight());
    send(view, Base::SCI_STYLESETITALIC, style, font.italic());
    view.SendScintilla(Base::SCI_STYLESETFORE, static_cast<unsigned long>(style), ink);
    view.SendScintilla(Base::SCI_STYLESETBACK, static_cast<unsigned long>(style), paper);
}

void styleCode(QsciScintilla &view, const Theme &theme, double letterPixels)
{
    const Tokens &t = theme.tokens();
    const QFont code = inPoints(view, theme.mono(), letterPixels);
    view.setPaper(t.panel);
    view.setColor(t.ink);
    const auto ink = [&](Ink which, const QFont &font, const QColor &color) {
        defineStyle(view, static_cast<int>(which), font, color, t.panel);
    };
    defineStyle(view, Base::STYLE_DEFAULT, code, t.ink, t.panel);
    ink(Ink::plain, code, t.ink);
    ink(Ink::keyword, code, t.keyword);
    ink(Ink::number, code, t.number);
    ink(Ink::type, code, t.type);
    ink(Ink::text, code, t.number);
    QFont slanted = code;
    slanted.setItalic(true);
    ink(Ink::comment, slanted, t.comment);
    defineStyle(view, Base::STYLE_LINENUMBER, inPoints(view, theme.mono(), numberPixels), t.ink3, t.panel);
    view.setMarginsBackgroundColor(t.panel);
    view.setSelectionBackgroundColor(t.sunk);
    view.resetSelectionForegroundColor();
    makeRowsAsHigh(view, codeRowPixels);
}

}

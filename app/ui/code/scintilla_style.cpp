#include "app/ui/code/scintilla_style.h"

#include "app/ui/code/code_colors.h"
#include "app/ui/code/code_scintilla.h"
#include "app/ui/theme/theme.h"

#include <Qsci/qsciscintilla.h>

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

QFont inPoints(const QsciScintilla &view, QFont font, double pixels)
{
    font.setPointSizeF(pixels * 72.0 / view.logicalDpiY());
    return font;
}

void defineStyle(QsciScintilla &view, int style, const QFont &font, const QColor &ink, const QColor &paper)
{
    const auto s = static_cast<std::size_t>(style);
    view.SendScintilla(Base::SCI_STYLESETFONT, s, font.family().toUtf8().constData());
    send(view, Base::SCI_STYLESETSIZEFRACTIONAL, s,
         qRound(font.pointSizeF() * int(Base::SC_FONT_SIZE_MULTIPLIER)));
    send(view, Base::SCI_STYLESETWEIGHT, s, font.weight());
    send(view, Base::SCI_STYLESETITALIC, s, font.italic());
    view.SendScintilla(Base::SCI_STYLESETFORE, s, ink);
    view.SendScintilla(Base::SCI_STYLESETBACK, s, paper);
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

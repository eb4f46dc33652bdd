// The appearance of the code: fonts, colours and margins.

#include "app/ui/code/code_colors.h"
#include "app/ui/code/code_scintilla.h"
#include "app/ui/code/code_view.h"
#include "app/ui/code/code_view_styles.h"
#include "app/ui/theme/theme.h"

namespace app {

namespace {

constexpr int rowPixels = 20;

}

void CodeView::setUp()
{
    setUtf8(true);
    setReadOnly(true);
    setFrameShape(QFrame::NoFrame);
    setFocusPolicy(Qt::StrongFocus);
    setAttribute(Qt::WA_InputMethodEnabled, false);
    setCaretLineVisible(false);
    // Otherwise the style draws its own square where two scroll bars meet.
    auto *corner = new QWidget(this);
    corner->setAutoFillBackground(true);
    setCornerWidget(corner);
    setMinimumSize(160, 3 * rowPixels);
    send(*this, SCI_SETLEXER, SCLEX_CONTAINER);
    send(*this, SCI_SETCARETSTYLE, 0);
    send(*this, SCI_SETCARETPERIOD, 0); // the caret is invisible and need not blink
    send(*this, SCI_SETFOLDFLAGS, 0);
    send(*this, SCI_SETSCROLLWIDTHTRACKING, 1);
    send(*this, SCI_SETMARGINLEFT, 0, 0);
    send(*this, SCI_INDICSETSTYLE, toComeIndicator, INDIC_TEXTFORE);
    send(*this, SCI_INDICSETSTYLE, spotIndicator, INDIC_DOTS);
    const int widths[] = {30, 13, 3, 7};
    for (int margin = 0; margin < 4; ++margin) {
        setMarginType(margin, margin == 0 ? TextMarginRightJustified : SymbolMargin);
        setMarginWidth(margin, widths[margin]);
        setMarginMarkerMask(margin, margin == 0 ? 0 : 1 << regionMargin | 1 << lineMargin);
        setMarginSensitivity(margin, false);
        send(*this, SCI_SETMARGINCURSORN, static_cast<std::size_t>(margin), SC_CURSORARROW);
    }
    setMarginWidth(4, 0);
    markerDefine(Background, regionText);
    markerDefine(Background, lineText);
    markerDefine(FullRectangle, regionMargin);
    markerDefine(FullRectangle, lineMargin);
}

QFont CodeView::inPoints(QFont font, double pixels) const
{
    font.setPointSizeF(pixels * 72.0 / logicalDpiY()); // Scintilla has no font sizes in pixels
    return font;
}

void CodeView::defineStyle(int style, const QFont &font, const QColor &ink, const QColor &paper)
{
    const auto s = static_cast<std::size_t>(style);
    SendScintilla(SCI_STYLESETFONT, s, font.family().toUtf8().constData());
    send(*this, SCI_STYLESETSIZEFRACTIONAL, s, qRound(font.pointSizeF() * int(SC_FONT_SIZE_MULTIPLIER)));
    send(*this, SCI_STYLESETWEIGHT, s, font.weight());
    send(*this, SCI_STYLESETITALIC, s, font.italic());
    SendScintilla(SCI_STYLESETFORE, s, ink);
    SendScintilla(SCI_STYLESETBACK, s, paper);
}

void CodeView::applyTheme()
{
    const Tokens &t = m_theme.tokens();
    const QFont code = inPoints(m_theme.mono(), 13);
    setPaper(t.panel);
    setColor(t.ink);
    const auto ink = [&](Ink which, const QFont &font, const QColor &color) {
        defineStyle(static_cast<int>(which), font, color, t.panel);
    };
    defineStyle(STYLE_DEFAULT, code, t.ink, t.panel);
    ink(Ink::plain, code, t.ink);
    ink(Ink::keyword, code, t.keyword);
    ink(Ink::number, code, t.number);
    ink(Ink::type, code, t.type);
    ink(Ink::text, code, t.number);
    QFont slanted = code;
    slanted.setItalic(true);
    ink(Ink::comment, slanted, t.comment);
    ink(Ink::heading, inPoints(m_theme.ui(12, QFont::DemiBold), 12), t.ink);
    ink(Ink::caption, inPoints(m_theme.ui(12), 12), t.ink3);
    const QFont numbers = inPoints(m_theme.mono(), 11.5);
    defineStyle(STYLE_LINENUMBER, numbers, t.ink3, t.panel);
    defineStyle(number, numbers, t.ink3, t.panel);
    defineStyle(numberInRegion, numbers, t.ink3, t.wash2);
    defineStyle(numberOnLine, numbers, t.ink3, t.wash);
    setMarginsBackgroundColor(t.panel);
    for (const int marker : {regionText, regionMargin})
        setMarkerBackgroundColor(t.wash2, marker), setMarkerForegroundColor(t.wash2, marker);
    for (const int marker : {lineText, lineMargin})
        setMarkerBackgroundColor(t.wash, marker), setMarkerForegroundColor(t.wash, marker);
    SendScintilla(SCI_INDICSETFORE, toComeIndicator, t.ink3);
    SendScintilla(SCI_INDICSETFORE, spotIndicator, t.ink2);
    styleRemovedLines(t.ink2);
    setSelectionBackgroundColor(t.sunk);
    resetSelectionForegroundColor();
    makeRowsAsHigh(rowPixels);
    viewport()->update();
}

void CodeView::makeRowsAsHigh(int pixels)
{
    setExtraAscent(0);
    setExtraDescent(0);
    const int spare = pixels - textHeight(0);
    setExtraAscent((spare + 1) / 2);
    setExtraDescent(spare / 2);
}

}

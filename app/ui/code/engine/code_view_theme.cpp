// The appearance of the code: fonts, colours and margins.

#include "app/ui/code/code_colors.h"
#include "app/ui/code/code_scintilla.h"
#include "app/ui/code/engine/code_view.h"
#include "app/ui/code/engine/code_view_styles.h"
#include "app/ui/code/scintilla_style.h"
#include "app/ui/theme/theme.h"

namespace app {

void CodeView::setUp()
{
    setUpCode(*this, TextMarginRightJustified, 1 << regionMargin | 1 << lineMargin);
    setReadOnly(true);
    setAttribute(Qt::WA_InputMethodEnabled, false);
    // Otherwise the style draws its own square where two scroll bars meet.
    auto *corner = new QWidget(this);
    corner->setAutoFillBackground(true);
    setCornerWidget(corner);
    send(*this, SCI_SETCARETSTYLE, 0);
    send(*this, SCI_SETCARETPERIOD, 0); // the caret is invisible and need not blink
    send(*this, SCI_SETFOLDFLAGS, 0);
    send(*this, SCI_SETSCROLLWIDTHTRACKING, 1);
    send(*this, SCI_INDICSETSTYLE, toComeIndicator, INDIC_TEXTFORE);
    send(*this, SCI_INDICSETSTYLE, spotIndicator, INDIC_DOTS);
    markerDefine(Background, regionText);
    markerDefine(Background, lineText);
    markerDefine(FullRectangle, regionMargin);
    markerDefine(FullRectangle, lineMargin);
}

void CodeView::applyTheme()
{
    const Tokens &t = m_theme.tokens();
    styleCode(*this, m_theme);
    const auto style = [this](int which, const QFont &font, const QColor &ink, const QColor &paper) {
        defineStyle(*this, which, font, ink, paper);
    };
    style(static_cast<int>(Ink::heading), inPoints(*this, m_theme.ui(12, QFont::DemiBold), 12), t.ink,
          t.panel);
    style(static_cast<int>(Ink::caption), inPoints(*this, m_theme.ui(12), 12), t.ink3, t.panel);
    const QFont numbers = inPoints(*this, m_theme.mono(), 11.5);
    style(number, numbers, t.ink3, t.panel);
    style(numberInRegion, numbers, t.ink3, t.wash2);
    style(numberOnLine, numbers, t.ink3, t.wash);
    for (const int marker : {regionText, regionMargin})
        setMarkerBackgroundColor(t.wash2, marker), setMarkerForegroundColor(t.wash2, marker);
    for (const int marker : {lineText, lineMargin})
        setMarkerBackgroundColor(t.wash, marker), setMarkerForegroundColor(t.wash, marker);
    SendScintilla(SCI_INDICSETFORE, toComeIndicator, t.ink3);
    SendScintilla(SCI_INDICSETFORE, spotIndicator, t.ink2);
    styleRemovedLines(t.ink2);
    viewport()->update();
}

}

// The lines that this step removed, struck through at their old places.

#include "app/ui/code/code_scintilla.h"
#include "app/ui/code/engine/code_view.h"

#include <algorithm>

namespace app {

namespace {

constexpr int goneIndicator = 11;

}

void CodeView::styleRemovedLines(const QColor &ink)
{
    send(*this, SCI_INDICSETSTYLE, goneIndicator, INDIC_STRIKE);
    SendScintilla(SCI_INDICSETFORE, goneIndicator, ink);
}

void CodeView::strikeGone()
{
    startIndicator(*this, goneIndicator);
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        if (m_rows[row].kind == CodeRow::Kind::gone)
            fillIndicator(*this, send(*this, SCI_GETLINEINDENTPOSITION, row),
                          send(*this, SCI_GETLINEENDPOSITION, row));
    }
}

std::size_t CodeView::rowOf(const CodeRow &sought) const
{
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        const CodeRow &its = m_rows[row];
        if (its.kind == sought.kind && its.section == sought.section && its.line == sought.line)
            return row;
    }
    return headingRow(sought.section);
}

void CodeView::setGone(Gone gone)
{
    if (gone == m_gone || m_rows.empty()) {
        m_gone = gone;
        return;
    }
    const auto top =
        static_cast<std::size_t>(send(*this, SCI_DOCLINEFROMVISIBLE, send(*this, SCI_GETFIRSTVISIBLELINE)));
    const CodeRow atTop = m_rows[std::min(top, m_rows.size() - 1)], at = m_rows[m_row];
    m_gone = gone;
    layRows();
    underlineSpots();
    m_row = rowOf(at);
    send(*this, SCI_SETFIRSTVISIBLELINE, send(*this, SCI_VISIBLEFROMDOCLINE, rowOf(atTop)));
    viewport()->update();
}

void CodeView::showFirstGone()
{
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        if (m_rows[row].kind != CodeRow::Kind::gone)
            continue;
        setFolded(m_rows[row].section, false);
        goToRow(row);
        return;
    }
}

}

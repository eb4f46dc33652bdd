#include "app/ui/code/code_scintilla.h"
#include "app/ui/code/engine/code_view.h"

#include <QSettings>

#include <algorithm>

namespace app {

std::size_t CodeView::headingRow(std::size_t section) const
{
    const auto heading = std::find_if(m_rows.begin(), m_rows.end(), [section](const CodeRow &row) {
        return row.section == section && row.kind == CodeRow::Kind::heading;
    });
    return static_cast<std::size_t>(heading - m_rows.begin());
}

bool CodeView::isFolded(std::size_t section) const
{
    return section < m_listing.sections.size() && m_folded.contains(keyOf(m_listing.sections[section]));
}

void CodeView::setFolded(std::size_t section, bool folded)
{
    if (section >= m_listing.sections.size() || folded == isFolded(section))
        return;
    fold(keyOf(m_listing.sections[section]), folded);
}

QString CodeView::foldKey(const CodeRow &row) const
{
    if (row.kind == CodeRow::Kind::heading)
        return keyOf(m_listing.sections[row.section]);
    return row.kind == CodeRow::Kind::file && row.isPlumbing ? keyOfPlumbing() : QString();
}

void CodeView::fold(const QString &key, bool folded)
{
    folded ? (void)m_folded.insert(key) : (void)m_folded.remove(key);
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        // All sections with the same key fold together.
        if (foldKey(m_rows[row]) == key)
            send(*this, SCI_FOLDLINE, row, folded ? SC_FOLDACTION_CONTRACT : SC_FOLDACTION_EXPAND);
    }
    viewport()->update();
}

void CodeView::toggle(const QString &key)
{
    fold(key, !m_folded.contains(key));
    QSettings().setValue(foldedKey, QStringList(m_folded.begin(), m_folded.end()));
}

void CodeView::unfold(std::size_t row)
{
    setFolded(m_rows[row].section, false);
    if (m_rows[row].isPlumbing && isPlumbingFolded())
        fold(keyOfPlumbing(), false);
}

void CodeView::scrollTo(std::size_t first, std::size_t row)
{
    const long from = send(*this, SCI_VISIBLEFROMDOCLINE, first);
    const long to = send(*this, SCI_VISIBLEFROMDOCLINE, row);
    const long top = send(*this, SCI_GETFIRSTVISIBLELINE);
    const long room = std::max(1L, send(*this, SCI_LINESONSCREEN));
    if (from >= top && to < top + room)
        return;
    // Scrolls the heading to the top if the row then still fits; otherwise centres the row.
    const long wanted =
        to - from < room ? (from < top ? from : std::min(from, to - room + 1)) : to - room / 2;
    send(*this, SCI_SETFIRSTVISIBLELINE, std::max(0L, wanted));
}

void CodeView::showNow()
{
    if (const std::optional<std::size_t> heading = scrollToNow()) {
        m_row = *heading;
        m_word.reset();
    }
}

std::optional<std::size_t> CodeView::scrollToNow()
{
    for (std::size_t section = 0; section < m_marks.size(); ++section) {
        if (m_marks[section].when != When::now)
            continue;
        const std::size_t heading = headingRow(section);
        std::size_t now = heading;
        std::size_t last = heading;
        for (std::size_t row = heading; !isFolded(section) && row < m_rows.size(); ++row) {
            if (m_rows[row].section != section || m_rows[row].kind != CodeRow::Kind::code ||
                rowRect(row).isEmpty())
                continue;
            last = row;
            now = isResult(m_rows[row]) ? row : now;
        }
        const bool fits = static_cast<long>(last - heading) < send(*this, SCI_LINESONSCREEN);
        scrollTo(heading, fits ? last : now);
        return heading;
    }
    return std::nullopt;
}

void CodeView::showPhases()
{
    if (send(*this, SCI_GETFIRSTVISIBLELINE) != 0)
        return;
    const auto &sections = m_listing.sections;
    const auto phase = std::find_if(sections.begin(), sections.end(), [](const CodeSection &section) {
        return section.role == CodeSection::Role::phase;
    });
    const std::size_t row = headingRow(static_cast<std::size_t>(phase - sections.begin()));
    if (row < m_rows.size())
        send(*this, SCI_SETFIRSTVISIBLELINE, send(*this, SCI_VISIBLEFROMDOCLINE, row));
}

void CodeView::showNextNew()
{
    const auto isNew = [this](std::size_t row) {
        const CodeLine *shown = line(m_rows[row]);
        return shown && shown->isNew;
    };
    const std::size_t count = m_rows.size();
    for (std::size_t i = 1; i <= count; ++i) {
        const std::size_t row = (m_newRow + i) % count;
        if (!isNew(row) || (row > 0 && isNew(row - 1)))
            continue;
        std::size_t end = row;
        while (end < count && isNew(end))
            ++end;
        m_newRow = row;
        unfold(row);
        send(*this, SCI_SETSEL, send(*this, SCI_GETLINEENDPOSITION, end - 1), positionOf(row, 0));
        scrollTo(row, end - 1);
        return;
    }
}

QString CodeView::shownText() const
{
    QStringList texts;
    for (std::size_t section = 0; section < m_listing.sections.size(); ++section) {
        if (!isFolded(section))
            texts << plainText(m_listing.sections[section]);
    }
    return texts.join('\n');
}

}

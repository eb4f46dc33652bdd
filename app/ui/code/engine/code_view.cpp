#include "app/ui/code/engine/code_view.h"

#include "app/ui/actions/command.h"
#include "app/ui/code/code_keys.h"
#include "app/ui/code/code_scintilla.h"
#include "app/ui/code/engine/code_view_styles.h"
#include "app/ui/theme/theme.h"

#include <QScrollBar>
#include <QSettings>

#include <algorithm>

namespace app {

namespace {

constexpr int foldBase = QsciScintilla::SC_FOLDLEVELBASE;
constexpr int foldHeader = QsciScintilla::SC_FOLDLEVELHEADERFLAG;

long foldLevel(const CodeRow &row)
{
    switch (row.kind) {
    case CodeRow::Kind::heading:
        return foldBase | foldHeader;
    case CodeRow::Kind::gap:
        return foldBase;
    case CodeRow::Kind::file:
        return (foldBase + 1) | (row.isPlumbing ? foldHeader : 0);
    case CodeRow::Kind::code:
    case CodeRow::Kind::gone:
        break;
    }
    return row.isPlumbing ? foldBase + 2 : foldBase + 1;
}

}

CodeView::CodeView(const Theme &theme, QWidget *parent) : QsciScintilla(parent), m_theme(theme)
{
    setLayoutDirection(Qt::LeftToRight); // code is not mirrored
    setAccessibleName(tr("Code that runs"));
    setAccessibleDescription(
        tr("Up and Down go from line to line. Enter runs to a line, or folds a section at its heading. %1 "
           "sets a breakpoint, %2 changes a parameter, %3 shows a value, %4 copies.")
            .arg(keyText(codeKeys::toggleBreakpoint), keyText(codeKeys::changeNumber),
                 keyText(codeKeys::showValue), keyText(QKeySequence::Copy)));
    const QSettings settings;
    if (settings.contains(foldedKey)) {
        const QStringList folded = settings.value(foldedKey).toStringList();
        m_folded = QSet<QString>(folded.begin(), folded.end());
    }
    setUp();
    applyTheme();
    connect(&theme, &Theme::changed, this, &CodeView::applyTheme);
    // Scintilla does not scroll the overlays that are painted over the text.
    connect(verticalScrollBar(), &QScrollBar::valueChanged, viewport(), qOverload<>(&QWidget::update));
    connect(horizontalScrollBar(), &QScrollBar::valueChanged, viewport(), qOverload<>(&QWidget::update));
}

void CodeView::setListing(const CodeListing &listing)
{
    m_listing = listing;
    m_chips.clear();
    m_marks.clear();
    m_spots.clear();
    layRows();
    m_row = 0;
    m_keepsRow = false;
    send(*this, SCI_SETFIRSTVISIBLELINE, 0);
}

void CodeView::layRows()
{
    m_rows = rowsOf(m_listing, m_gone);
    m_word.reset();
    m_newRow = 0;
    QStringList lines;
    for (const CodeRow &row : m_rows)
        lines << row.text;
    send(*this, SCI_SETSCROLLWIDTH, 1);
    setText(lines.join('\n'));
    styleText();
    strikeGone();
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        if (m_folded.contains(foldKey(m_rows[row])))
            send(*this, SCI_FOLDLINE, row, SC_FOLDACTION_CONTRACT);
    }
    applyMarks();
    send(*this, SCI_SETEMPTYSELECTION, 0);
}

void CodeView::styleText()
{
    QByteArray inks;
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        inks += m_rows[row].inks + '\0';
        send(*this, SCI_SETFOLDLEVEL, row, foldLevel(m_rows[row]));
        if (const CodeLine *shown = line(m_rows[row]))
            send(*this, SCI_MARGINSETTEXT, row, QByteArray::number(shown->source.number));
    }
    send(*this, SCI_STARTSTYLING);
    send(*this, SCI_SETSTYLINGEX, send(*this, SCI_GETLENGTH), inks);
}

void CodeView::setValues(std::vector<CodeChip> chips, std::vector<SectionMark> marks)
{
    const bool marksDiffer = marks != m_marks;
    if (!marksDiffer && chips == m_chips)
        return;
    m_chips = std::move(chips);
    m_marks = std::move(marks);
    if (marksDiffer)
        applyMarks();
    viewport()->update();
}

void CodeView::setBreakpoints(std::vector<Breakpoint> breakpoints)
{
    m_breakpoints = std::move(breakpoints);
    viewport()->update();
}

void CodeView::setSpots(std::vector<ParameterSpot> spots)
{
    if (spots == m_spots)
        return;
    m_spots = std::move(spots);
    underlineSpots();
}

void CodeView::underlineSpots()
{
    startIndicator(*this, spotIndicator);
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        for (const CodeWord &word : wordsOfRow(row)) {
            if (spotOf(row, word.from))
                fillIndicator(*this, positionOf(row, word.from), positionOf(row, word.from + word.length));
        }
    }
}

void CodeView::applyMarks()
{
    markerDeleteAll();
    startIndicator(*this, toComeIndicator);
    for (std::size_t row = 0; row < m_rows.size(); ++row)
        markRow(row);
}

void CodeView::markRow(std::size_t row)
{
    const QColor behind = wash(row);
    const bool marked = behind.isValid();
    const bool result = marked && isResult(m_rows[row]);
    send(*this, SCI_MARGINSETSTYLE, row, !marked ? number : result ? numberOnLine : numberInRegion);
    if (marked) {
        markerAdd(static_cast<int>(row), result ? lineText : regionText);
        markerAdd(static_cast<int>(row), result ? lineMargin : regionMargin);
    }
    if (isToCome(row) || isQuiet(row))
        fillIndicator(*this, positionOf(row, 0), send(*this, SCI_GETLINEENDPOSITION, row));
}

const SectionMark *CodeView::mark(const CodeRow &row) const
{
    return row.section < m_marks.size() ? &m_marks[row.section] : nullptr;
}

const CodeLine *CodeView::line(const CodeRow &row) const
{
    return row.kind == CodeRow::Kind::code ? &m_listing.sections[row.section].lines[row.line] : nullptr;
}

const CodeChip *CodeView::chip(const CodeRow &row) const
{
    if (row.kind != CodeRow::Kind::code)
        return nullptr;
    const auto found = std::find_if(m_chips.begin(), m_chips.end(), [&](const CodeChip &one) {
        return one.section == row.section && one.line == row.line;
    });
    return found == m_chips.end() ? nullptr : &*found;
}

bool CodeView::isResult(const CodeRow &row) const
{
    const SectionMark *its = mark(row);
    return row.kind == CodeRow::Kind::code && its && its->result == row.line;
}

QColor CodeView::wash(std::size_t row) const
{
    const CodeRow &its = m_rows[row];
    const bool inRegion = its.kind != CodeRow::Kind::heading && its.kind != CodeRow::Kind::gap;
    if (!inRegion || !mark(its) || mark(its)->when != When::now)
        return {};
    return isResult(its) ? m_theme.tokens().wash : m_theme.tokens().wash2;
}

bool CodeView::isQuiet(std::size_t row) const
{
    const CodeLine *its = line(m_rows[row]);
    return its && its->isQuiet;
}

bool CodeView::isToCome(std::size_t row) const
{
    const SectionMark *its = mark(m_rows[row]);
    return m_rows[row].kind == CodeRow::Kind::code && its &&
           (its->when == When::next || its->when == When::later);
}

}

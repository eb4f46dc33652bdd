// Keyboard navigation in the code, and positions of words.

#include "app/ui/code/code_scintilla.h"
#include "app/ui/code/engine/code_view.h"

#include <algorithm>

namespace app {

std::optional<std::size_t> CodeView::rowAt(const QPoint &position) const
{
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        if (rowRect(row).contains(position))
            return row;
    }
    return std::nullopt;
}

CodePlace CodeView::placeOf(std::size_t row) const
{
    const CodeLine *shown = row < m_rows.size() ? line(m_rows[row]) : nullptr;
    return shown ? CodePlace{shown->file, shown->source.number} : CodePlace{};
}

const Breakpoint *CodeView::breakpoint(std::size_t row) const
{
    const CodePlace place = placeOf(row);
    const auto found = std::find_if(m_breakpoints.begin(), m_breakpoints.end(),
                                    [&](const Breakpoint &one) { return one.place == place; });
    return found == m_breakpoints.end() ? nullptr : &*found;
}

long CodeView::positionOf(std::size_t row, qsizetype column) const
{
    return send(*this, SCI_POSITIONFROMLINE, row) +
           static_cast<long>(m_rows[row].text.left(column).toUtf8().size());
}

QRect CodeView::wordRect(std::size_t row, const CodeWord &word) const
{
    const auto x = [&](qsizetype column) {
        return static_cast<int>(send(*this, SCI_POINTXFROMPOSITION, 0, positionOf(row, column)));
    };
    const QRect rect = rowRect(row);
    const int left = x(word.from);
    return {left, rect.top(), x(word.from + word.length) - left, rect.height()};
}

std::vector<CodeWord> CodeView::wordsOfRow(std::size_t row) const
{
    return line(m_rows[row]) ? wordsOf(m_rows[row].text) : std::vector<CodeWord>{};
}

std::optional<std::pair<std::size_t, qsizetype>> CodeView::textAt(const QPoint &position) const
{
    const auto row = rowAt(position);
    if (!row || isInMargin(position))
        return std::nullopt;
    for (const CodeWord &word : wordsOfRow(*row)) {
        if (wordRect(*row, word).contains(position))
            return std::pair(*row, word.from);
    }
    return std::nullopt;
}

void CodeView::forgetWord(const QPoint &position)
{
    if (!m_hoveredWord || textAt(position) == m_hoveredWord)
        return;
    m_hoveredWord.reset();
    emit symbolDropped();
}

const ParameterSpot *CodeView::spotOf(std::size_t row, qsizetype column) const
{
    const CodeRow &its = m_rows[row];
    const auto found = std::find_if(m_spots.begin(), m_spots.end(), [&](const ParameterSpot &spot) {
        return its.kind == CodeRow::Kind::code && spot.section == its.section && spot.line == its.line &&
               spot.word.contains(column);
    });
    return found == m_spots.end() ? nullptr : &*found;
}

const ParameterSpot *CodeView::spotAt(const QPoint &position) const
{
    const auto row = rowAt(position);
    if (!row)
        return nullptr;
    if (const auto at = textAt(position))
        return spotOf(at->first, at->second);
    // The value at the end of a line counts only if the line reads exactly one parameter.
    const CodeChip *value = chip(m_rows[*row]);
    if (!value || !chipBox(*row).rect.contains(position))
        return nullptr;
    const ParameterSpot *only = nullptr;
    for (const CodeWord &word : wordsOfRow(*row)) {
        const ParameterSpot *spot = spotOf(*row, word.from);
        const bool isAnother = spot && only && spot->word.parameter != only->word.parameter;
        if (isAnother || (spot && !value->text.startsWith(spot->word.parameter + ' ')))
            return nullptr;
        only = spot ? spot : only;
    }
    return only;
}

void CodeView::goToRow(std::size_t row)
{
    m_row = row;
    m_word.reset();
    m_keepsRow = false;
    scrollTo(row, row);
    emit symbolDropped();
    viewport()->update();
}

void CodeView::moveByRows(int by, bool onlyHeadings)
{
    const auto count = static_cast<std::ptrdiff_t>(m_rows.size());
    for (auto row = static_cast<std::ptrdiff_t>(m_row) + by; row >= 0 && row < count; row += by) {
        const auto at = static_cast<std::size_t>(row);
        const bool isHeading = m_rows[at].kind == CodeRow::Kind::heading;
        const bool isLine =
            line(m_rows[at]) || m_rows[at].kind == CodeRow::Kind::gone || !foldKey(m_rows[at]).isEmpty();
        const bool counts = isHeading || (!onlyHeadings && isLine);
        if (!counts || rowRect(at).isEmpty())
            continue;
        goToRow(at);
        return;
    }
}

void CodeView::moveByWords(int by)
{
    const std::vector<CodeWord> words = wordsOfRow(m_row);
    if (words.empty())
        return;
    const auto now = m_word ? std::find(words.begin(), words.end(), *m_word) : words.end();
    const auto count = static_cast<std::ptrdiff_t>(words.size());
    const std::ptrdiff_t at = now == words.end() ? (by > 0 ? 0 : count - 1) : now - words.begin() + by;
    m_word = words[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(at, 0, count - 1))];
    emit symbolDropped();
}

qsizetype CodeView::column() const
{
    if (m_word)
        return m_word->from;
    const std::vector<CodeWord> words = wordsOfRow(m_row);
    return words.empty() ? -1 : words.front().from;
}

void CodeView::actOnRow()
{
    const CodeRow &its = m_rows[m_row];
    if (const QString key = foldKey(its); !key.isEmpty())
        toggle(key);
    else if (line(its))
        emit runRequested(m_row);
}

void CodeView::askNumber()
{
    for (const CodeWord &word : m_word ? std::vector{*m_word} : wordsOfRow(m_row)) {
        if (const ParameterSpot *spot = spotOf(m_row, word.from)) {
            emit numberRequested(*spot);
            return;
        }
    }
}

void CodeView::askSymbol()
{
    if (line(m_rows[m_row]))
        emit symbolRequested(m_row, column());
}

void CodeView::showPlace(const CodePlace &place)
{
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        if (placeOf(row) != place || !line(m_rows[row]))
            continue;
        unfold(row);
        goToRow(row);
        m_keepsRow = true;
        return;
    }
}

QString CodeView::sectionText() const
{
    return m_rows.empty() ? QString() : plainText(m_listing.sections[m_rows[m_row].section]);
}

}

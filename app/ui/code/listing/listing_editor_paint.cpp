// Values, arrow and marks that are painted over the listing.

#include "app/ui/actions/command.h"
#include "app/ui/code/code_colors.h"
#include "app/ui/code/code_keys.h"
#include "app/ui/code/code_scintilla.h"
#include "app/ui/code/listing/listing_editor.h"
#include "app/ui/code/margin_marks.h"
#include "app/ui/theme/theme.h"

#include <QPaintEvent>
#include <QPainter>
#include <QPainterPath>
#include <QScrollBar>

#include <algorithm>

namespace app {

namespace {

using Margins = CodeMargins;

constexpr int stopWidth = 13; ///< of the place for a dot, left of the numbers

}

QPoint ListingEditor::placeOf(long position) const
{
    return {static_cast<int>(send(*this, SCI_POINTXFROMPOSITION, 0, position)),
            static_cast<int>(send(*this, SCI_POINTYFROMPOSITION, 0, position))};
}

int ListingEditor::rowHeight() const
{
    return static_cast<int>(send(*this, SCI_TEXTHEIGHT, 0));
}

QRect ListingEditor::firstRow(int line) const
{
    return {0, placeOf(positionOf(line, 1)).y(), viewport()->width(), rowHeight()};
}

QRect ListingEditor::lineRect(int line) const
{
    QRect rows = firstRow(line);
    rows.setHeight(rowHeight() * static_cast<int>(send(*this, SCI_WRAPCOUNT, line - 1)));
    return rows;
}

QRect ListingEditor::stopRect(int line) const
{
    QRect place = firstRow(line);
    place.setWidth(stopWidth);
    return place;
}

QRect ListingEditor::wordRect(const TextRange &range) const
{
    const QPoint from = placeOf(positionOf(range));
    const QPoint last = placeOf(positionOf(range.line, range.column + range.length - 1));
    // Behind the last letter the next row can begin.
    const auto letter = static_cast<int>(send(*this, SCI_TEXTWIDTH, STYLE_DEFAULT, "x"));
    return {from, QPoint(last.x() + letter - 1, from.y() + rowHeight() - 1)};
}

QPoint ListingEditor::endOfCode(int line) const
{
    QString code = text(line - 1);
    while (code.endsWith('\n') || code.endsWith('\r'))
        code.chop(1);
    const QByteArray inks = inksOf(code);
    const qsizetype comment = inks.indexOf(static_cast<char>(Ink::comment));
    qsizetype length = comment < 0 ? code.size() : QString::fromUtf8(code.toUtf8().left(comment)).size();
    while (length > 0 && code[length - 1].isSpace())
        --length;
    return placeOf(positionOf(line, static_cast<int>(length) + 1));
}

const LineChip *ListingEditor::valueOf(int line) const
{
    const auto found = std::find_if(m_values.chips.begin(), m_values.chips.end(),
                                    [line](const LineChip &chip) { return chip.line == line; });
    return found == m_values.chips.end() ? nullptr : &*found;
}

QStringList ListingEditor::formsOf(int line) const
{
    // The turn of a loop says the value of its counter, too.
    for (const LoopNote &loop : m_values.loops) {
        if (loop.line == line)
            return {loop.text};
    }
    const LineChip *value = valueOf(line);
    return value ? QStringList(value->text) + value->shorter : QStringList();
}

bool ListingEditor::isTypedIn(int line) const
{
    int caretLine = 0, index = 0;
    getCursorPosition(&caretLine, &index);
    return hasFocus() && caretLine == line - 1;
}

ValueChip ListingEditor::chipOf(int line) const
{
    QStringList forms = formsOf(line);
    if (forms.isEmpty())
        return {};
    const QPoint end = endOfCode(line);
    ChipRoom room{QRect(0, end.y(), viewport()->width(), rowHeight()), end.x(),
                  verticalScrollBar()->isVisible()};
    const ValueChip beside = fitChip(forms, room, m_theme);
    const LineChip *value = valueOf(line);
    const bool isLoop = std::any_of(m_values.loops.begin(), m_values.loops.end(),
                                    [line](const LoopNote &loop) { return loop.line == line; });
    const bool isNews = isLoop || (value && value->isChanged);
    if (!isNews || isTypedIn(line) || forms.contains(beside.text))
        return beside;
    // What has just changed matters more than the end of a long line, unless the learner types there.
    room.endOfCode = marginsWidth();
    if (forms.size() > 1)
        forms.removeFirst();
    return fitChip(forms, room, m_theme);
}

bool ListingEditor::isChanged(int line) const
{
    return std::binary_search(m_changed.changed.begin(), m_changed.changed.end(), line);
}

const LineStop *ListingEditor::stopOf(int line) const
{
    const auto found = std::find_if(m_stops.begin(), m_stops.end(),
                                    [line](const LineStop &stop) { return stop.line == line; });
    return found == m_stops.end() ? nullptr : &*found;
}

void ListingEditor::paintEvent(QPaintEvent *event)
{
    QsciScintilla::paintEvent(event);
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    for (int line = 1; line <= lines(); ++line) {
        if (lineRect(line).intersects(event->rect()))
            paintLine(painter, line);
    }
}

/// Paints how a line differs from the step's own listing.
void ListingEditor::paintChange(QPainter &painter, int line) const
{
    const Tokens &t = m_theme.tokens();
    const QRect row = lineRect(line);
    if (isChanged(line))
        painter.fillRect(QRect(Margins::bar, row.top(), Margins::barWidth, row.height()), t.ok);
    // A notch between two lines marks lines of the original that are missing there.
    const auto &removed = m_changed.removedBefore;
    const auto paintNotch = [&](int y) {
        QPainterPath notch;
        notch.addPolygon(QPolygonF{QPointF(Margins::bar, y - 3.5), QPointF(Margins::bar + 5.0, y),
                                   QPointF(Margins::bar, y + 3.5)});
        painter.fillPath(notch, t.past);
    };
    if (std::find(removed.begin(), removed.end(), line) != removed.end())
        paintNotch(std::max(4, row.top()));
    if (line == lines() && std::find(removed.begin(), removed.end(), line + 1) != removed.end())
        paintNotch(row.bottom());
}

void ListingEditor::paintLine(QPainter &painter, int line) const
{
    const Tokens &t = m_theme.tokens();
    const QRect row = lineRect(line);
    paintChange(painter, line);
    if (const LineStop *stop = stopOf(line))
        paintBreakpoint(painter, QRectF(stopRect(line)).center(), stop->isOn, stop->hasCondition, m_theme);
    const bool isNext = line == m_marks.next;
    if (isNext || line == m_marks.failed)
        paintMarginArrow(painter, row.top(), line == m_marks.failed ? t.past : t.now);
    const bool isMarked = isNext && m_marks.isInside;
    if (isMarked)
        paintLineFrame(painter, row, m_theme);
    const ValueChip chip = chipOf(line);
    const LineChip *value = valueOf(line);
    const ValueChip::Look look = value && value->isChanged    ? ValueChip::Look::changed
                                 : value && !value->isInScope ? ValueChip::Look::earlier
                                                              : ValueChip::Look::plain;
    chip.paint(painter, look, isMarked ? t.wash : t.panel, m_theme);
}

QString ListingEditor::tipAt(const QPoint &place) const
{
    const int line = lineAt(place);
    if (line == 0)
        return {};
    if (chipOf(line).rect.contains(place)) {
        const LineChip *value = valueOf(line);
        return value ? value->tip : formsOf(line).first();
    }
    if (m_kind == Kind::listing && place.x() < marginsWidth()) {
        const QString what = withKeys(
            stopOf(line) ? tr("The run stops before this line. Click the dot to remove the breakpoint")
                         : tr("Click to run to this line. Ctrl+click sets a breakpoint"),
            codeKeys::toggleBreakpoint);
        return isChanged(line) ? tr("You changed this line. %1").arg(what) : what;
    }
    for (const CodeMistake &mistake : m_mistakes) {
        if (mistake.line == line && wordRect({mistake.line, mistake.column, mistake.length}).contains(place))
            return mistake.sentence;
    }
    return {};
}

}

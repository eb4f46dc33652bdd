#include "app/ui/code/code_colors.h"
#include "app/ui/code/code_scintilla.h"
#include "app/ui/code/engine/code_view.h"
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

constexpr int noteRight = 12;

}

int CodeView::rowHeight() const
{
    return static_cast<int>(send(*this, SCI_TEXTHEIGHT, 0));
}

QRect CodeView::rowRect(std::size_t row) const
{
    if (send(*this, SCI_GETLINEVISIBLE, row) == 0)
        return {};
    const int height = rowHeight();
    const long above = send(*this, SCI_VISIBLEFROMDOCLINE, row) - send(*this, SCI_GETFIRSTVISIBLELINE);
    return {0, static_cast<int>(above) * height, viewport()->width(), height};
}

int CodeView::endOfText(std::size_t row) const
{
    return static_cast<int>(send(*this, SCI_POINTXFROMPOSITION, 0, send(*this, SCI_GETLINEENDPOSITION, row)));
}

int CodeView::endOfCode(std::size_t row) const
{
    const QByteArray &inks = m_rows[row].inks;
    qsizetype end = inks.indexOf(static_cast<char>(Ink::comment));
    const QByteArray text = m_rows[row].text.toUtf8();
    end = end < 0 ? text.size() : end;
    while (end > 0 && text[end - 1] == ' ')
        --end;
    const long start = send(*this, SCI_POSITIONFROMLINE, row);
    return static_cast<int>(send(*this, SCI_POINTXFROMPOSITION, 0, start + static_cast<long>(end)));
}

ValueChip CodeView::chipBox(std::size_t row) const
{
    const CodeChip *its = chip(m_rows[row]);
    const QRect rect = rowRect(row);
    if (!its || rect.isEmpty())
        return {};
    const ChipRoom room{rect, endOfCode(row), verticalScrollBar()->isVisible()};
    return fitChip(QStringList(its->text) + its->shorter, room, m_theme);
}

void CodeView::paintEvent(QPaintEvent *event)
{
    QsciScintilla::paintEvent(event);
    QPainter painter(viewport());
    painter.setRenderHint(QPainter::Antialiasing);
    for (std::size_t row = 0; row < m_rows.size(); ++row) {
        if (rowRect(row).intersects(event->rect()))
            paintRow(painter, row);
    }
    if (hasFocus() && m_byKeyboard)
        paintFocus(painter);
}

void CodeView::paintRow(QPainter &painter, std::size_t row) const
{
    const CodeRow &its = m_rows[row];
    if (its.kind == CodeRow::Kind::gap)
        return;
    const QRect rect = rowRect(row);
    painter.fillRect(QRect(Margins::bar, rect.top(), Margins::barWidth, rect.height()),
                     m_theme.kindColor(m_listing.sections[its.section].kind));
    if (!foldKey(its).isEmpty())
        paintChevron(painter, row);
    if (its.kind == CodeRow::Kind::heading)
        paintHeading(painter, row);
    if (its.kind == CodeRow::Kind::code) {
        paintSymbol(painter, row);
        paintChip(painter, row);
    }
    if (its.kind == CodeRow::Kind::gone)
        paintSign(painter, row, QStringLiteral("−"), m_theme.tokens().ink2);
    if (isResult(its))
        paintLineFrame(painter, rect, m_theme);
}

void CodeView::paintChevron(QPainter &painter, std::size_t row) const
{
    const bool hides = m_folded.contains(foldKey(m_rows[row]));
    const QIcon chevron =
        m_theme.icon(hides ? QStringLiteral("right") : QStringLiteral("down"), m_theme.tokens().ink3);
    chevron.paint(&painter, QRect(Margins::symbol, rowRect(row).top() + 4, 12, 12));
}

void CodeView::paintHeading(QPainter &painter, std::size_t row) const
{
    const CodeRow &its = m_rows[row];
    const QRect rect = rowRect(row);
    const SectionMark *at = mark(its);
    if (!at || at->note.isEmpty())
        return;
    painter.setFont(m_theme.ui(12));
    painter.setPen(m_theme.tokens().ink3);
    const int room = rect.right() + 1 - noteRight - endOfText(row) - 12;
    for (const QString &note : {at->note, at->shortNote}) {
        if (painter.fontMetrics().horizontalAdvance(note) > room)
            continue;
        painter.drawText(rect.adjusted(0, 0, -noteRight, 0), Qt::AlignRight | Qt::AlignVCenter, note);
        return;
    }
}

void CodeView::paintSymbol(QPainter &painter, std::size_t row) const
{
    const QRect rect = rowRect(row);
    if (const Breakpoint *its = breakpoint(row)) {
        const QPointF centre(Margins::symbol + 6.5, rect.center().y() + 0.5);
        paintBreakpoint(painter, centre, its->isOn, !its->condition.isEmpty(), m_theme);
        return;
    }
    if (isResult(m_rows[row])) {
        paintMarginArrow(painter, rect.top(), m_theme.tokens().now);
        return;
    }
    if (line(m_rows[row])->isNew)
        paintSign(painter, row, QStringLiteral("+"), m_theme.tokens().ok);
}

void CodeView::paintSign(QPainter &painter, std::size_t row, const QString &sign, const QColor &ink) const
{
    const QRect rect = rowRect(row);
    QFont font = m_theme.mono(11);
    font.setWeight(QFont::DemiBold);
    painter.setFont(font);
    painter.setPen(ink);
    painter.drawText(QRect(Margins::symbol, rect.top(), Margins::bar - Margins::symbol, rect.height()),
                     Qt::AlignCenter, sign);
}

void CodeView::paintChip(QPainter &painter, std::size_t row) const
{
    const ValueChip chip = chipBox(row);
    const SectionMark *at = mark(m_rows[row]);
    const bool isNow = at && at->selected && isResult(m_rows[row]);
    const QColor behind = wash(row).isValid() ? wash(row) : m_theme.tokens().panel;
    chip.paint(painter, isNow ? ValueChip::Look::now : ValueChip::Look::plain, behind, m_theme);
}

void CodeView::paintFocus(QPainter &painter) const
{
    const QRect shown = viewport()->rect();
    const QRect whole = m_row < m_rows.size() ? rowRect(m_row) : QRect();
    QRect ring = shown; // the row is scrolled out of view
    painter.setBrush(Qt::NoBrush);
    if (!whole.isEmpty() && shown.contains(whole)) {
        ring =
            whole.adjusted(Margins::bar + Margins::barWidth + 2, 0, endOfText(m_row) + 5 - whole.width(), 0);
        if (m_word) {
            painter.setPen(QPen(m_theme.tokens().ink, 1));
            painter.drawRect(QRectF(wordRect(m_row, *m_word)).adjusted(-1.5, 3.5, 1.5, -3.5));
        }
    }
    painter.setPen(QPen(m_theme.tokens().ink, 2));
    painter.drawRoundedRect(QRectF(ring).adjusted(1, 1, -1, -1), 6, 6);
}

}

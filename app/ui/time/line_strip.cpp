#include "app/ui/time/line_strip.h"

#include "app/model/listing/listing_frame.h"

#include <QFontMetricsF>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double cornerRadius = 7.0;
constexpr double textPadding = 20.0;   ///< px, of the next line's text, both sides together
constexpr double mostOfStrip = 0.6;    ///< the largest part of the strip that the next line takes
constexpr double leastForNumber = 6.0; ///< px beside a number
constexpr double leastForRule = 5.0;   ///< px, the narrowest cell with a line beside it
constexpr double textSize = 12.0;
constexpr double doneBar = 3.0; ///< px, the height of the bar above the lines that have run

}

void LineStrip::setContent(const ListingFrame *frame, const QString &text, int index)
{
    m_cells.clear();
    m_text = text.split('\n');
    m_index = index;
    for (int i = 0; frame && i < frame->count(); ++i)
        m_cells.push_back({frame->line(i).line, frame->line(i).depth, {}});
}

QString LineStrip::textOf(int index) const
{
    return m_text.value(lineOf(index) - 1).trimmed();
}

void LineStrip::arrange(const QRectF &area, const Theme &theme)
{
    m_area = area;
    if (m_cells.empty())
        return;
    const double share = area.width() / count();
    double next = share;
    if (m_index < count()) {
        const QString label = QStringLiteral("%1  %2").arg(lineOf(m_index)).arg(textOf(m_index));
        const double wanted = QFontMetricsF(theme.mono(textSize)).horizontalAdvance(label) + textPadding;
        next = std::max(share, std::min(wanted, mostOfStrip * area.width()));
    }
    const double other = count() > 1 ? (area.width() - next) / (count() - 1) : 0.0;
    double x = area.left();
    for (int i = 0; i < count(); ++i) {
        const double width = i == m_index ? next : m_index < count() ? other : share;
        m_cells[static_cast<std::size_t>(i)].area = QRectF(x, area.top(), width, area.height());
        x += width;
    }
}

int LineStrip::indexAt(const QPointF &place) const
{
    const auto found = std::find_if(m_cells.begin(), m_cells.end(),
                                    [&](const Cell &cell) { return cell.area.contains(place); });
    return found == m_cells.end() ? -1 : static_cast<int>(found - m_cells.begin());
}

void LineStrip::paint(QPainter &painter, const Theme &theme, bool playing, int hovered) const
{
    const Tokens &t = theme.tokens();
    painter.setRenderHint(QPainter::Antialiasing);
    QPainterPath outline;
    outline.addRoundedRect(m_area.adjusted(0.5, 0, -0.5, 0), cornerRadius, cornerRadius);
    painter.fillPath(outline, playing ? t.panel : t.scene);
    painter.save();
    painter.setClipPath(outline);
    for (int i = 0; i < count(); ++i) {
        const bool isNow = i == m_index && !playing;
        if (isNow)
            painter.fillRect(areaOf(i), t.now);
        else if (i == hovered)
            painter.fillRect(areaOf(i), t.hover);
        paintCell(painter, theme, i, isNow);
    }
    // As on the track of the timeline, a bar shows how far the frame has run.
    const double run = m_index < count() ? areaOf(m_index).left() : m_area.right();
    if (!playing && count() > 0)
        painter.fillRect(QRectF(m_area.left(), m_area.top(), run - m_area.left(), doneBar), t.ink2);
    painter.restore();
    painter.setPen(t.line2);
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(outline);
}

void LineStrip::paintCell(QPainter &painter, const Theme &theme, int index, bool isNow) const
{
    const Tokens &t = theme.tokens();
    const QRectF area = areaOf(index);
    const QFont font = theme.mono(textSize);
    const QFontMetricsF metrics(font);
    if (index > 0 && area.width() >= leastForRule) {
        painter.setPen(t.line2);
        const double x = std::floor(area.left()) + 0.5;
        painter.drawLine(QPointF(x, area.top() + 6), QPointF(x, area.bottom() - 6));
    }
    painter.setFont(font);
    painter.setPen(isNow ? t.nowText : index < m_index ? t.ink : t.ink3);
    const QString number = QString::number(lineOf(index));
    if (isNow) {
        const QString label = QStringLiteral("%1  %2").arg(number, textOf(index));
        painter.drawText(area.adjusted(2, 0, -2, 0), Qt::AlignCenter,
                         metrics.elidedText(label, Qt::ElideRight, area.width() - 8));
    } else if (metrics.horizontalAdvance(number) + leastForNumber <= area.width()) {
        painter.drawText(area, Qt::AlignCenter, number);
    }
    if (m_cells[static_cast<std::size_t>(index)].depth == 0)
        return;
    // A bar marks the lines of functions that `frame` calls.
    painter.fillRect(QRectF(area.left(), area.bottom() - 3, area.width(), 2), isNow ? t.nowText : t.line2);
}

}

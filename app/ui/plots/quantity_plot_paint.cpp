// The cursors of a plot of quantities, and what is written on it.

#include "app/model/quantity_words.h"
#include "app/ui/plots/quantity_plot.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int emptyWidth = 420; ///< px: longer lines are hard to read

}

QPointF QuantityPlot::place(double across, double up) const
{
    return {xAxis->coordToPixel(across), yAxis->coordToPixel(up)};
}

QPointF QuantityPlot::placeOf(std::int64_t frame) const
{
    const Samples &run = m_course.run();
    const std::size_t bucket = run.bucketNear(frame);
    return place(run.at(bucket, m_across).first, run.at(bucket, m_up).first);
}

QPointF QuantityPlot::placeOf(const Spot &spot) const
{
    return place(spot.across, spot.up);
}

std::optional<QPointF> QuantityPlot::insidePlace() const
{
    return m_inside ? std::optional(placeOf(*m_inside)) : std::nullopt;
}

void QuantityPlot::paintMarks(QPainter &painter) const
{
    if (m_empty.isEmpty())
        paintUnits(painter);
    else
        paintEmpty(painter);
    paintNow(painter);
}

void QuantityPlot::paintUnits(QPainter &painter) const
{
    const QRectF area = axisRect()->rect();
    painter.setFont(m_theme.ui(12));
    painter.setPen(m_theme.tokens().ink3);
    const double line = painter.fontMetrics().height();
    const QString down = pointsDown(m_spec.up.what) ? QStringLiteral(" ↓") : QString();
    painter.drawText(QRectF(6.0, 2.0, area.width(), line), Qt::AlignLeft | Qt::AlignVCenter,
                     unit(m_spec.up) + down);
    if (m_spec.isAgainstTime()) {
        const double labels = area.bottom() + 7.0;
        painter.drawText(QRectF(0.0, labels, area.left() - 12.0, line), Qt::AlignRight | Qt::AlignVCenter,
                         tr("frame"));
        return;
    }
    const QString across = quantityTitle(m_course.bound(m_spec.across));
    painter.drawText(QRectF(area.left(), height() - line - 3.0, area.width(), line),
                     Qt::AlignRight | Qt::AlignVCenter, tr("%1, %2").arg(across, unit(m_spec.across)));
}

void QuantityPlot::paintNow(QPainter &painter) const
{
    const QPointF now = placeOf(m_now);
    if (m_spec.isAgainstTime())
        paintCursor(painter, now.x());
    if (m_inside)
        paintInside(painter, placeOf(*m_inside));
    paintDot(painter, now); // on top: it stays in sight where both are near each other
}

QString QuantityPlot::hoveredText(std::int64_t frame) const
{
    const Samples &run = m_course.run();
    if (!m_empty.isEmpty() || run.isEmpty() || m_up >= run.columns() || m_across >= run.columns())
        return {};
    const std::size_t bucket = run.bucketNear(frame);
    return tr("frame %1: %2")
        .arg(run.frameOf(bucket))
        .arg(readout(run.at(bucket, m_up).first, run.at(bucket, m_across).first));
}

void QuantityPlot::paintHovered(QPainter &painter, std::int64_t frame) const
{
    const QString text = hoveredText(frame);
    if (text.isEmpty())
        return;
    const QPointF dot = placeOf(frame);
    if (!std::isfinite(dot.x()))
        return;
    if (m_spec.isAgainstTime())
        paintHoveredLine(painter, dot.x());
    paintHoveredDot(painter, dot);
    paintTag(painter, dot, text);
}

void QuantityPlot::paintEmpty(QPainter &painter) const
{
    const QRectF area = QRectF(axisRect()->rect()).adjusted(12.0, 8.0, -12.0, -8.0);
    const QRectF room(area.left(), area.top(), std::min<double>(area.width(), emptyWidth), area.height());
    painter.setFont(m_theme.ui(13));
    const QRectF text = painter.fontMetrics().boundingRect(
        room.toRect(), Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, m_empty);
    painter.fillRect(text.adjusted(-4.0, -2.0, 4.0, 2.0), m_theme.tokens().panel);
    painter.setPen(m_theme.tokens().ink3);
    painter.drawText(room, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextWordWrap, m_empty);
}

}

// The cursors of a plot of quantities, and what is written on it.

#include "app/model/quantity_words.h"
#include "app/ui/plots/quantity_plot.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double dotRadius = 4.5; ///< px
constexpr double headWidth = 9.0; ///< px, of the pentagon that the cursor hangs from
constexpr double headHeight = 11.0;
constexpr double tagHeight = 20.0;
constexpr double tagPadding = 7.0;
constexpr int emptyWidth = 420; ///< px: longer lines are hard to read

/// The head of the timeline, small: where it points is `tip`.
QPolygonF headAt(QPointF tip)
{
    const double half = headWidth / 2.0, shoulder = headHeight - half;
    return {{tip.x() - half, tip.y() - headHeight},
            {tip.x() + half, tip.y() - headHeight},
            {tip.x() + half, tip.y() - headHeight + shoulder},
            tip,
            {tip.x() - half, tip.y() - headHeight + shoulder}};
}

void paintDot(QPainter &painter, QPointF at, const QColor &fill, const QPen &rim)
{
    painter.setPen(rim);
    painter.setBrush(fill);
    painter.drawEllipse(at, dotRadius, dotRadius);
    painter.setBrush(Qt::NoBrush);
}

bool isSomewhere(QPointF place)
{
    return std::isfinite(place.x()) && std::isfinite(place.y());
}

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

void QuantityPlot::paintEvent(QPaintEvent *event)
{
    QCustomPlot::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintMarks(painter);
    if (m_hovered && m_empty.isEmpty())
        paintHovered(painter);
    if (!m_isRinged)
        return;
    painter.setPen(QPen(m_theme.tokens().ink, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(2.0, 2.0, -2.0, -2.0), 6.0, 6.0);
}

void QuantityPlot::paintPicture(QCPPainter &painter)
{
    toPainter(&painter, width(), height());
    painter.setRenderHint(QPainter::Antialiasing);
    paintMarks(painter);
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
    const Tokens &t = m_theme.tokens();
    const QRectF area = axisRect()->rect();
    const bool isAgainstTime = m_spec.isAgainstTime();
    const double frame = static_cast<double>(m_session.timeline().at().frame);
    if (isAgainstTime) {
        const double x = xAxis->coordToPixel(frame);
        if (x < area.left() - 1.0 || x > area.right() + 1.0)
            return;
        painter.setPen(QPen(t.now, 2.0, Qt::SolidLine, Qt::FlatCap));
        painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
        painter.setPen(Qt::NoPen);
        painter.setBrush(t.now);
        painter.drawPolygon(headAt({x, area.top() + 1.0}));
    }
    const QPointF dot = place(isAgainstTime ? frame : m_nowAcross, m_nowUp);
    if (isSomewhere(dot) && area.adjusted(-2.0, -2.0, 2.0, 2.0).contains(dot))
        paintDot(painter, dot, t.now, QPen(t.panel, 1.5));
}

void QuantityPlot::paintHovered(QPainter &painter) const
{
    const Samples &run = m_course.run();
    if (run.isEmpty() || m_up >= run.columns() || m_across >= run.columns())
        return;
    const Tokens &t = m_theme.tokens();
    const QRectF area = axisRect()->rect();
    const std::size_t bucket = run.bucketNear(*m_hovered);
    const QPointF dot = placeOf(*m_hovered);
    if (!std::isfinite(dot.x()))
        return;
    if (m_spec.isAgainstTime()) {
        painter.setPen(QPen(t.ink3, 1.0));
        painter.drawLine(QPointF(dot.x(), area.top()), QPointF(dot.x(), area.bottom()));
    }
    if (isSomewhere(dot))
        paintDot(painter, dot, t.panel, QPen(t.ink2, 1.5));
    const QString text = tr("frame %1: %2")
                             .arg(run.frameOf(bucket))
                             .arg(readout(run.at(bucket, m_up).first, run.at(bucket, m_across).first));
    painter.setFont(m_theme.ui(12));
    const double wide = QFontMetricsF(painter.font()).horizontalAdvance(text) + 2.0 * tagPadding;
    const double most = width() - wide - 4.0;
    const double left = std::clamp(dot.x() - wide / 2.0, 4.0, std::max(4.0, most));
    // Over the curve where there is room, and else below it: never on the dot.
    const bool isHigh = isSomewhere(dot) && dot.y() < area.top() + tagHeight + 2.0 * dotRadius;
    const QRectF tag(left, isHigh ? area.bottom() - tagHeight - 3.0 : area.top() + 3.0, wide, tagHeight);
    painter.setPen(QPen(t.line2, 1.0));
    painter.setBrush(t.panel);
    painter.drawRoundedRect(tag, 4.0, 4.0);
    painter.setPen(t.ink);
    painter.drawText(tag, Qt::AlignCenter, text);
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

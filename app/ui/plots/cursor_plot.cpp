#include "app/ui/plots/cursor_plot.h"

#include "app/ui/plots/number_ticker.h"

#include <algorithm>

namespace app {

namespace {

constexpr double dotRadius = 4.5; ///< px
constexpr double headWidth = 9.0; ///< px, of the pentagon that the cursor hangs from
constexpr double headHeight = 11.0;
constexpr double tagHeight = 20.0;
constexpr double tagPadding = 7.0;
constexpr double roomAtEnd = 0.02; ///< of the time axis

/// Returns the head of the timeline's cursor, smaller. It points at `tip`.
QPolygonF headAt(QPointF tip)
{
    const double half = headWidth / 2.0, shoulder = headHeight - half;
    return {{tip.x() - half, tip.y() - headHeight},
            {tip.x() + half, tip.y() - headHeight},
            {tip.x() + half, tip.y() - headHeight + shoulder},
            tip,
            {tip.x() - half, tip.y() - headHeight + shoulder}};
}

void paintDisc(QPainter &painter, QPointF at, const QColor &fill, const QPen &rim)
{
    painter.setPen(rim);
    painter.setBrush(fill);
    painter.drawEllipse(at, dotRadius, dotRadius);
    painter.setBrush(Qt::NoBrush);
}

/// Returns whether a dot at a place is within the axes or on their edge.
bool isWithin(const QCPAxisRect &axes, QPointF at)
{
    return isFinite(at) && QRectF(axes.rect()).adjusted(-2.0, -2.0, 2.0, 2.0).contains(at);
}

}

CursorPlot::CursorPlot(const OpenRun &run, Playback &playback, const Theme &theme, QWidget *parent)
    : Plot(theme, parent), m_run(run), m_playback(playback)
{
    setPlottingHint(QCP::phFastPolylines); // line by line: as one outline a curve takes tens of times as long
    setCursor(Qt::PointingHandCursor);
    xAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(5)));
    yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new NumberTicker(4)));
}

void CursorPlot::setHovered(std::optional<std::int64_t> frame)
{
    if (frame == m_hovered)
        return;
    m_hovered = frame;
    update();
}

QString CursorPlot::spokenValue() const
{
    const QString hovered = m_hovered ? hoveredText(*m_hovered) : QString();
    return hovered.isEmpty() ? sentence() : tr("%1. Under the mouse: %2").arg(sentence(), hovered);
}

void CursorPlot::announceCursor()
{
    if (!m_playback.isPlaying())
        announceValue();
}

void CursorPlot::setTimeRange(double first, double last)
{
    xAxis->setRange(first, last + roomAtEnd * (last - first));
}

double CursorPlot::timeAt(QPointF place) const
{
    return std::clamp(xAxis->pixelToCoord(place.x()), xAxis->range().lower, xAxis->range().upper);
}

void CursorPlot::goTo(QPointF place)
{
    const std::optional<std::int64_t> frame = frameAt(place);
    // A hand that trembles within one frame asks for nothing new.
    if (!frame || *frame == m_playback.goal().value_or(cursorFrame()))
        return;
    m_playback.goTo({*frame, 0});
}

void CursorPlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !frameAt(event->position())) {
        event->ignore();
        return;
    }
    m_isDragging = true;
    emit pointedAt(std::nullopt);
    m_playback.pause();
    if (m_run.timeline().cursor().phase > 0)
        m_playback.goTo({*frameAt(event->position()), 0});
    else
        goTo(event->position());
}

void CursorPlot::mouseMoveEvent(QMouseEvent *event)
{
    if (m_isDragging)
        goTo(event->position());
    else
        emit pointedAt(frameAt(event->position()));
}

void CursorPlot::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        m_isDragging = false;
}

void CursorPlot::mouseDoubleClickEvent(QMouseEvent *event)
{
    mousePressEvent(event);
}

void CursorPlot::wheelEvent(QWheelEvent *event)
{
    event->ignore(); // the panel scrolls
}

void CursorPlot::leaveEvent(QEvent *)
{
    emit pointedAt(std::nullopt);
}

bool CursorPlot::wantsKey(const QKeyEvent &event) const
{
    return isPlainKey(event, Qt::ShiftModifier) &&
           (event.key() == Qt::Key_Left || event.key() == Qt::Key_Right);
}

void CursorPlot::keyPressEvent(QKeyEvent *event)
{
    const bool isPhase = event->modifiers() & Qt::ShiftModifier;
    if (event->key() == Qt::Key_Left)
        isPhase ? m_playback.phaseBack() : m_playback.frameBack();
    else if (event->key() == Qt::Key_Right)
        isPhase ? m_playback.phaseForward() : m_playback.frameForward();
    else
        Plot::keyPressEvent(event);
}

void CursorPlot::paintCursor(QPainter &painter, double x) const
{
    const Tokens &t = m_theme.tokens();
    const QRectF area = axisRect()->rect();
    if (x < area.left() - 1.0 || x > area.right() + 1.0)
        return;
    painter.setPen(QPen(t.now, 2.0, Qt::SolidLine, Qt::FlatCap));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
    painter.setPen(Qt::NoPen);
    painter.setBrush(t.now);
    painter.drawPolygon(headAt({x, area.top() + 1.0}));
    painter.setBrush(Qt::NoBrush);
}

void CursorPlot::paintDot(QPainter &painter, QPointF at) const
{
    if (isWithin(*axisRect(), at))
        paintDisc(painter, at, m_theme.tokens().now, QPen(m_theme.tokens().panel, 1.5));
}

void CursorPlot::paintInside(QPainter &painter, QPointF at) const
{
    if (isWithin(*axisRect(), at))
        paintDisc(painter, at, m_theme.tokens().panel, QPen(m_theme.tokens().now, 1.5));
}

void CursorPlot::paintPointer(QPainter &painter)
{
    const std::vector<QPointF> dots = m_hovered ? curvesAt(*m_hovered) : std::vector<QPointF>{};
    if (dots.empty())
        return;
    const Tokens &t = m_theme.tokens();
    const QRectF area = axisRect()->rect();
    if (hasTimeAxis()) {
        painter.setPen(QPen(t.ink3, 1.0));
        painter.drawLine(QPointF(dots.front().x(), area.top()), QPointF(dots.front().x(), area.bottom()));
    }
    QPointF highest = dots.front();
    for (const QPointF dot : dots) {
        if (isFinite(dot))
            paintDisc(painter, dot, t.panel, QPen(t.ink2, 1.5));
        if (dot.y() < highest.y())
            highest = dot;
    }
    paintTag(painter, highest, hoveredText(*m_hovered));
}

/// Paints a text in a box at the top, or at the bottom where it would hide `dot`.
void CursorPlot::paintTag(QPainter &painter, QPointF dot, const QString &text) const
{
    const Tokens &t = m_theme.tokens();
    const QRectF area = axisRect()->rect();
    painter.setFont(m_theme.ui(12));
    const double wide = QFontMetricsF(painter.font()).horizontalAdvance(text) + 2.0 * tagPadding;
    const double most = width() - wide - 4.0;
    const double left = std::clamp(dot.x() - wide / 2.0, 4.0, std::max(4.0, most));
    const bool isHigh = isFinite(dot) && dot.y() < area.top() + tagHeight + 2.0 * dotRadius;
    const QRectF tag(left, isHigh ? area.bottom() - tagHeight - 3.0 : area.top() + 3.0, wide, tagHeight);
    painter.setPen(QPen(t.line2, 1.0));
    painter.setBrush(t.panel);
    painter.drawRoundedRect(tag, 4.0, 4.0);
    painter.setPen(t.ink);
    painter.drawText(tag, Qt::AlignCenter, text);
    painter.setBrush(Qt::NoBrush);
}

}

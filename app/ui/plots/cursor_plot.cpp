#include "app/ui/plots/cursor_plot.h"

#include "app/ui/plots/cursor_access.h"

#include <QAccessible>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double dotRadius = 4.5; ///< px
constexpr double headWidth = 9.0; ///< px, of the pentagon that the cursor hangs from
constexpr double headHeight = 11.0;
constexpr double tagHeight = 20.0;
constexpr double tagPadding = 7.0;

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

void paintDisc(QPainter &painter, QPointF at, const QColor &fill, const QPen &rim)
{
    painter.setPen(rim);
    painter.setBrush(fill);
    painter.drawEllipse(at, dotRadius, dotRadius);
    painter.setBrush(Qt::NoBrush);
}

bool isArrow(int key)
{
    return key == Qt::Key_Left || key == Qt::Key_Right;
}

}

CursorPlot::CursorPlot(Session &session, const Theme &theme, QWidget *parent)
    : QCustomPlot(parent), m_session(session), m_theme(theme)
{
    installCursorAccess();
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setPlottingHint(QCP::phImmediateRefresh, false); // in the middle of a change others cannot be painted yet
    setPlottingHint(QCP::phFastPolylines); // line by line: as one outline a curve takes tens of times as long
    setCursor(Qt::PointingHandCursor);
    setAntialiasedElements(QCP::aeAll);
    setNoAntialiasingOnDrag(false);
}

void CursorPlot::setHovered(std::optional<std::int64_t> frame)
{
    if (frame == m_hovered)
        return;
    m_hovered = frame;
    update();
}

QString CursorPlot::fullSentence() const
{
    const QString looked = m_hovered ? hoveredText(*m_hovered) : QString();
    return looked.isEmpty() ? sentence() : tr("%1. Looking at %2").arg(sentence(), looked);
}

bool CursorPlot::wantsKey(int key) const
{
    return isArrow(key);
}

void CursorPlot::announce()
{
    if (m_session.isPlaying() || !QAccessible::isActive())
        return;
    QAccessibleValueChangeEvent event(this, sentence());
    QAccessible::updateAccessibility(&event);
}

void CursorPlot::goTo(QPointF where)
{
    const std::optional<std::int64_t> frame = frameAt(where);
    // A hand that trembles within one frame asks for nothing new.
    if (!frame || *frame == m_session.goingTo().value_or(m_session.timeline().cursor().frame))
        return;
    m_session.goTo({*frame, 0});
}

void CursorPlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !frameAt(event->position())) {
        event->ignore();
        return;
    }
    m_isDragging = true;
    emit pointedAt(std::nullopt);
    m_session.pause();
    if (m_session.timeline().cursor().phase > 0)
        m_session.goTo({*frameAt(event->position()), 0});
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
    event->ignore(); // for what the plot stands in
}

void CursorPlot::leaveEvent(QEvent *)
{
    emit pointedAt(std::nullopt);
}

bool CursorPlot::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool isPlain = (key->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == Qt::NoModifier;
        if (isPlain && wantsKey(key->key())) {
            event->accept();
            return true;
        }
    }
    return QCustomPlot::event(event);
}

void CursorPlot::keyPressEvent(QKeyEvent *event)
{
    const bool isPhase = event->modifiers() & Qt::ShiftModifier;
    if (event->key() == Qt::Key_Left)
        isPhase ? m_session.phaseBack() : m_session.frameBack();
    else if (event->key() == Qt::Key_Right)
        isPhase ? m_session.phaseForward() : m_session.frameForward();
    else
        QCustomPlot::keyPressEvent(event);
}

void CursorPlot::focusInEvent(QFocusEvent *event)
{
    m_isRinged = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason ||
                 event->reason() == Qt::ShortcutFocusReason;
    QCustomPlot::focusInEvent(event);
    update();
}

void CursorPlot::focusOutEvent(QFocusEvent *event)
{
    m_isRinged = false;
    QCustomPlot::focusOutEvent(event);
    update();
}

void CursorPlot::paintEvent(QPaintEvent *event)
{
    QCustomPlot::paintEvent(event);
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    paintMarks(painter);
    if (m_hovered)
        paintHovered(painter, *m_hovered);
    if (!m_isRinged)
        return;
    painter.setPen(QPen(m_theme.tokens().ink, 2.0));
    painter.setBrush(Qt::NoBrush);
    painter.drawRoundedRect(QRectF(rect()).adjusted(2.0, 2.0, -2.0, -2.0), 6.0, 6.0);
}

void CursorPlot::paintPicture(QCPPainter &painter)
{
    toPainter(&painter, width(), height());
    painter.setRenderHint(QPainter::Antialiasing);
    paintMarks(painter);
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
    if (isSomewhere(at) && QRectF(axisRect()->rect()).adjusted(-2.0, -2.0, 2.0, 2.0).contains(at))
        paintDisc(painter, at, m_theme.tokens().now, QPen(m_theme.tokens().panel, 1.5));
}

void CursorPlot::paintInside(QPainter &painter, QPointF at) const
{
    const Tokens &t = m_theme.tokens();
    if (isSomewhere(at) && QRectF(axisRect()->rect()).adjusted(-2.0, -2.0, 2.0, 2.0).contains(at))
        paintDisc(painter, at, t.panel, QPen(t.now, 1.5));
}

void CursorPlot::paintHoveredLine(QPainter &painter, double x) const
{
    const QRectF area = axisRect()->rect();
    painter.setPen(QPen(m_theme.tokens().ink3, 1.0));
    painter.drawLine(QPointF(x, area.top()), QPointF(x, area.bottom()));
}

void CursorPlot::paintHoveredDot(QPainter &painter, QPointF at) const
{
    if (isSomewhere(at))
        paintDisc(painter, at, m_theme.tokens().panel, QPen(m_theme.tokens().ink2, 1.5));
}

void CursorPlot::paintTag(QPainter &painter, QPointF dot, const QString &text) const
{
    const Tokens &t = m_theme.tokens();
    const QRectF area = axisRect()->rect();
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

QPen curvePen(const QColor &ink, double width)
{
    return {ink, width, Qt::SolidLine, Qt::SquareCap, Qt::BevelJoin};
}

QColor faint(const QColor &ink, double share, const QColor &ground)
{
    const auto mixed = [share](float over, float under) {
        return static_cast<float>(share) * over + static_cast<float>(1.0 - share) * under;
    };
    return QColor::fromRgbF(mixed(ink.redF(), ground.redF()), mixed(ink.greenF(), ground.greenF()),
                            mixed(ink.blueF(), ground.blueF()));
}

bool isSomewhere(QPointF place)
{
    return std::isfinite(place.x()) && std::isfinite(place.y());
}

}

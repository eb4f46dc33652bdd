// What mouse, wheel and keyboard do on a plot of quantities.

#include "app/ui/plots/quantity_plot.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr double nearEnough = 28.0; ///< px from the curve of a plot without time
constexpr double notch = 120.0;
constexpr int betweenTicks = 36; ///< px, about; across, twice that

bool isZoomIn(int key)
{
    return key == Qt::Key_Plus || key == Qt::Key_Equal;
}

bool isArrow(int key)
{
    return key == Qt::Key_Left || key == Qt::Key_Right;
}

}

std::size_t QuantityPlot::nearestBucket(QPointF where, double &distance) const
{
    const Samples &run = m_course.run();
    std::size_t nearest = 0;
    distance = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < run.size(); ++i) {
        const QPointF off = place(run.at(i, m_across).first, run.at(i, m_up).first) - where;
        const double length = std::hypot(off.x(), off.y());
        if (length < distance) {
            distance = length;
            nearest = i;
        }
    }
    return nearest;
}

std::optional<std::int64_t> QuantityPlot::frameAt(QPointF where) const
{
    const Samples &run = m_course.run();
    if (!m_empty.isEmpty() || run.isEmpty() || m_up >= run.columns() || m_across >= run.columns())
        return std::nullopt;
    if (!m_spec.isAgainstTime()) {
        double distance = 0.0;
        const std::size_t bucket = nearestBucket(where, distance);
        return distance <= nearEnough || (m_isDragging && std::isfinite(distance))
                   ? std::optional(run.frameOf(bucket))
                   : std::nullopt;
    }
    const auto rows = static_cast<double>(m_course.rowFrames() * run.stride());
    const double frame = xAxis->pixelToCoord(where.x());
    const double first = static_cast<double>(run.firstFrame());
    const auto bucket = static_cast<std::int64_t>(std::lround(std::max(0.0, (frame - first) / rows)));
    return run.frameOf(
        static_cast<std::size_t>(std::min<std::int64_t>(bucket, static_cast<std::int64_t>(run.size()) - 1)));
}

void QuantityPlot::setHovered(std::optional<std::int64_t> frame)
{
    if (frame == m_hovered)
        return;
    m_hovered = frame;
    update();
}

void QuantityPlot::goTo(QPointF where)
{
    const std::optional<std::int64_t> frame = frameAt(where);
    // A hand that trembles within one frame asks for nothing new.
    if (!frame || *frame == m_session.goingTo().value_or(m_session.timeline().at().frame))
        return;
    m_session.goTo({*frame, 0});
}

void QuantityPlot::mousePressEvent(QMouseEvent *event)
{
    if (event->button() != Qt::LeftButton || !frameAt(event->position())) {
        event->ignore();
        return;
    }
    m_isDragging = true;
    emit pointedAt(std::nullopt);
    m_session.pause();
    if (m_session.timeline().at().phase > 0)
        m_session.goTo({*frameAt(event->position()), 0});
    else
        goTo(event->position());
}

void QuantityPlot::mouseMoveEvent(QMouseEvent *event)
{
    if (m_isDragging)
        goTo(event->position());
    else
        emit pointedAt(frameAt(event->position()));
}

void QuantityPlot::mouseReleaseEvent(QMouseEvent *event)
{
    if (event->button() == Qt::LeftButton)
        m_isDragging = false;
}

void QuantityPlot::mouseDoubleClickEvent(QMouseEvent *event)
{
    mousePressEvent(event);
}

void QuantityPlot::leaveEvent(QEvent *)
{
    emit pointedAt(std::nullopt);
}

void QuantityPlot::wheelEvent(QWheelEvent *event)
{
    if (!(event->modifiers() & Qt::ControlModifier)) {
        event->ignore(); // the panel scrolls
        return;
    }
    m_wheel += event->angleDelta().y();
    for (; std::abs(m_wheel) >= notch; m_wheel -= std::copysign(notch, m_wheel))
        emit zoomWanted(m_wheel > 0.0 ? 1 : -1);
    event->accept();
}

bool QuantityPlot::event(QEvent *event)
{
    if (event->type() == QEvent::ShortcutOverride) {
        const auto *key = static_cast<QKeyEvent *>(event);
        const bool isPlain = (key->modifiers() & ~(Qt::KeypadModifier | Qt::ShiftModifier)) == Qt::NoModifier;
        if (isPlain && (isArrow(key->key()) || isZoomIn(key->key()) || key->key() == Qt::Key_Minus ||
                        key->key() == Qt::Key_Delete)) {
            event->accept();
            return true;
        }
    }
    return QCustomPlot::event(event);
}

void QuantityPlot::keyPressEvent(QKeyEvent *event)
{
    const bool isPhase = event->modifiers() & Qt::ShiftModifier;
    if (event->key() == Qt::Key_Left)
        isPhase ? m_session.phaseBack() : m_session.frameBack();
    else if (event->key() == Qt::Key_Right)
        isPhase ? m_session.phaseForward() : m_session.frameForward();
    else if (isZoomIn(event->key()))
        emit zoomWanted(1);
    else if (event->key() == Qt::Key_Minus)
        emit zoomWanted(-1);
    else if (event->key() == Qt::Key_Delete)
        emit removalWanted();
    else
        QCustomPlot::keyPressEvent(event);
}

void QuantityPlot::resizeEvent(QResizeEvent *event)
{
    QCustomPlot::resizeEvent(event);
    yAxis->ticker()->setTickCount(std::clamp(axisRect()->height() / betweenTicks, 2, 8));
    xAxis->ticker()->setTickCount(std::clamp(axisRect()->width() / (2 * betweenTicks), 2, 12));
    if (fitAxes())
        replot(QCustomPlot::rpQueuedRefresh);
}

void QuantityPlot::focusInEvent(QFocusEvent *event)
{
    m_isRinged = event->reason() == Qt::TabFocusReason || event->reason() == Qt::BacktabFocusReason ||
                 event->reason() == Qt::ShortcutFocusReason;
    QCustomPlot::focusInEvent(event);
    update();
}

void QuantityPlot::focusOutEvent(QFocusEvent *event)
{
    m_isRinged = false;
    QCustomPlot::focusOutEvent(event);
    update();
}

}

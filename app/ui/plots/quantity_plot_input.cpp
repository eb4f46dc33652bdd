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
        return distance <= nearEnough || (isDragging() && std::isfinite(distance))
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

void QuantityPlot::wheelEvent(QWheelEvent *event)
{
    if (!(event->modifiers() & Qt::ControlModifier)) {
        CursorPlot::wheelEvent(event); // the panel scrolls
        return;
    }
    m_wheel += event->angleDelta().y();
    for (; std::abs(m_wheel) >= notch; m_wheel -= std::copysign(notch, m_wheel))
        emit zoomWanted(m_wheel > 0.0 ? 1 : -1);
    event->accept();
}

bool QuantityPlot::wantsKey(int key) const
{
    return CursorPlot::wantsKey(key) || isZoomIn(key) || key == Qt::Key_Minus || key == Qt::Key_Delete;
}

void QuantityPlot::keyPressEvent(QKeyEvent *event)
{
    if (isZoomIn(event->key()))
        emit zoomWanted(1);
    else if (event->key() == Qt::Key_Minus)
        emit zoomWanted(-1);
    else if (event->key() == Qt::Key_Delete)
        emit removalWanted();
    else
        CursorPlot::keyPressEvent(event);
}

void QuantityPlot::resizeEvent(QResizeEvent *event)
{
    CursorPlot::resizeEvent(event);
    yAxis->ticker()->setTickCount(std::clamp(axisRect()->height() / betweenTicks, 2, 8));
    xAxis->ticker()->setTickCount(std::clamp(axisRect()->width() / (2 * betweenTicks), 2, 12));
    if (fitAxes())
        replot(QCustomPlot::rpQueuedRefresh);
}

}

// The line of the error that the learner wants to stay below.

#include "app/model/accuracy_words.h"
#include "app/ui/measure/plot_marks.h"
#include "app/ui/measure/work_precision_plot.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double grip = 7.0; ///< px round the target line in which it is taken

}

void WorkPrecisionPlot::setTarget(double target)
{
    target = std::clamp(target, leastTarget, mostTarget);
    if (target == m_target)
        return;
    m_target = target;
    refresh();
    emit targetChanged();
}

QRectF WorkPrecisionPlot::targetHandle() const
{
    const QString text = pixels(m_target) + QStringLiteral(" ⇅");
    const double width = QFontMetricsF(m_theme.ui(12)).horizontalAdvance(text) + 14.0;
    const QRectF area = axisRect()->rect();
    return {area.right() - width, yAxis->coordToPixel(m_target) - 24.0, width, 20.0};
}

void WorkPrecisionPlot::drawTarget(QPainter &painter) const
{
    const Tokens &t = m_theme.tokens();
    const QRectF area = axisRect()->rect();
    const double y = yAxis->coordToPixel(m_target);
    painter.setPen(dotted(t.ink2, 1.5));
    painter.drawLine(QPointF(area.left(), y), QPointF(area.right(), y));
    const QRectF handle = targetHandle();
    painter.setPen(QPen(t.line2, 1.0));
    painter.setBrush(t.panel);
    painter.drawRoundedRect(handle, 4.0, 4.0);
    painter.setFont(m_theme.ui(12));
    painter.setPen(t.ink);
    painter.drawText(handle, Qt::AlignCenter, pixels(m_target) + QStringLiteral(" ⇅"));
    painter.setBrush(Qt::NoBrush);
}

bool WorkPrecisionPlot::press(QPointF at)
{
    const QRectF area = axisRect()->rect();
    return targetHandle().contains(at) ||
           (area.contains(at) && std::abs(at.y() - yAxis->coordToPixel(m_target)) < grip);
}

void WorkPrecisionPlot::drag(QPointF at)
{
    setTarget(std::clamp(yAxis->pixelToCoord(at.y()), yAxis->range().lower, yAxis->range().upper));
}

void WorkPrecisionPlot::drop()
{
    // Two digits: what the handle says is what is meant.
    const double power = std::pow(10.0, std::floor(std::log10(m_target)) - 1.0);
    setTarget(std::round(m_target / power) * power);
}

bool WorkPrecisionPlot::wantsKey(const QKeyEvent &event) const
{
    return event.key() == Qt::Key_Plus || event.key() == Qt::Key_Minus || event.key() == Qt::Key_Equal;
}

bool WorkPrecisionPlot::key(const QKeyEvent &event)
{
    if (!wantsKey(event))
        return false;
    // 1, 2, 5, 10, 20...: as a dial clicks.
    const double exponent = std::log10(m_target);
    const int up = event.key() == Qt::Key_Minus ? -1 : 1;
    const double third = std::round(exponent * 3.0) + up;
    const double rough = std::pow(10.0, third / 3.0);
    const double power = std::pow(10.0, std::floor(std::log10(rough) + 1e-9));
    setTarget(std::round(rough / power) * power);
    return true;
}

Qt::CursorShape WorkPrecisionPlot::cursorAt(QPointF at) const
{
    const double y = yAxis->coordToPixel(m_target);
    const bool isLine = axisRect()->rect().contains(at.toPoint()) && std::abs(at.y() - y) < grip;
    return isLine || targetHandle().contains(at) ? Qt::SizeVerCursor : Qt::ArrowCursor;
}

}

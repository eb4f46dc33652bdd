#include "app/ui/measure/plot_marks.h"

#include "app/model/numbers.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int mostTicks = 9;
constexpr double besideLine = 9.0; ///< px between a line's end and its name

}

PowerTicker::PowerTicker(Writing writing) : m_writing(writing)
{
    setLogBase(10.0);
}

QString PowerTicker::getTickLabel(double tick, const QLocale &, QChar, int)
{
    const int exponent = static_cast<int>(std::lround(std::log10(tick)));
    if (m_writing == Writing::plain && std::abs(exponent) <= 3)
        return QString::number(tick, 'g', 6);
    return powerOfTen(exponent);
}

QVector<double> PowerTicker::createTickVector(double, const QCPRange &range)
{
    const int first = static_cast<int>(std::ceil(std::log10(range.lower) - 1e-9));
    const int last = static_cast<int>(std::floor(std::log10(range.upper) + 1e-9));
    int every = 1;
    while ((last - first) / every + 1 > mostTicks)
        ++every;
    QVector<double> ticks;
    for (int exponent = first; exponent <= last; ++exponent) {
        if (exponent % every == 0)
            ticks << std::pow(10.0, exponent);
    }
    return ticks;
}

void makeLogarithmic(QCPAxis &axis, PowerTicker::Writing writing)
{
    axis.setScaleType(QCPAxis::stLogarithmic);
    axis.setTicker(QSharedPointer<PowerTicker>::create(writing));
}

void drawMarker(QPainter &painter, QPointF at, const MethodInk &ink, double size, const QColor &fill)
{
    painter.setPen(QPen(ink.color, 1.6));
    painter.setBrush(fill);
    painter.drawPath(markerPath(ink.shape, size).translated(at));
    painter.setBrush(Qt::NoBrush);
}

void drawRing(QPainter &painter, QPointF at, const QPen &pen, double radius)
{
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, radius, radius);
}

void drawEndLabels(QPainter &painter, std::vector<EndLabel> labels, const QFont &font, const QRectF &area,
                   QColor ground)
{
    const QFontMetricsF metrics(font);
    std::sort(labels.begin(), labels.end(),
              [](const EndLabel &a, const EndLabel &b) { return a.anchor.y() < b.anchor.y(); });
    std::vector<QRectF> boxes;
    for (const EndLabel &label : labels) {
        const double width = metrics.horizontalAdvance(label.text);
        double x = label.anchor.x() + besideLine;
        x = std::max(area.left(), std::min(x, area.right() - width));
        QRectF box(x, label.anchor.y() - metrics.height() / 2.0, width, metrics.height());
        for (const QRectF &other : boxes) {
            if (box.intersects(other))
                box.moveTop(other.bottom());
        }
        boxes.push_back(box);
    }
    // Those that were pushed out below come back up, and push the ones above them.
    double floor = area.bottom();
    for (std::size_t i = boxes.size(); i-- > 0;) {
        if (boxes[i].bottom() <= floor)
            continue;
        boxes[i].moveBottom(floor);
        floor = boxes[i].top();
    }
    painter.setFont(font);
    ground.setAlphaF(0.75F);
    for (std::size_t i = 0; i < boxes.size(); ++i) {
        painter.fillRect(boxes[i].adjusted(-2.0, 1.0, 2.0, -1.0), ground);
        painter.setPen(labels[i].color);
        painter.drawText(boxes[i], Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, labels[i].text);
    }
}

void drawAxisNames(QPainter &painter, const QRectF &area, const QString &across, const QString &up,
                   const Theme &theme)
{
    const QFont font = theme.ui(12);
    const double height = QFontMetricsF(font).height();
    painter.setFont(font);
    painter.setPen(theme.tokens().ink2);
    painter.drawText(QRectF(area.left(), area.bottom() + 22.0, area.width(), height),
                     Qt::AlignRight | Qt::AlignVCenter, across);
    painter.save();
    painter.translate(4.0, area.top());
    painter.rotate(-90.0);
    painter.drawText(QRectF(-area.height(), 0.0, area.height(), height), Qt::AlignRight | Qt::AlignVCenter,
                     up);
    painter.restore();
}

}

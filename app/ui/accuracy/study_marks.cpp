#include "app/ui/accuracy/study_marks.h"

#include "app/model/text/numbers.h"

#include <QLocale>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int mostTicks = 9;
constexpr int leastPlain = -3;        ///< 0.001 is written out; longer numbers are powers of ten
constexpr int mostPlain = 4;          ///< so is 10000
constexpr double besideLine = 9.0;    ///< px between a line's end and its name
constexpr double farFromLine = 14.0;  ///< px: a name that is moved farther is joined to its line
constexpr double shortestPiece = 6.0; ///< px
constexpr double betweenNames = 24.0; ///< px between the names at the ends of one axis

/// Places one label after the other. Returns the sum of their distances from where they should be, in px.
double placeInOrder(const std::vector<EndLabel> &labels, const QFontMetricsF &metrics, const QRectF &area,
                    LabelPlaces &places, std::vector<PlacedLabel> &placed)
{
    double moved = 0.0;
    for (const EndLabel &label : labels) {
        const QSizeF size(metrics.horizontalAdvance(label.text), metrics.height());
        const QPointF wanted = label.anchor + QPointF(besideLine, -size.height() / 2.0);
        const QRectF box = places.within(area, wanted, size);
        const QPointF off = box.topLeft() - wanted;
        const double away = std::hypot(off.x(), off.y());
        QLineF lead;
        if (away > farFromLine) {
            lead = {label.anchor, nearestPoint(box.adjusted(-2.0, 0.0, 2.0, 0.0), label.anchor)};
            places.takeStroke(lead);
        }
        placed.push_back({label, box, lead});
        moved += away;
    }
    return moved;
}

}

QString PowerTicker::getTickLabel(double tick, const QLocale &, QChar, int)
{
    const int exponent = static_cast<int>(std::lround(std::log10(tick)));
    if (exponent >= leastPlain && exponent <= mostPlain)
        return QLocale().toString(tick, 'g', 6);
    return powerOfTen(exponent);
}

QVector<double> PowerTicker::createTickVector(double, const QCPRange &range)
{
    const double lowest = std::max(range.lower, m_lowest);
    const int first = static_cast<int>(std::ceil(std::log10(lowest) - 1e-9));
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

QPointF nearestPoint(const QRectF &box, QPointF to)
{
    return {std::clamp(to.x(), box.left(), box.right()), std::clamp(to.y(), box.top(), box.bottom())};
}

QSharedPointer<PowerTicker> makeLogarithmic(QCPAxis &axis)
{
    const auto ticker = QSharedPointer<PowerTicker>::create();
    axis.setScaleType(QCPAxis::stLogarithmic);
    axis.setTicker(ticker);
    return ticker;
}

QPen dotted(const QColor &color, double width)
{
    QPen pen(color, width, Qt::CustomDashLine, Qt::FlatCap);
    pen.setDashPattern({1.5, 3.0});
    return pen;
}

void drawMarker(QPainter &painter, QPointF at, const MethodColors &ink, double size, const QColor &fill)
{
    painter.setPen(QPen(ink.color, 1.6));
    painter.setBrush(fill);
    painter.drawPath(markerPath(ink.shape, size).translated(at));
    painter.setBrush(Qt::NoBrush);
}

void drawZeroBar(QPainter &painter, QPointF at, const MethodColors &ink, double size)
{
    painter.setPen(QPen(ink.color, 2.0, Qt::SolidLine, Qt::FlatCap));
    const QPointF left = at + QPointF(-0.7 * size, 0.7 * size);
    painter.drawLine(left, left + QPointF(1.4 * size, 0.0));
}

void drawRing(QPainter &painter, QPointF at, const QPen &pen, double radius)
{
    painter.setPen(pen);
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(at, radius, radius);
}

void addStrokes(std::vector<QLineF> &strokes, const QPolygonF &line)
{
    // Pieces that are shorter than a letter need not be avoided one by one.
    QPointF from = line.isEmpty() ? QPointF() : line.front();
    for (qsizetype i = 1; i < line.size(); ++i) {
        const QLineF piece(from, line[i]);
        if (piece.length() < shortestPiece && i + 1 < line.size())
            continue;
        strokes.push_back(piece);
        from = line[i];
    }
}

std::vector<PlacedLabel> placeEndLabels(std::vector<EndLabel> labels, const QFont &font, const QRectF &area,
                                        LabelPlaces &places)
{
    // The first label gets the best place, so the best of three orders is taken.
    using Before = bool (*)(const EndLabel &, const EndLabel &);
    const Before orders[] = {
        [](const EndLabel &a, const EndLabel &b) { return a.anchor.y() > b.anchor.y(); },
        [](const EndLabel &a, const EndLabel &b) { return a.anchor.y() < b.anchor.y(); },
        [](const EndLabel &a, const EndLabel &b) { return a.anchor.x() > b.anchor.x(); },
    };
    std::optional<LabelPlaces> best;
    std::vector<PlacedLabel> placed;
    double least = 0.0;
    for (const Before before : orders) {
        std::stable_sort(labels.begin(), labels.end(), before);
        LabelPlaces trial = places;
        std::vector<PlacedLabel> found;
        const double moved = placeInOrder(labels, QFontMetricsF(font), area, trial, found);
        if (best && moved >= least)
            continue;
        least = moved;
        best = std::move(trial);
        placed = std::move(found);
    }
    places = std::move(*best);
    return placed;
}

void drawEndLabels(QPainter &painter, const std::vector<PlacedLabel> &labels, const QFont &font,
                   QColor ground)
{
    ground.setAlphaF(0.75F);
    painter.setFont(font);
    for (const PlacedLabel &placed : labels) {
        painter.fillRect(placed.box.adjusted(-2.0, 1.0, 2.0, -1.0), ground);
        if (!placed.lead.isNull()) {
            painter.setPen(dotted(placed.label.color, 1.0));
            painter.drawLine(placed.lead);
        }
        painter.setPen(placed.label.color);
        painter.drawText(placed.box, Qt::AlignLeft | Qt::AlignVCenter | Qt::TextDontClip, placed.label.text);
    }
}

void drawAxisNames(QPainter &painter, const QRectF &area, const AxisNames &names, const Theme &theme)
{
    const QFont font = theme.ui(12);
    const QFontMetricsF metrics(font);
    const auto fits = [&](const QString &a, const QString &b, double room) {
        return metrics.horizontalAdvance(a) + metrics.horizontalAdvance(b) + betweenNames <= room;
    };
    painter.setFont(font);
    painter.setPen(theme.tokens().ink2);
    const QRectF below(area.left(), area.bottom() + 22.0, area.width(), metrics.height());
    painter.drawText(below, Qt::AlignRight | Qt::AlignVCenter, names.across);
    if (fits(names.across, names.lessAcross, area.width()))
        painter.drawText(below, Qt::AlignLeft | Qt::AlignVCenter, names.lessAcross);
    painter.save();
    painter.translate(4.0, area.top());
    painter.rotate(-90.0);
    const QRectF beside(-area.height(), 0.0, area.height(), metrics.height());
    painter.drawText(beside, Qt::AlignRight | Qt::AlignVCenter, names.up);
    if (fits(names.up, names.lessUp, area.height()))
        painter.drawText(beside, Qt::AlignLeft | Qt::AlignVCenter, names.lessUp);
    painter.restore();
}

}

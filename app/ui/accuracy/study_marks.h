#pragma once

#include "app/ui/accuracy/method_colors.h"
#include "app/ui/scene/drawing/label_places.h"
#include "app/ui/theme/custom_plot.h"

namespace app {

// Axes, markers and names that the plots of an accuracy study share.

/// Labels of a logarithmic axis: short powers of ten as 0.1, 1, 10, others as 10⁻⁶.
class PowerTicker : public QCPAxisTickerLog
{
public:
    PowerTicker() { setLogBase(10.0); }
    /// Leaves out labels below `lowest`.
    void setLowest(double lowest) { m_lowest = lowest; }

protected:
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;
    QVector<double> createTickVector(double tickStep, const QCPRange &range) override;

private:
    double m_lowest = 0.0;
};

/// Makes `axis` logarithmic and returns its ticker.
QSharedPointer<PowerTicker> makeLogarithmic(QCPAxis &axis);

/// Returns a pen that draws dots.
QPen dotted(const QColor &color, double width);

/// Draws the marker of a method. `fill` is its own colour, or that of the ground for a hollow one.
void drawMarker(QPainter &painter, QPointF at, const MethodColors &ink, double size, const QColor &fill);
/// Draws a bar below a marker, which stands for an error of exactly 0.
void drawZeroBar(QPainter &painter, QPointF at, const MethodColors &ink, double size);
/// Draws a ring round a marker.
void drawRing(QPainter &painter, QPointF at, const QPen &pen, double radius);

/// Adds the pieces of `line`, for LabelPlaces.
void addStrokes(std::vector<QLineF> &strokes, const QPolygonF &line);

/// Returns the point of `box` that is nearest to `to`.
QPointF nearestPoint(const QRectF &box, QPointF to);

/// A name at the end of a line.
struct EndLabel
{
    QPointF anchor; ///< the line's end, px
    QString text;
    QColor color;
};
/// A name at a place that has room for it.
struct PlacedLabel
{
    EndLabel label;
    QRectF box;
    QLineF lead; ///< from the end of its line if the name is far from there; otherwise null
};
/// Finds places for names in `font`, near their anchors and within `area`. As far as there is room, they cover nothing
/// in `places`. The places found are taken in `places`.
std::vector<PlacedLabel> placeEndLabels(std::vector<EndLabel> labels, const QFont &font, const QRectF &area,
                                        LabelPlaces &places);
/// Draws names; `ground` keeps the grid from running through the letters.
void drawEndLabels(QPainter &painter, const std::vector<PlacedLabel> &labels, const QFont &font,
                   QColor ground);

/// The texts at the ends of the axes.
struct AxisNames
{
    QString across;     ///< below the right end of the horizontal one
    QString up;         ///< beside the upper end of the vertical one
    QString lessAcross; ///< the meaning of its left end; left out where there is no room
    QString lessUp;     ///< the meaning of its lower end; left out where there is no room
};
void drawAxisNames(QPainter &painter, const QRectF &area, const AxisNames &names, const Theme &theme);

}

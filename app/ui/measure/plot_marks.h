#pragma once

#include "app/ui/measure/method_ink.h"
#include "app/ui/scene/label_places.h"

#include "app/ui/theme/custom_plot.h"

namespace app {

// What the plots of a study share.

/// Powers of ten: as such, or, where `isPlain`, as 0.1, 1, 10 while those are short.
class PowerTicker : public QCPAxisTickerLog
{
public:
    enum class Writing { powers, plain };
    explicit PowerTicker(Writing writing);
    /// Leaves out what is below `lowest`.
    void setLowest(double lowest) { m_lowest = lowest; }

protected:
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;
    QVector<double> createTickVector(double tickStep, const QCPRange &range) override;

private:
    Writing m_writing;
    double m_lowest = 0.0;
};

/// Makes `axis` logarithmic. Returns what chooses its numbers.
QSharedPointer<PowerTicker> makeLogarithmic(QCPAxis &axis, PowerTicker::Writing writing);

/// A pen that draws dots.
QPen dotted(const QColor &color, double width);

/// A marker on the screen: filled, or hollow on `ground`.
void drawMarker(QPainter &painter, QPointF at, const MethodInk &ink, double size, const QColor &fill);
/// The sign of an error of exactly 0: what has none stands on a bar.
void drawZeroBar(QPainter &painter, QPointF at, const MethodInk &ink, double size);
/// The ring of what is chosen.
void drawRing(QPainter &painter, QPointF at, const QPen &pen, double radius);

/// Adds the pieces of `line`, for LabelPlaces.
void addStrokes(std::vector<QLineF> &strokes, const QPolygonF &line);

/// The point of `box` that is nearest to `to`.
QPointF nearestPoint(const QRectF &box, QPointF to);

/// A name at the end of a line.
struct EndLabel
{
    QPointF anchor; ///< the line's end, px
    QString text;
    QColor color;
};
/// A name where it has room.
struct PlacedLabel
{
    EndLabel label;
    QRectF box;
    QLineF lead; ///< from the end of its line, where it had to go away from there; else null
};
/// Finds places near their anchors within `area` for names in `font`, where they cover nothing of what `places` knows,
/// as far as there is room. They are taken then.
std::vector<PlacedLabel> placeEndLabels(std::vector<EndLabel> labels, const QFont &font, const QRectF &area,
                                        LabelPlaces &places);
/// Writes names; `ground` keeps the grid from running through the letters.
void drawEndLabels(QPainter &painter, const std::vector<PlacedLabel> &labels, const QFont &font,
                   QColor ground);

/// What stands at the ends of the axes.
struct AxisNames
{
    QString across;     ///< below the right end of the horizontal one
    QString up;         ///< beside the upper end of the vertical one
    QString lessAcross; ///< what its left end means; left out where there is no room
    QString lessUp;     ///< what its lower end means; likewise
};
void drawAxisNames(QPainter &painter, const QRectF &area, const AxisNames &names, const Theme &theme);

}

#pragma once

#include "app/ui/measure/method_ink.h"

#include <qcustomplot.h>

namespace app {

// What the plots of a study share.

/// Powers of ten: as such, or, where `isPlain`, as 0.1, 1, 10 while those are short.
class PowerTicker : public QCPAxisTickerLog
{
public:
    enum class Writing { powers, plain };
    explicit PowerTicker(Writing writing);

protected:
    QString getTickLabel(double tick, const QLocale &locale, QChar formatChar, int precision) override;
    QVector<double> createTickVector(double tickStep, const QCPRange &range) override;

private:
    Writing m_writing;
};

/// Makes `axis` logarithmic.
void makeLogarithmic(QCPAxis &axis, PowerTicker::Writing writing);

/// A marker on the screen: filled, or hollow on `ground`.
void drawMarker(QPainter &painter, QPointF at, const MethodInk &ink, double size, const QColor &fill);
/// The ring of what is chosen.
void drawRing(QPainter &painter, QPointF at, const QPen &pen, double radius);

/// A name at the end of a line.
struct EndLabel
{
    QPointF anchor; ///< the line's end, px
    QString text;
    QColor color;
};
/// Writes names right of their anchors, and moves them down or up where they would cover each other.
/// `ground` keeps lines behind them from running through the letters.
void drawEndLabels(QPainter &painter, std::vector<EndLabel> labels, const QFont &font, const QRectF &area,
                   QColor ground);

/// The caption of an axis: below its right end, or beside its upper one.
void drawAxisNames(QPainter &painter, const QRectF &area, const QString &across, const QString &up,
                   const Theme &theme);

}

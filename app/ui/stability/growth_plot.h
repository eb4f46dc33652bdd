#pragma once

#include "app/model/stability_words.h"
#include "app/ui/theme/theme.h"

#include <qcustomplot.h>

namespace app {

/// The map of growth: stiffness across, step or damping up, coloured where disturbances grow; with where the learner
/// is and has been.
class GrowthPlot : public QCustomPlot
{
    Q_OBJECT

public:
    GrowthPlot(const StabilityWatch &watch, const Theme &theme, QWidget *parent = nullptr);

    /// Where the learner is and what holds there, for those who cannot see it.
    QString sentence() const;
    /// What the map says at a place of the widget, in px; empty outside.
    QString wordsAt(QPointF place) const;
    /// Where a spot is drawn, in px of the widget.
    QPointF onScreen(const TriedSpot &spot) const;

    QSize minimumSizeHint() const override { return {280, 200}; }
    QSize sizeHint() const override { return {368, 220}; }

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;

private:
    void dress();
    void refresh();
    void fill(const sim::GrowthMap &map);
    void label(const sim::GrowthMap &map);
    double upOf(const TriedSpot &spot) const;
    bool grows(int column, int row) const;
    QRectF cell(int column, int row) const;
    void drawBorder(QPainter &painter) const;
    void drawWords(QPainter &painter) const;
    QRectF hereBox(const QFontMetricsF &metrics) const;
    void drawTried(QPainter &painter) const;
    void drawScale(QPainter &painter) const;

    const StabilityWatch &m_watch;
    const Theme &m_theme;
    QCPColorMap *m_cells;
    QCPColorGradient m_gradient;
};

}

#pragma once

#include "app/model/text/stability_text.h"
#include "app/ui/plots/spot_plot.h"

namespace app {

/// The map of growth: stiffness across, step or damping up, coloured where disturbances grow, with the place in use and
/// the places before it. Each cell of the map is a spot; using it sets stiffness and step or damping.
class GrowthPlot : public SpotPlot
{
    Q_OBJECT

public:
    GrowthPlot(StabilityMonitor &monitor, const Theme &theme, QWidget *parent = nullptr);

    /// Returns the result at a place of the widget, in px; empty outside the map.
    QString wordsAt(QPointF place) const;
    /// Returns the same together with what a click there does.
    QString tipAt(QPointF place) const;
    using Plot::onScreen;
    /// Returns the place of a tried setting in the widget, in px.
    QPointF onScreen(const TriedSpot &spot) const;

    QSize minimumSizeHint() const override { return {280, 200}; }
    QSize sizeHint() const override { return {368, 220}; }

protected:
    std::optional<Spot> spotAt(QPointF place) const override;
    std::optional<Spot> spotBeyond(QPoint step) const override;
    void use(const Spot &spot) override;
    QString tipOf(const Spot &spot) const override;
    QString overview() const override;
    QRectF markOf(const Spot &spot) const override;
    void applyTheme() override;
    void paintMarks(QPainter &painter) override;
    void paintPointer(QPainter &painter) override;
    bool event(QEvent *event) override;

private:
    void refresh();
    void fill(const sim::GrowthMap &map);
    void label(const sim::GrowthMap &map);
    double upOf(const TriedSpot &spot) const;
    /// Returns the spot of the nearest cell. The row of a spot is the index of its cell in the map.
    Spot spotOf(int column, int row) const;
    /// Returns column and row.
    QPoint cellOf(const Spot &spot) const;
    /// Returns the setting that using a spot makes.
    TriedSpot triedAt(const Spot &spot) const;
    QString wordsOf(const Spot &spot) const;
    bool grows(int column, int row) const;
    QRectF cell(int column, int row) const;
    void drawBorder(QPainter &painter) const;
    void drawWords(QPainter &painter) const;
    QRectF hereBox(const QFontMetricsF &metrics) const;
    void drawTried(QPainter &painter) const;
    void drawScale(QPainter &painter) const;

    StabilityMonitor &m_monitor;
    QCPColorMap *m_cells;
    QCPColorGradient m_gradient;
};

}

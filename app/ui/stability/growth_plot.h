#pragma once

#include "app/model/stability_words.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/theme/custom_plot.h"
#include "app/ui/theme/theme.h"

#include <optional>

namespace app {

/// The map of growth: stiffness across, step or damping up, coloured where disturbances grow; with where the learner
/// is and has been. A click on a place of it, or Enter where the arrow keys went, goes there.
class GrowthPlot : public QCustomPlot
{
    Q_OBJECT

public:
    GrowthPlot(StabilityWatch &watch, const Theme &theme, QWidget *parent = nullptr);

    /// Where the learner is (or where the keys went) and what holds there, for those who cannot see it.
    QString sentence() const;
    /// What the map says at a place of the widget, in px; empty outside.
    QString wordsAt(QPointF place) const;
    /// The same with what a click there does.
    QString tipAt(QPointF place) const;
    /// Goes to where the keys or the pointer are; nothing where they are nowhere.
    void adopt();
    /// Where a spot is drawn, in px of the widget.
    QPointF onScreen(const TriedSpot &spot) const;

    /// The map as it is seen, without focus and pointer.
    PlotPicture picture();

    QSize minimumSizeHint() const override { return {280, 200}; }
    QSize sizeHint() const override { return {368, 220}; }

protected:
    bool event(QEvent *event) override;
    void paintEvent(QPaintEvent *event) override;
    void mouseMoveEvent(QMouseEvent *event) override;
    void mousePressEvent(QMouseEvent *event) override;
    void mouseReleaseEvent(QMouseEvent *) override {}
    void leaveEvent(QEvent *event) override;
    void keyPressEvent(QKeyEvent *event) override;
    void focusInEvent(QFocusEvent *event) override;
    void focusOutEvent(QFocusEvent *event) override;

private:
    void dress();
    void refresh();
    void fill(const sim::GrowthMap &map);
    void label(const sim::GrowthMap &map);
    double upOf(const TriedSpot &spot) const;
    /// The cell at a place of the widget; column and row.
    std::optional<QPoint> cellAt(QPointF place) const;
    TriedSpot spotOf(QPoint at) const;
    QString wordsOf(QPoint at) const;
    QString tipOf(QPoint at) const;
    void choose(std::optional<QPoint> at);
    bool grows(int column, int row) const;
    QRectF cell(int column, int row) const;
    void drawBorder(QPainter &painter) const;
    void drawWords(QPainter &painter) const;
    QRectF hereBox(const QFontMetricsF &metrics) const;
    void drawTried(QPainter &painter) const;
    void drawMarks(QPainter &painter) const;
    void drawChosen(QPainter &painter) const;
    void drawScale(QPainter &painter) const;

    StabilityWatch &m_watch;
    const Theme &m_theme;
    QCPColorMap *m_cells;
    QCPColorGradient m_gradient;
    std::optional<QPoint> m_chosen; ///< the cell under the pointer, or the one that the keys went to
    bool m_ringed = false;          ///< the keyboard is here
};

}

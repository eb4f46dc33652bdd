#pragma once

#include "app/model/analysis/tried_spot.h"
#include "app/ui/plots/spot_plot.h"
#include "app/ui/theme/colors.h"
#include "sim/analysis/stability/growth_map.h"

namespace app {

/// A map over two numbers of a run, with stiffness across: coloured cells, the place in use and the places before it. Each
/// cell is a spot; using it sets both numbers. Derived classes say what the cells show.
class MapPlot : public SpotPlot
{
    Q_OBJECT

public:
    MapPlot(const Theme &theme, QWidget *parent);

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
    /// The axes of a map. Without a map, both are null.
    struct Axes
    {
        const sim::MapAxis *x = nullptr;
        const sim::MapAxis *y = nullptr;

        explicit operator bool() const { return x && y; }
    };

    virtual Axes axes() const = 0;
    /// Returns the settings that the learner has tried, oldest first. The last one is the present setting.
    virtual const std::vector<TriedSpot> &tried() const = 0;
    virtual TriedSpot settable(const TriedSpot &spot) const = 0;
    virtual void adopt(const TriedSpot &spot) = 0;
    /// Returns the colour of a cell as a place in the gradient, from 0 to 1. Cells are numbered by rows.
    virtual double shadeOf(std::size_t cell) const = 0;
    /// Returns the kind of a cell, or -1 if it is not known. A line separates cells of different kinds.
    virtual int kindOf(std::size_t cell) const = 0;
    /// Returns the word to write into a large area of one kind; empty for none.
    virtual QString kindWord(int) const { return {}; }
    /// Returns what is found at a cell; empty if nothing is known.
    virtual QString resultWords(std::size_t cell) const = 0;
    /// Returns what using a setting does.
    virtual QString useWords(const TriedSpot &to) const = 0;
    virtual QString acrossTitle() const = 0;
    virtual QString upTitle() const = 0;
    /// Draws the meaning of the colours above the map.
    virtual void drawKey(QPainter &painter) const = 0;
    /// Draws a sign into a cell of this kind.
    virtual void drawSign(QPainter &, const QRectF &, int /*kind*/) const {}

    /// Shows the map again. Derived classes call it when the map has changed.
    void refresh();
    void setGradient(const QCPColorGradient &gradient);
    QColor shadeColor(double shade) const;
    /// Draws a bar with the colours from `low` to `high`.
    void drawBar(QPainter &painter, const QRectF &bar, double low, double high) const;
    std::size_t cellAt(int column, int row) const;

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
    void fill();
    void label();
    double upOf(const TriedSpot &spot) const;
    int columns() const;
    int rows() const;
    /// Returns the spot of the nearest cell. The row of a spot is the number of its cell.
    Spot spotOf(int column, int row) const;
    /// Returns column and row.
    QPoint cellOf(const Spot &spot) const;
    /// Returns the setting that using a spot makes.
    TriedSpot triedAt(const Spot &spot) const;
    QString wordsOf(const Spot &spot) const;
    QRectF cell(int column, int row) const;
    void drawTitles(QPainter &painter) const;
    void drawSigns(QPainter &painter) const;
    void drawBorder(QPainter &painter) const;
    void drawWords(QPainter &painter) const;
    QRectF hereBox(const QFontMetricsF &metrics) const;
    void drawTried(QPainter &painter) const;

    QCPColorMap *m_cells;
    QCPColorGradient m_gradient;
};

}

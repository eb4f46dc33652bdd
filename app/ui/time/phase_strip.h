#pragma once

#include "app/ui/theme/theme.h"
#include "app/ui/time/run_position.h"

#include <QPainter>
#include <QRectF>

#include <vector>

namespace app {

/// The phases of one step, side by side: those that are done, the last one, and those to come.
class PhaseStrip
{
public:
    void setContent(const sim::ComposedInterval &interval, const Position &position);
    /// Places all phases in `area`. The current phase always shows its name; others that do not fit become marks.
    void arrange(const QRectF &area, const Theme &theme);
    void paint(QPainter &painter, const Theme &theme, bool playing, int hovered) const;

    int count() const { return static_cast<int>(m_cells.size()); }
    /// Returns the phase at a place, or -1.
    int phaseAt(const QPointF &place) const;
    QRectF areaOf(int phase) const { return m_cells[static_cast<std::size_t>(phase)].area; }
    QString titleOf(int phase) const { return m_cells[static_cast<std::size_t>(phase)].title; }
    /// Returns the bodies that a phase works on, if the step proceeds by groups.
    QString groupOf(int phase) const { return m_cells[static_cast<std::size_t>(phase)].group; }
    /// Returns whether all phases show their names.
    bool showsNames() const;
    bool showsName(int phase) const { return m_cells[static_cast<std::size_t>(phase)].isNamed; }

private:
    enum class State { done, now, toCome };
    struct Cell
    {
        QString title;
        QString group;
        sim::EffectKind kind = sim::EffectKind::motion;
        State state = State::toCome;
        bool opensGroup = false;
        bool isNamed = true;
        QRectF area;
    };
    struct Caption
    {
        QString text;
        QString widest; ///< the widest text that it can have, so that places stay
        double x = 0.0;
        double width = 0.0;
        bool rule = false;   ///< a line before it
        bool isShown = true; ///< whether it fits
    };

    /// Returns the width that a phase needs for its name, px.
    static double wantedWidth(const Cell &cell, const Theme &theme);
    std::vector<double> widths(double available, const Theme &theme);
    /// Returns the widths of the cells if not all names fit, and tells the cells whether they show theirs.
    std::vector<double> crowdedWidths(double available, const std::vector<double> &wanted);
    void measureCaptions(const Theme &theme);
    /// Measures the captions, and hides some until the marks and the name of the current phase fit in `width`
    /// px. Returns the width left for the cells.
    double roomBesideCaptions(double width, const Theme &theme);
    QPainterPath outline(std::size_t index) const;
    bool hasChevron(std::size_t index) const;
    void paintCaptions(QPainter &painter, const Theme &theme) const;
    void paintShapes(QPainter &painter, const Theme &theme, int hovered) const;
    void paintCell(QPainter &painter, const Theme &theme, std::size_t index, bool playing) const;

    std::vector<Cell> m_cells;
    std::vector<Caption> m_captions; ///< the step's caption, if any, then one per group
    bool m_hasStep = false;
    QRectF m_area;
};

}

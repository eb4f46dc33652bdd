#pragma once

#include "app/ui/theme/theme.h"
#include "app/ui/time/position.h"

#include <QPainter>
#include <QRectF>

#include <vector>

namespace app {

/// The phases of one step, side by side: which are done, which was the last, which are to come.
class PhaseStrip
{
public:
    void setContent(const sim::ComposedInterval &interval, const Position &position);
    /// Gives every phase its place in `area`. The current phase always has its name; of the others, those that do not
    /// fit are marks.
    void arrange(const QRectF &area, const Theme &theme);
    void paint(QPainter &painter, const Theme &theme, bool playing, int hovered) const;

    int count() const { return static_cast<int>(m_cells.size()); }
    /// The phase at a place, or -1.
    int phaseAt(const QPointF &place) const;
    QRectF areaOf(int phase) const { return m_cells[static_cast<std::size_t>(phase)].area; }
    QString titleOf(int phase) const { return m_cells[static_cast<std::size_t>(phase)].title; }
    /// What a phase works on, if the step goes group by group.
    QString groupOf(int phase) const { return m_cells[static_cast<std::size_t>(phase)].group; }
    /// Whether all phases have their names.
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
        QString widest; ///< what the text could become: places must not jump
        double x = 0.0;
        double width = 0.0;
        bool rule = false;   ///< a line before it
        bool isShown = true; ///< there is room for it
    };

    /// The width that a phase needs for its name.
    static double wantedWidth(const Cell &cell, const Theme &theme);
    std::vector<double> widths(double available, const Theme &theme);
    /// The width of each cell where not all names fit; tells the cells whether they have theirs.
    std::vector<double> crowdedWidths(double available, const std::vector<double> &wanted);
    void measureCaptions(const Theme &theme);
    /// Measures the captions, and leaves them out until the marks and the name of the current phase have room in `width` px. Returns the room
    /// that is left for the cells.
    double roomBesideCaptions(double width, const Theme &theme);
    QPainterPath outline(std::size_t index) const;
    bool hasChevron(std::size_t index) const;
    void paintCaptions(QPainter &painter, const Theme &theme) const;
    void paintShapes(QPainter &painter, const Theme &theme, int hovered) const;
    void paintCell(QPainter &painter, const Theme &theme, std::size_t index, bool playing) const;

    std::vector<Cell> m_cells;
    std::vector<Caption> m_captions; ///< the step's, if it has one, then one a group
    bool m_hasStep = false;
    QRectF m_area;
};

}

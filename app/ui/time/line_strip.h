#pragma once

#include "app/ui/theme/theme.h"

#include <QPainter>
#include <QRectF>
#include <QStringList>

#include <vector>

namespace app {

class ListingFrame;

/// The lines of one frame of a listing, side by side as they run: those that have run, the next one with its text, and
/// those to come.
class LineStrip
{
public:
    /// Sets the lines of `frame`, which may be null, and how many of them have run. `text` is the listing.
    void setContent(const ListingFrame *frame, const QString &text, int index);
    /// Places all lines in `area`.
    void arrange(const QRectF &area, const Theme &theme);
    void paint(QPainter &painter, const Theme &theme, bool playing, int hovered) const;

    int count() const { return static_cast<int>(m_cells.size()); }
    /// Returns the number of lines that run before the one at a place, or -1.
    int indexAt(const QPointF &place) const;
    QRectF areaOf(int index) const { return m_cells[static_cast<std::size_t>(index)].area; }
    /// Returns the number of the line in the listing, from 1.
    int lineOf(int index) const { return m_cells[static_cast<std::size_t>(index)].line; }
    QString textOf(int index) const;

private:
    struct Cell
    {
        int line = 0;
        int depth = 0;
        QRectF area;
    };

    void paintCell(QPainter &painter, const Theme &theme, int index, bool isNow) const;

    std::vector<Cell> m_cells;
    QStringList m_text;
    int m_index = 0;
    QRectF m_area;
};

}

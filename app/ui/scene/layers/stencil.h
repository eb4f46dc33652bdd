#pragma once

#include <QColor>
#include <QImage>
#include <QLineF>
#include <QRectF>

#include <cstdint>
#include <vector>

class QPainter;

namespace app {

/// A coverage mask for many small shapes of one colour, for scenes with thousands of points. It accumulates
/// the coverage of each screen px and paints all shapes at once. Each shape covers its share of the part of a
/// px that is still free.
class Stencil
{
public:
    /// Clears the mask for shapes in `area`, screen px. `scale`: device px per screen px.
    void begin(const QRectF &area, double scale);
    /// Adds a disc. Discs smaller than a px are painted fainter instead.
    void addDisc(QPointF centre, double radius);
    /// Adds a line with flat ends. Lines thinner than a px are painted fainter instead.
    void addLine(const QLineF &line, double width);
    void paint(QPainter &painter, const QColor &color);

private:
    std::uint8_t *rowAt(int y) { return m_cover.data() + static_cast<std::size_t>(y) * m_stride; }
    void touch(int left, int right, int top, int bottom);

    QPointF m_from; ///< the area's corner, screen px
    double m_scale = 1.0;
    int m_width = 0; ///< device px
    int m_height = 0;
    std::size_t m_stride = 0;
    int m_left = 0; ///< the range of columns and rows that are not empty
    int m_right = -1;
    int m_top = 0;
    int m_bottom = -1;
    std::vector<std::uint8_t> m_cover; ///< coverage, 0 to 255, row by row
    QImage m_image;                    ///< kept between paints, because it is large
};

}

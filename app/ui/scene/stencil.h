#pragma once

#include <QColor>
#include <QImage>
#include <QLineF>
#include <QRectF>

#include <cstdint>
#include <vector>

class QPainter;

namespace app {

/// Many small shapes of one colour, for scenes with thousands of points: it keeps how much of each px of the screen
/// they cover, and paints all of them at once. What a shape covers covers its share of what was still free there.
class Stencil
{
public:
    /// Empties it, for shapes in `area`, px of the screen, of which each has `scale` px of the device.
    void begin(const QRectF &area, double scale);
    /// A disc; one that is smaller than a px is as faint as it is small.
    void addDisc(QPointF centre, double radius);
    /// A line with flat ends, as faint as it is thin where it is thinner than a px.
    void addLine(const QLineF &line, double width);
    void paint(QPainter &painter, const QColor &color);

private:
    std::uint8_t *rowAt(int y) { return m_cover.data() + static_cast<std::size_t>(y) * m_stride; }
    void touch(int left, int right, int top, int bottom);

    QPointF m_from; ///< of the area, px of the screen
    double m_scale = 1.0;
    int m_width = 0; ///< px of the device
    int m_height = 0;
    std::size_t m_stride = 0;
    int m_left = 0; ///< the columns and rows that have anything
    int m_right = -1;
    int m_top = 0;
    int m_bottom = -1;
    std::vector<std::uint8_t> m_cover; ///< 0 to 255, row by row
    QImage m_image;                    ///< kept, as it is large
};

}

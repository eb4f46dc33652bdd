#include "app/ui/scene/layers/stencil.h"

#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace app {

namespace {

/// Covers a share of the part of a px that is still free.
void cover(std::uint8_t &there, double share)
{
    const int free = 255 - there;
    there = static_cast<std::uint8_t>(there + static_cast<int>(share * free + 0.5));
}

}

void Stencil::begin(const QRectF &area, double scale)
{
    m_from = {std::floor(area.left()), std::floor(area.top())};
    m_scale = scale;
    m_width = std::max(0, static_cast<int>(std::ceil((area.right() - m_from.x()) * scale)));
    m_height = std::max(0, static_cast<int>(std::ceil((area.bottom() - m_from.y()) * scale)));
    m_stride = static_cast<std::size_t>(m_width);
    m_cover.assign(m_stride * static_cast<std::size_t>(m_height), 0);
    m_left = m_width;
    m_top = m_height;
    m_right = m_bottom = -1;
}

void Stencil::touch(int left, int right, int top, int bottom)
{
    m_left = std::min(m_left, left);
    m_right = std::max(m_right, right);
    m_top = std::min(m_top, top);
    m_bottom = std::max(m_bottom, bottom);
}

void Stencil::addDisc(QPointF centre, double radius)
{
    const double r = radius * m_scale;
    // from here on, positions are those of px centres
    const double x = (centre.x() - m_from.x()) * m_scale - 0.5;
    const double y = (centre.y() - m_from.y()) * m_scale - 0.5;
    const double reach = r + 0.5;
    if (!(x + reach > 0.0 && y + reach > 0.0 && x - reach < m_width - 1 && y - reach < m_height - 1))
        return;
    const int left = std::max(0, static_cast<int>(std::ceil(x - reach)));
    const int right = std::min(m_width - 1, static_cast<int>(std::floor(x + reach)));
    const int top = std::max(0, static_cast<int>(std::ceil(y - reach)));
    const int bottom = std::min(m_height - 1, static_cast<int>(std::floor(y + reach)));
    const double most = std::min(1.0, 2.0 * r);
    const double inside = r > 0.5 ? (r - 0.5) * (r - 0.5) : 0.0;
    touch(left, right, top, bottom);
    for (int row = top; row <= bottom; ++row) {
        std::uint8_t *to = rowAt(row);
        const double down = (row - y) * (row - y);
        for (int column = left; column <= right; ++column) {
            const double square = down + (column - x) * (column - x);
            if (square < inside)
                to[column] = 255;
            else
                cover(to[column], std::clamp(reach - std::sqrt(square), 0.0, most));
        }
    }
}

void Stencil::addLine(const QLineF &line, double width)
{
    double x1 = (line.x1() - m_from.x()) * m_scale - 0.5;
    double y1 = (line.y1() - m_from.y()) * m_scale - 0.5;
    double x2 = (line.x2() - m_from.x()) * m_scale - 0.5;
    double y2 = (line.y2() - m_from.y()) * m_scale - 0.5;
    // Steps px by px along the longer axis, and covers the px near the line across it.
    const bool steep = std::abs(y2 - y1) > std::abs(x2 - x1);
    if (steep) {
        std::swap(x1, y1);
        std::swap(x2, y2);
    }
    if (x1 > x2) {
        std::swap(x1, x2);
        std::swap(y1, y2);
    }
    const int lastAlong = (steep ? m_height : m_width) - 1;
    const int lastAcross = (steep ? m_width : m_height) - 1;
    const double slope = x2 > x1 ? (y2 - y1) / (x2 - x1) : 0.0;
    const double cosine = 1.0 / std::sqrt(1.0 + slope * slope);
    const double reach = width * m_scale / 2.0 + 0.5;
    const double most = std::min(1.0, width * m_scale);
    const double high = reach / cosine;
    if (!(x2 >= 0.0 && x1 <= lastAlong && std::max(y1, y2) + high >= 0.0 &&
          std::min(y1, y2) - high <= lastAcross))
        return;
    const int from = std::max(0, static_cast<int>(std::lround(x1)));
    const int to = std::min(lastAlong, static_cast<int>(std::lround(x2)));
    for (int along = from; along <= to; ++along) {
        const double part = std::min(x2, along + 0.5) - std::max(x1, along - 0.5); // the ends are inside a px
        const double middle = y1 + slope * (along - x1);
        const int first = std::max(0, static_cast<int>(std::ceil(middle - high)));
        const int last = std::min(lastAcross, static_cast<int>(std::floor(middle + high)));
        for (int across = first; across <= last; ++across) {
            const double share = part * std::clamp(reach - std::abs(across - middle) * cosine, 0.0, most);
            cover(steep ? rowAt(along)[across] : rowAt(across)[along], share);
        }
        if (first > last)
            continue;
        if (steep)
            touch(first, last, along, along);
        else
            touch(along, along, first, last);
    }
}

void Stencil::paint(QPainter &painter, const QColor &color)
{
    if (m_bottom < m_top || m_right < m_left)
        return;
    std::array<QRgb, 256> inks;
    for (int i = 0; i < 256; ++i)
        inks[static_cast<std::size_t>(i)] =
            qPremultiply(qRgba(color.red(), color.green(), color.blue(), color.alpha() * i / 255));
    if (m_image.width() != m_width || m_image.height() != m_height)
        m_image = QImage(m_width, m_height, QImage::Format_ARGB32_Premultiplied);
    m_image.setDevicePixelRatio(m_scale);
    for (int row = m_top; row <= m_bottom; ++row) {
        auto *to = reinterpret_cast<QRgb *>(m_image.scanLine(row));
        const std::uint8_t *from = rowAt(row);
        for (int column = m_left; column <= m_right; ++column)
            to[column] = inks[from[column]];
    }
    const QRect used(QPoint(m_left, m_top), QPoint(m_right, m_bottom));
    painter.drawImage(m_from + QPointF(used.topLeft()) / m_scale, m_image, QRectF(used));
}

}

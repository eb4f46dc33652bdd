#pragma once

#include <QImage>
#include <QRgb>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace app {

/// A count of the colours in pictures, in cells of 4 x 4 x 4 colours.
class ColorCount
{
public:
    struct Cell
    {
        std::uint64_t red = 0, green = 0, blue = 0; ///< sums
        std::uint64_t count = 0;
    };

    /// Adds the pixels of a picture in Format_RGB32.
    void add(const QImage &picture);
    const std::unordered_map<std::uint32_t, Cell> &cells() const { return m_cells; }

private:
    std::unordered_map<std::uint32_t, Cell> m_cells;
};

/// Returns a palette of at most `most` colours that represents the counted colours well. The `pinned` colours stay
/// unchanged. The other colours start as the means of boxes, which are cut in two until there are enough (P.
/// Heckbert, "Color image quantization for frame buffer display", 1982). The box with the largest squared error is
/// cut first, at its mean, as X. Wu does. Then each colour moves to the mean of its nearest counted colours (S.
/// Lloyd, "Least squares quantization in PCM", 1982). The weight of a cell is the power 3/4 of its number of
/// pixels. So thin lines keep their colours beside large areas, and soft shadows keep their shades.
std::vector<QRgb> paletteOf(const ColorCount &count, const std::vector<QRgb> &pinned, int most);

/// A search for the nearest colour in a palette that caches its results. Returns palette indices.
class NearestColor
{
public:
    explicit NearestColor(std::vector<QRgb> palette) : m_palette(std::move(palette)) {}
    const std::vector<QRgb> &palette() const { return m_palette; }
    std::uint8_t operator()(QRgb color);

private:
    std::vector<QRgb> m_palette;
    std::unordered_map<QRgb, std::uint8_t> m_found;
};

}

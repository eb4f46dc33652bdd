#pragma once

#include <QImage>
#include <QRgb>

#include <cstdint>
#include <unordered_map>
#include <vector>

namespace app {

/// How often colours come in pictures, in cells of 4 x 4 x 4 of them.
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

/// The `most` colours that stand best for those that were counted: `pinned` as they are, and the means of boxes that
/// are cut in two until there are enough (P. Heckbert, "Color image quantization for frame buffer display", 1982;
/// the box with the largest squared error first, at its mean, as X. Wu does), then moved to the means of what is nearest
/// to each (S. Lloyd, "Least squares quantization in PCM", 1982). A cell counts by the power 3/4 of its pixels, so that
/// thin lines keep their colours beside large areas, and soft shadows their shades.
std::vector<QRgb> paletteOf(const ColorCount &count, const std::vector<QRgb> &pinned, int most);

/// Finds the colour of a palette that is nearest, and remembers what it found.
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

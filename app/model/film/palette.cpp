#include "app/model/film/palette.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

namespace app {

namespace {

constexpr int cellBits = 2; ///< low bits of each channel that a cell ignores
constexpr int rounds = 4;   ///< iterations that move each colour to the mean of its nearest colours

/// A colour with its weight.
struct WeightedColor
{
    std::array<double, 3> at{};
    double weight = 0.0;
};

/// A box of neighbouring colours that one palette colour represents.
struct Box
{
    std::vector<WeightedColor> colors;
    std::array<double, 3> mean{};
    std::array<double, 3> error{}; ///< weighted squared error along each channel

    explicit Box(std::vector<WeightedColor> given) : colors(std::move(given))
    {
        double all = 0.0;
        for (const WeightedColor &color : colors) {
            all += color.weight;
            for (std::size_t i = 0; i < 3; ++i)
                mean[i] += color.weight * color.at[i];
        }
        for (double &value : mean)
            value /= all;
        for (const WeightedColor &color : colors) {
            for (std::size_t i = 0; i < 3; ++i)
                error[i] += color.weight * (color.at[i] - mean[i]) * (color.at[i] - mean[i]);
        }
    }

    std::size_t worstChannel() const
    {
        return static_cast<std::size_t>(std::max_element(error.begin(), error.end()) - error.begin());
    }
    double largestError() const { return error[worstChannel()]; }
    QRgb color() const
    {
        const auto channel = [this](std::size_t i) { return static_cast<int>(std::lround(mean[i])); };
        return qRgb(channel(0), channel(1), channel(2));
    }
};

/// Cuts the box at its mean along the channel with the largest error. Keeps the lower part, and returns the rest.
Box cut(Box &box)
{
    const std::size_t side = box.worstChannel();
    const double middle = box.mean[side];
    const auto from = std::partition(box.colors.begin(), box.colors.end(),
                                     [&](const WeightedColor &color) { return color.at[side] <= middle; });
    Box rest({from, box.colors.end()});
    box = Box({box.colors.begin(), from});
    return rest;
}

int squaredDistance(QRgb a, QRgb b)
{
    const int red = qRed(a) - qRed(b), green = qGreen(a) - qGreen(b), blue = qBlue(a) - qBlue(b);
    return red * red + green * green + blue * blue;
}

/// Moves the palette colours from `first` on to the means of their nearest colours (Lloyd's method).
void refine(std::vector<QRgb> &palette, std::size_t first, const std::vector<WeightedColor> &colors)
{
    const auto rounded = [](double value) { return static_cast<int>(std::lround(value)); };
    for (int round = 0; round < rounds; ++round) {
        NearestColor nearest(palette);
        std::vector<WeightedColor> sums(palette.size());
        for (const WeightedColor &color : colors) {
            WeightedColor &sum =
                sums[nearest(qRgb(rounded(color.at[0]), rounded(color.at[1]), rounded(color.at[2])))];
            sum.weight += color.weight;
            for (std::size_t i = 0; i < 3; ++i)
                sum.at[i] += color.weight * color.at[i];
        }
        for (std::size_t i = first; i < palette.size(); ++i) {
            const WeightedColor &sum = sums[i];
            if (sum.weight > 0.0)
                palette[i] = qRgb(rounded(sum.at[0] / sum.weight), rounded(sum.at[1] / sum.weight),
                                  rounded(sum.at[2] / sum.weight));
        }
    }
}

}

void ColorCount::add(const QImage &picture)
{
    for (int y = 0; y < picture.height(); ++y) {
        const auto *row = reinterpret_cast<const QRgb *>(picture.constScanLine(y));
        for (int x = 0; x < picture.width();) {
            const QRgb color = row[x];
            std::uint64_t run = 0; // most pixels equal the one before
            while (x < picture.width() && row[x] == color)
                ++run, ++x;
            constexpr QRgb kept = 0xff & ~((1u << cellBits) - 1);
            Cell &cell = m_cells[color & (kept << 16 | kept << 8 | kept)];
            cell.red += run * static_cast<std::uint64_t>(qRed(color));
            cell.green += run * static_cast<std::uint64_t>(qGreen(color));
            cell.blue += run * static_cast<std::uint64_t>(qBlue(color));
            cell.count += run;
        }
    }
}

std::vector<QRgb> paletteOf(const ColorCount &count, const std::vector<QRgb> &pinned, int most)
{
    std::vector<QRgb> palette = pinned;
    const std::size_t all = static_cast<std::size_t>(most);
    palette.resize(std::min(palette.size(), all));
    std::vector<WeightedColor> colors;
    for (const auto &[key, cell] : count.cells()) {
        const double n = static_cast<double>(cell.count);
        colors.push_back({{static_cast<double>(cell.red) / n, static_cast<double>(cell.green) / n,
                           static_cast<double>(cell.blue) / n},
                          std::pow(n, 0.75)});
    }
    // Sorting makes the palette independent of the order of cells in the hash table.
    std::sort(colors.begin(), colors.end(),
              [](const WeightedColor &a, const WeightedColor &b) { return a.at < b.at; });
    if (colors.empty() || palette.size() == all)
        return palette;
    const std::size_t first = palette.size();
    std::vector<Box> boxes{Box(colors)};
    while (palette.size() + boxes.size() < all) {
        const auto worst = std::max_element(boxes.begin(), boxes.end(), [](const Box &a, const Box &b) {
            return a.largestError() < b.largestError();
        });
        if (worst->colors.size() < 2 || worst->largestError() < 1e-6)
            break;
        Box rest = cut(*worst);
        boxes.push_back(std::move(rest));
    }
    for (const Box &box : boxes)
        palette.push_back(box.color());
    refine(palette, first, colors);
    return palette;
}

std::uint8_t NearestColor::operator()(QRgb color)
{
    color |= 0xff000000u;
    const auto [found, isNew] = m_found.try_emplace(color, std::uint8_t{0});
    if (!isNew)
        return found->second;
    int nearest = std::numeric_limits<int>::max();
    for (std::size_t i = 0; i < m_palette.size(); ++i) {
        const int distance = squaredDistance(color, m_palette[i]);
        if (distance < nearest) {
            nearest = distance;
            found->second = static_cast<std::uint8_t>(i);
        }
    }
    return found->second;
}

}

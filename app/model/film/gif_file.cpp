#include "app/model/film/gif_file.h"

#include "app/model/film/film_file.h"

#include <gif_lib.h>

#include <algorithm>
#include <memory>

namespace app {

namespace {

constexpr int paletteSize = 256;
constexpr int unchangedIndex = paletteSize - 1; ///< index of an unchanged pixel

int writeTo(GifFileType *gif, const GifByteType *bytes, int count)
{
    const qint64 written =
        static_cast<QSaveFile *>(gif->UserData)->write(reinterpret_cast<const char *>(bytes), count);
    return written < 0 ? 0 : static_cast<int>(written);
}

struct FreeMap
{
    void operator()(ColorMapObject *map) const { GifFreeMapObject(map); }
};

std::unique_ptr<ColorMapObject, FreeMap> mapOf(const std::vector<QRgb> &palette)
{
    std::unique_ptr<ColorMapObject, FreeMap> map(GifMakeMapObject(paletteSize, nullptr));
    const auto byte = [](int value) { return static_cast<GifByteType>(value); };
    for (std::size_t i = 0; map && i < palette.size(); ++i)
        map->Colors[i] = {byte(qRed(palette[i])), byte(qGreen(palette[i])), byte(qBlue(palette[i]))};
    return map;
}

}

GifFile::GifFile(const QString &path, QSize size, std::vector<QRgb> palette)
    : m_file(path), m_size(size), m_nearest(std::move(palette))
{
    check(m_file.open(QIODevice::WriteOnly));
    m_gif.reset(EGifOpen(&m_file, writeTo, nullptr));
    check(m_gif != nullptr);
    EGifSetGifVersion(m_gif.get(), true);
    const auto map = mapOf(m_nearest.palette());
    check(map && EGifPutScreenDesc(m_gif.get(), size.width(), size.height(), 8, 0, map.get()) == GIF_OK);
    // Netscape's extension makes the film loop.
    const GifByteType again[] = {1, 0, 0};
    check(EGifPutExtensionLeader(m_gif.get(), APPLICATION_EXT_FUNC_CODE) == GIF_OK &&
          EGifPutExtensionBlock(m_gif.get(), 11, "NETSCAPE2.0") == GIF_OK &&
          EGifPutExtensionBlock(m_gif.get(), sizeof again, again) == GIF_OK &&
          EGifPutExtensionTrailer(m_gif.get()) == GIF_OK);
}

void GifFile::Close::operator()(GifFileType *gif) const
{
    EGifCloseFile(gif, nullptr);
}

void GifFile::check(bool done)
{
    if (!done)
        throw filmWriteError(m_file.fileName(), m_file.errorString());
}

QRect GifFile::changed(const std::vector<std::uint8_t> &pixels) const
{
    if (m_last.empty())
        return {{}, m_size};
    QRect rect;
    const auto width = static_cast<std::ptrdiff_t>(m_size.width());
    for (int y = 0; y < m_size.height(); ++y) {
        const auto now = pixels.begin() + y * width, before = m_last.begin() + y * width;
        const auto first = std::mismatch(now, now + width, before).first;
        if (first == now + width)
            continue;
        auto last = now + width - 1;
        while (*last == *(before + (last - now)))
            --last;
        rect |= QRect(QPoint(static_cast<int>(first - now), y), QPoint(static_cast<int>(last - now), y));
    }
    // An unchanged picture still needs its time, so it gets one pixel.
    return rect.isEmpty() ? QRect(0, 0, 1, 1) : rect;
}

void GifFile::putImageHeader(const QRect &rect, int hundredths)
{
    GraphicsControlBlock control{};
    control.DisposalMode = DISPOSE_DO_NOT;
    control.DelayTime = hundredths;
    control.TransparentColor = m_last.empty() ? NO_TRANSPARENT_COLOR : unchangedIndex;
    GifByteType bytes[4];
    const auto size = static_cast<int>(EGifGCBToExtension(&control, bytes));
    check(EGifPutExtension(m_gif.get(), GRAPHICS_EXT_FUNC_CODE, size, bytes) == GIF_OK &&
          EGifPutImageDesc(m_gif.get(), rect.x(), rect.y(), rect.width(), rect.height(), false, nullptr) ==
              GIF_OK);
}

void GifFile::add(const QImage &picture, int hundredths)
{
    const auto width = static_cast<std::size_t>(m_size.width());
    std::vector<std::uint8_t> pixels(width * static_cast<std::size_t>(m_size.height()));
    for (int y = 0; y < m_size.height(); ++y) {
        const auto *row = reinterpret_cast<const QRgb *>(picture.constScanLine(y));
        std::uint8_t *into = pixels.data() + static_cast<std::size_t>(y) * width;
        for (std::size_t x = 0; x < width; ++x)
            into[x] = x > 0 && row[x] == row[x - 1] ? into[x - 1] : m_nearest(row[x]);
    }
    const QRect rect = changed(pixels);
    putImageHeader(rect, hundredths);
    std::vector<std::uint8_t> line(static_cast<std::size_t>(rect.width()));
    for (int y = rect.top(); y <= rect.bottom(); ++y) {
        const std::size_t from = static_cast<std::size_t>(y) * width + static_cast<std::size_t>(rect.left());
        for (std::size_t x = 0; x < line.size(); ++x) {
            const bool stays = !m_last.empty() && m_last[from + x] == pixels[from + x];
            line[x] = stays ? std::uint8_t{unchangedIndex} : pixels[from + x];
        }
        check(EGifPutLine(m_gif.get(), line.data(), rect.width()) == GIF_OK);
    }
    m_last = std::move(pixels);
}

void GifFile::finish()
{
    check(EGifCloseFile(m_gif.release(), nullptr) == GIF_OK);
    check(m_file.commit());
}

}

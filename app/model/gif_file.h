#pragma once

#include "app/model/palette.h"

#include <QSaveFile>
#include <QSize>

#include <memory>

struct GifFileType;

namespace app {

/// A film as a GIF file (GIF89a) with one palette, which plays again and again. The file is there when it is whole,
/// and not before.
class GifFile
{
public:
    /// The most colours of a palette: one more number stands for "as before".
    static constexpr int mostColors = 255;

    /// @throws Refusal: the file cannot be written
    GifFile(const QString &path, QSize size, std::vector<QRgb> palette);

    /// Adds a picture of that size in Format_RGB32, which is shown for so many hundredths of a second. Only the
    /// rectangle that differs from the picture before is written. @throws Refusal
    void add(const QImage &picture, int hundredths);
    /// Ends the film. @throws Refusal
    void finish();

private:
    struct Close
    {
        void operator()(GifFileType *gif) const;
    };

    void check(bool done);
    void putHead(const QRect &rect, int hundredths);
    QRect changed(const std::vector<std::uint8_t> &pixels) const;

    QSaveFile m_file;
    QSize m_size;
    NearestColor m_nearest;
    std::unique_ptr<GifFileType, Close> m_gif; ///< writes to the file
    std::vector<std::uint8_t> m_last;          ///< the picture before, as numbers of the palette
};

}

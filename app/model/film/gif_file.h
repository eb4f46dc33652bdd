#pragma once

#include "app/model/film/palette.h"

#include <QSaveFile>
#include <QSize>

#include <memory>

struct GifFileType;

namespace app {

/// A film as a GIF file (GIF89a) with one palette, which loops. The file appears only when it is complete.
class GifFile
{
public:
    /// The largest number of colours in a palette. One more index means "unchanged".
    static constexpr int mostColors = 255;

    /// @throws UserError: the file cannot be written
    GifFile(const QString &path, QSize size, std::vector<QRgb> palette);

    /// Adds a picture of the film's size in Format_RGB32, shown for `hundredths` hundredths of a second. Writes
    /// only the rectangle that differs from the previous picture.
    /// @throws UserError: it cannot be written
    void add(const QImage &picture, int hundredths);
    /// Completes the film.
    /// @throws UserError: it cannot be written
    void finish();

private:
    struct Close
    {
        void operator()(GifFileType *gif) const;
    };

    void check(bool done);
    void putImageHeader(const QRect &rect, int hundredths);
    QRect changed(const std::vector<std::uint8_t> &pixels) const;

    QSaveFile m_file;
    QSize m_size;
    NearestColor m_nearest;
    std::unique_ptr<GifFileType, Close> m_gif; ///< writes to the file
    std::vector<std::uint8_t> m_last;          ///< palette indices of the previous picture
};

}

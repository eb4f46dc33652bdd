#pragma once

#include "app/model/palette.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <memory>

namespace app {

/// What a film is written to, picture by picture. A file is there when it is whole, and not before.
class FilmFile
{
public:
    virtual ~FilmFile() = default;
    /// A picture in Format_RGB32: of this frame of the run, shown up to another time, in seconds from the film's
    /// start. @throws Refusal: it cannot be written
    virtual void add(const QImage &picture, std::int64_t frame, double until) = 0;
    /// @throws Refusal: it cannot be written
    virtual void finish() = 0;
};

/// The kinds of films, by the names of their files.
enum class FilmKind {
    gif,     ///< one GIF file
    video,   ///< one WebM file
    pictures ///< a PNG file for each picture, with its frame in its name
};

/// Which kind of film a name asks for: it ends in .gif or .webm, or in .png and has one %d or %04d for the number of the frame.
/// @throws Refusal: neither
FilmKind filmKind(const QString &name);
/// The file of one picture: `name` with the frame's number.
QString pictureName(const QString &name, std::int64_t frame);

/// The files that a film of the frames `from` to `to` would write over, by name; without their folder.
/// @throws Refusal: `name` is no film's
QStringList filesInTheWay(const QString &name, std::int64_t from, std::int64_t to);

/// The most pictures a second that programs show of a GIF: each lasts whole hundredths of a second, two at least.
constexpr double mostGifRate = 50.0;

/// The most pictures a second of a video: what screens show.
constexpr double mostVideoRate = 120.0;

/// Begins a film. Only a GIF has a palette. @throws Refusal: `name` is no film's, or it cannot be written
std::unique_ptr<FilmFile> beginFilm(const QString &name, QSize size, std::vector<QRgb> palette);

}

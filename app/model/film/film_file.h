#pragma once

#include "app/model/film/palette.h"
#include "app/model/text/user_error.h"

#include <QSize>
#include <QString>
#include <QStringList>

#include <cstdint>
#include <memory>

namespace app {

/// A file to which a film is written, picture by picture. The file appears only when it is complete.
class FilmFile
{
public:
    virtual ~FilmFile() = default;
    /// Adds a picture in Format_RGB32. It shows `frame` of the run, and stays until `until`, in seconds from the
    /// film's start.
    /// @throws UserError: it cannot be written
    virtual void add(const QImage &picture, std::int64_t frame, double until) = 0;
    /// Completes the film.
    /// @throws UserError: it cannot be written
    virtual void finish() = 0;
};

/// Returns the error of a film, or a picture of one, that could not be written.
UserError filmWriteError(const QString &path, const QString &reason);

/// The kinds of films, determined by their file names.
enum class FilmKind {
    gif,     ///< one GIF file
    video,   ///< one WebM file
    pictures ///< a PNG file for each picture, with the frame number in its name
};

/// Returns the kind of film that a file name asks for. The name ends in .gif or .webm, or in .png with one %d or
/// %04d for the frame number.
/// @throws UserError: another name
FilmKind filmKind(const QString &name);
/// Returns the file name of one picture: `name` with the frame's number.
QString pictureName(const QString &name, std::int64_t frame);

/// Returns the names, without folders, of existing files that a film of frames `from` to `to` would overwrite.
/// @throws UserError: `name` is not the name of a film
QStringList filesInTheWay(const QString &name, std::int64_t from, std::int64_t to);

/// The highest picture rate of a GIF in common programs, in 1/s. A picture lasts a whole number of hundredths of a
/// second, at least two.
constexpr double mostGifRate = 50.0;

/// The highest picture rate of a video, in 1/s: the rate of fast screens.
constexpr double mostVideoRate = 120.0;

/// Begins a film. Only a GIF uses `palette`.
/// @throws UserError: `name` is not the name of a film, or the file cannot be written
std::unique_ptr<FilmFile> beginFilm(const QString &name, QSize size, std::vector<QRgb> palette);

}

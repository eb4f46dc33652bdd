#include "app/model/film/film_file.h"

#include "app/model/film/gif_file.h"
#include "app/model/film/webm_file.h"
#include "app/model/text/quoting.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

#include <algorithm>
#include <cmath>

namespace app {

namespace {

struct FilmFileText
{
    Q_DECLARE_TR_FUNCTIONS(FilmFileText)
};

/// Returns where the file name begins, after the folders.
qsizetype fileIn(const QString &name)
{
    return name.lastIndexOf('/') + 1;
}

/// Returns the place of the frame number in a name.
QRegularExpressionMatch numberIn(const QString &name)
{
    static const QRegularExpression place(QStringLiteral("%(?:0([1-9]))?d"));
    return place.match(name, fileIn(name));
}

class Gif : public FilmFile
{
public:
    Gif(const QString &name, QSize size, std::vector<QRgb> palette) : m_file(name, size, std::move(palette))
    {
    }

    void add(const QImage &picture, std::int64_t, double until) override
    {
        // GIF times are whole hundredths of a second. The rounding error of one picture is added to the next.
        const std::int64_t end = std::llround(100.0 * until);
        m_file.add(picture, static_cast<int>(std::clamp<std::int64_t>(end - m_end, 1, 0xffff)));
        m_end = end;
    }
    void finish() override { m_file.finish(); }

private:
    GifFile m_file;
    std::int64_t m_end = 0; ///< hundredths of a second
};

class Video : public FilmFile
{
public:
    Video(const QString &name, QSize size) : m_file(name, size) {}

    void add(const QImage &picture, std::int64_t, double until) override
    {
        m_file.add(picture, std::llround(1000.0 * until));
    }
    void finish() override { m_file.finish(); }

private:
    WebmFile m_file;
};

class Pictures : public FilmFile
{
public:
    explicit Pictures(QString name) : m_name(std::move(name)) {}

    void add(const QImage &picture, std::int64_t frame, double) override
    {
        QSaveFile file(pictureName(m_name, frame));
        if (!file.open(QIODevice::WriteOnly) || !picture.save(&file, "PNG") || !file.commit())
            throw filmWriteError(file.fileName(), file.errorString());
    }
    void finish() override {}

private:
    QString m_name;
};

}

UserError filmWriteError(const QString &path, const QString &reason)
{
    return UserError(
        FilmFileText::tr("Could not write %1: %2. Free some disk space, or choose another folder.")
            .arg(shownPath(path), oneLine(reason)));
}

FilmKind filmKind(const QString &name)
{
    if (name.endsWith(".gif", Qt::CaseInsensitive))
        return FilmKind::gif;
    if (name.endsWith(".webm", Qt::CaseInsensitive))
        return FilmKind::video;
    const QRegularExpressionMatch number = numberIn(name);
    const bool isOne = number.hasMatch() && name.mid(fileIn(name)).count('%') == 1;
    if (name.endsWith(".png", Qt::CaseInsensitive) && isOne)
        return FilmKind::pictures;
    throw UserError(
        FilmFileText::tr(
            "%1 is not a film's name: choose one that ends in .webm or .gif. For a picture of each frame, "
            "choose one that ends in .png and has %04d for the frame's number, such as walk_%04d.png.")
            .arg(quoted(name)));
}

QString pictureName(const QString &name, std::int64_t frame)
{
    const QRegularExpressionMatch number = numberIn(name);
    QString file = name;
    const QString digits = QString::number(frame).rightJustified(number.captured(1).toInt(), '0');
    return file.replace(number.capturedStart(), number.capturedLength(), digits);
}

QStringList filesInTheWay(const QString &name, std::int64_t from, std::int64_t to)
{
    const QFileInfo file(name);
    if (filmKind(name) != FilmKind::pictures)
        return file.isFile() ? QStringList(file.fileName()) : QStringList();
    // Search the folder instead of the frames: there may be millions of frames.
    const QString pattern = file.fileName();
    const QRegularExpressionMatch number = numberIn(pattern);
    const QString before = pattern.left(number.capturedStart());
    const QString after = pattern.mid(number.capturedEnd());
    QStringList found;
    for (const QString &one : file.dir().entryList(QDir::Files, QDir::Name)) {
        if (!one.startsWith(before) || !one.endsWith(after))
            continue;
        const qsizetype digits = one.size() - before.size() - after.size();
        bool isNumber = false;
        const qlonglong frame = digits > 0 ? one.mid(before.size(), digits).toLongLong(&isNumber) : 0;
        if (isNumber && frame >= from && frame <= to && pictureName(pattern, frame) == one)
            found << one;
    }
    return found;
}

std::unique_ptr<FilmFile> beginFilm(const QString &name, QSize size, std::vector<QRgb> palette)
{
    if (filmKind(name) == FilmKind::gif)
        return std::make_unique<Gif>(name, size, std::move(palette));
    if (filmKind(name) == FilmKind::video)
        return std::make_unique<Video>(name, size);
    return std::make_unique<Pictures>(name);
}

}

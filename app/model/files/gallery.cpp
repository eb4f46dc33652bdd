#include "app/model/files/gallery.h"

#include "app/model/experiment/json_fields.h"
#include "app/model/text/json_writer.h"
#include "app/model/text/quoting.h"

#include <QBuffer>
#include <QDir>
#include <QSaveFile>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <utility>

namespace app {

namespace {

const QString galleryFormat = QStringLiteral("springstep-gallery/1");
const QString galleryEnding = QStringLiteral(".json");

QByteArray textOfKept(const KeptExperiment &kept)
{
    JsonWriter json(1);
    json.beginObject();
    json.field(QStringLiteral("format"), galleryFormat);
    json.field(QStringLiteral("title"), kept.title);
    json.field(QStringLiteral("kept"), kept.when.toString(Qt::ISODateWithMs));
    json.field(QStringLiteral("picture"), QString::fromLatin1(pngOf(kept.picture).toBase64()));
    json.field(QStringLiteral("experiment"), QString::fromUtf8(kept.experiment));
    json.endObject();
    return json.text() + '\n';
}

/// Reads a file of the gallery. Its experiment is read when it is opened.
/// @throws UserError: it is not a file of the gallery
KeptExperiment keptIn(const QString &path, const QByteArray &content)
{
    const QString name = QFileInfo(path).fileName();
    const JsonValue root = parseJson(content, name);
    const JsonFields fields(name, root, Gallery::tr("the file"));
    const auto textField = [&](const QString &id) { return fields.text(id, Gallery::tr("a text")); };
    if (fields.text(QStringLiteral("format"), quoted(galleryFormat)) != galleryFormat)
        fields.refuse(QStringLiteral("format"), Gallery::tr("this is not an experiment of the gallery."));
    KeptExperiment kept;
    kept.file = path;
    kept.title = textField(QStringLiteral("title")).left(Gallery::longestTitle);
    kept.when = QDateTime::fromString(textField(QStringLiteral("kept")), Qt::ISODateWithMs);
    kept.picture.loadFromData(QByteArray::fromBase64(textField(QStringLiteral("picture")).toLatin1()), "PNG");
    kept.experiment = textField(QStringLiteral("experiment")).toUtf8();
    return kept;
}

QByteArray contentOf(const QString &path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) ? file.read(2 * largestExperiment) : QByteArray();
}

}

QByteArray pngOf(const QImage &picture)
{
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    picture.save(&buffer, "PNG");
    return png;
}

QString galleryFolder()
{
    return QStandardPaths::writableLocation(QStandardPaths::AppDataLocation) + QStringLiteral("/gallery");
}

Gallery::Gallery(QString folder, QObject *parent) : QObject(parent), m_folder(std::move(folder))
{
    refresh();
}

void Gallery::refresh()
{
    m_all.clear();
    m_mistakes.clear();
    for (const QFileInfo &one :
         QDir(m_folder).entryInfoList({'*' + galleryEnding}, QDir::Files, QDir::Name)) {
        try {
            m_all.push_back(keptIn(one.filePath(), contentOf(one.filePath())));
        } catch (const UserError &error) {
            m_mistakes << tr("%1 The file was left alone.").arg(error.sentence());
        }
    }
    std::stable_sort(m_all.begin(), m_all.end(),
                     [](const auto &a, const auto &b) { return a.when > b.when; });
    emit changed();
}

void Gallery::write(const QString &path, const QByteArray &content) const
{
    QDir().mkpath(m_folder);
    QSaveFile file(path);
    if (!file.open(QIODevice::WriteOnly) || file.write(content) != content.size() || !file.commit())
        throw UserError(tr("%1: the file could not be written: %2. Check the folder %3.")
                            .arg(shownPath(QFileInfo(path).fileName()), oneLine(file.errorString()),
                                 shownPath(m_folder)));
}

QString Gallery::freeTitle(const QString &wanted) const
{
    const QString base = wanted.simplified().left(longestTitle);
    QString title = base;
    for (int number = 2;
         std::any_of(m_all.begin(), m_all.end(), [&](const auto &one) { return one.title == title; });
         ++number)
        title = QStringLiteral("%1 %2").arg(base).arg(number);
    return title;
}

QString Gallery::keep(const Experiment &experiment, const LessonLibrary &library, const QString &title,
                      const QImage &picture)
{
    KeptExperiment kept;
    kept.file = QDir(m_folder).filePath(QUuid::createUuid().toString(QUuid::WithoutBraces) + galleryEnding);
    kept.title = freeTitle(title);
    kept.when = QDateTime::currentDateTime();
    kept.picture = picture.scaled(pictureSize, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    kept.experiment = experimentText(experiment, library);
    write(kept.file, textOfKept(kept));
    m_changes.push_back({tr("keep %1").arg(quoted(kept.title)), kept.file, {}});
    refresh();
    return kept.title;
}

void Gallery::rename(const QString &file, const QString &title)
{
    const QByteArray before = contentOf(file);
    KeptExperiment kept = keptIn(file, before);
    const QString wanted = title.simplified().left(longestTitle);
    if (wanted.isEmpty() || wanted == kept.title) {
        emit changed(); // a list that shows the refused title shows the old one again
        return;
    }
    m_changes.push_back({tr("rename %1").arg(quoted(kept.title)), file, before});
    kept.title = wanted;
    write(file, textOfKept(kept));
    refresh();
}

void Gallery::remove(const QString &file)
{
    const auto found =
        std::find_if(m_all.begin(), m_all.end(), [&](const KeptExperiment &one) { return one.file == file; });
    if (found == m_all.end())
        return;
    const Change change{tr("remove %1").arg(quoted(found->title)), file, contentOf(file)};
    QFile one(file);
    if (!one.remove())
        throw UserError(
            tr("%1: the file could not be removed: %2. Check the folder %3.")
                .arg(shownPath(QFileInfo(file).fileName()), oneLine(one.errorString()), shownPath(m_folder)));
    m_changes.push_back(change);
    refresh();
}

QString Gallery::undoText() const
{
    return m_changes.empty() ? QString() : tr("Undo: %1").arg(m_changes.back().what);
}

void Gallery::undo()
{
    if (m_changes.empty())
        return;
    const Change last = m_changes.back();
    if (last.before.isEmpty())
        QFile::remove(last.file);
    else
        write(last.file, last.before);
    m_changes.pop_back();
    refresh();
}

Experiment Gallery::experimentOf(const KeptExperiment &kept, const LessonLibrary &library)
{
    return parseExperiment(kept.experiment, kept.title, library);
}

}

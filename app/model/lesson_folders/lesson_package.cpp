#include "app/model/lesson_folders/lesson_package.h"

#include "app/model/files/whole_file.h"
#include "app/model/lesson_folders/zip_reader.h"
#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"

#include <QCoreApplication>
#include <QDir>
#include <QFileInfo>
#include <QRegularExpression>

namespace app {

namespace {

struct LessonPackageText
{
    Q_DECLARE_TR_FUNCTIONS(LessonPackageText)
};

/// Returns whether a file of a folder belongs to its lesson: a document, a scene or a listing.
bool isLessonFile(const QString &name)
{
    static const QRegularExpression pattern(
        QStringLiteral("\\A[A-Za-z0-9_]+(\\.[a-z]{2})?\\.md\\z|\\A[A-Za-z0-9_]+\\.(json|code)\\z"));
    return pattern.match(name).hasMatch();
}

std::map<QString, QByteArray> filesOf(const QString &folder)
{
    std::map<QString, QByteArray> files;
    qsizetype all = 0;
    for (const QFileInfo &info : QDir(folder).entryInfoList(QDir::Files | QDir::System, QDir::Name)) {
        if (!isLessonFile(info.fileName()))
            continue;
        if (info.isSymLink() || !info.isFile())
            throw UserError(LessonPackageText::tr("%1 is a link or a device. Put the file itself there.")
                                .arg(shownPath(info.filePath())));
        const QByteArray content = readWholeFile(info.filePath(), largestLessonFile);
        files.emplace(info.fileName(), content);
        all += content.size();
        if (files.size() > mostLessonFiles || all > largestLesson)
            throw UserError(
                LessonPackageText::tr("%1: a lesson has at most %2 files, with %3 MiB in all of them.")
                    .arg(shownPath(folder))
                    .arg(mostLessonFiles)
                    .arg(largestLesson >> 20));
    }
    return files;
}

}

QByteArray LessonFiles::content(const QString &file) const
{
    const auto found = all.find(file);
    return found == all.end() ? QByteArray() : found->second;
}

QString LessonFiles::shown(const QString &file) const
{
    return shownPath(name + '/' + file);
}

bool isLessonPath(const QString &path)
{
    const QFileInfo info(path);
    return info.isDir() ? QFileInfo::exists(QDir(path).filePath(QStringLiteral("lesson.json")))
                        : path.endsWith(lessonEnding) || info.fileName() == u"lesson.json";
}

LessonFiles readLessonFiles(const QString &path)
{
    const QFileInfo info(path);
    if (!info.exists())
        throw UserError(LessonPackageText::tr("%1: there is no such folder or file; check its name.")
                            .arg(shownPath(path)));
    if (info.fileName() == u"lesson.json" && info.isFile())
        return readLessonFiles(info.absolutePath());
    LessonFiles files{info.isDir() ? QDir(info.absoluteFilePath()).dirName() : info.fileName(),
                      info.canonicalFilePath()};
    if (info.isDir())
        files.all = filesOf(path);
    else
        files.all = readZip(readWholeFile(path, largestLesson), files.name,
                            {mostLessonFiles, largestLessonFile, largestLesson});
    if (!files.has(QStringLiteral("lesson.json")))
        throw UserError(
            LessonPackageText::tr("%1: there is no lesson.json, which describes the lesson. Choose "
                                  "the folder that has it, or write it.")
                .arg(shownPath(path)));
    return files;
}

}

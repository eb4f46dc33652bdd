#include "app/model/catalog/lesson_library.h"

#include "app/model/catalog/lesson_plugin.h"
#include "app/model/catalog/lists.h"
#include "app/model/lesson_folders/lesson_folder.h"
#include "app/model/text/user_error.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibrary>
#include <QSet>

#include <algorithm>
#include <tuple>

namespace app {

namespace {

struct LessonLibraryText
{
    Q_DECLARE_TR_FUNCTIONS(LessonLibraryText)
};

/// Returns the shared libraries in a folder, sorted by name.
QStringList librariesIn(const QString &folder)
{
    QStringList files;
    for (const QFileInfo &info : QDir(folder).entryInfoList(QDir::Files, QDir::Name)) {
        if (QLibrary::isLibrary(info.fileName()))
            files.push_back(info.absoluteFilePath());
    }
    return files;
}

/// Returns the lessons without C++ in a folder, sorted by name.
QStringList lessonFoldersIn(const QString &folder)
{
    QStringList paths;
    for (const QFileInfo &info :
         QDir(folder).entryInfoList(QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot, QDir::Name)) {
        if (isLessonPath(info.absoluteFilePath()))
            paths.push_back(info.absoluteFilePath());
    }
    return paths;
}

bool isSandboxLesson(const LessonEntry &entry)
{
    return entry.steps.front().points == lessons::PointSource::scene;
}

}

const lessons::Step *LessonEntry::step(const QString &wanted) const
{
    return findById(steps, wanted);
}

const LessonEntry *LessonLibrary::lesson(const QString &wanted) const
{
    for (std::size_t i = 0; i < entries(); ++i) {
        if (entry(i).id == wanted)
            return &entry(i);
    }
    return nullptr;
}

LessonLibrary LessonLibrary::load(const QStringList &folders, Language *language)
{
    LessonLibrary library;
    QSet<QString> seen;
    for (const QString &folder : folders) {
        for (const QString &file : librariesIn(folder)) {
            const QString real = QFileInfo(file).canonicalFilePath();
            if (seen.contains(real))
                continue;
            seen.insert(real);
            try {
                LessonEntry entry = loadLesson(file, language);
                if (!library.lesson(entry.id))
                    (isSandboxLesson(entry) ? library.sandboxes : library.lessons)
                        .push_back(std::move(entry));
            } catch (const UserError &error) {
                library.problems.push_back({file, error.sentence()});
            }
        }
    }
    for (std::vector<LessonEntry> *all : {&library.lessons, &library.sandboxes}) {
        std::sort(all->begin(), all->end(), [](const LessonEntry &a, const LessonEntry &b) {
            return std::tie(a.order, a.id) < std::tie(b.order, b.id);
        });
    }
    for (const QString &folder : folders) {
        for (const QString &path : lessonFoldersIn(folder)) {
            try {
                LessonEntry entry = readLesson(path, library);
                if (!library.lesson(entry.id))
                    library.yours.push_back(std::move(entry));
            } catch (const UserError &error) {
                library.problems.push_back({path, error.sentence()});
            }
        }
    }
    return library;
}

QStringList LessonLibrary::folders()
{
    QStringList folders =
        qEnvironmentVariable("SPRINGSTEP_LESSONS").split(QDir::listSeparator(), Qt::SkipEmptyParts);
    const QDir program(QCoreApplication::applicationDirPath());
    folders.push_back(program.filePath("lessons"));
    folders.push_back(QDir::cleanPath(program.filePath("../" SPRINGSTEP_LIBDIR "/springstep/lessons")));
    return folders;
}

}

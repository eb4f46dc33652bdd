#include "app/model/catalog/lesson_documents.h"

#include "app/model/learning/concept_map.h"
#include "app/model/learning/recall_desk.h"

#include <QDir>

namespace app {

namespace {

constexpr int settleMilliseconds = 50;

}

LessonDocuments::LessonDocuments(LessonLibrary &library, const QString &folder, QObject *parent)
    : QObject(parent), m_library(library), m_folder(folder)
{
    if (m_folder.isEmpty())
        return;
    m_due.setSingleShot(true);
    m_due.setInterval(settleMilliseconds);
    connect(&m_due, &QTimer::timeout, this, &LessonDocuments::refresh);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, [this] { m_due.start(); });
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, [this] { m_due.start(); });
    refresh();
}

QString LessonDocuments::folder()
{
    return qEnvironmentVariable("SPRINGSTEP_LESSONS_TEXT");
}

void LessonDocuments::refresh()
{
    const QString before = mistake();
    bool isChanged = false;
    for (std::vector<LessonEntry> *all : {&m_library.lessons, &m_library.sandboxes}) {
        for (LessonEntry &lesson : *all)
            isChanged = read(lesson) || isChanged;
    }
    if (isChanged)
        checkAll();
    watch();
    if (isChanged)
        emit changed();
    if (mistake() != before)
        emit mistakeChanged(mistake());
}

bool LessonDocuments::read(LessonEntry &lesson)
{
    bool isChanged = false;
    for (lessons::Step &step : lesson.steps)
        isChanged = read(step.lesson, step.id,
                         [&step](const QByteArray &content, const QString &path) {
                             step.setTexts(lessons::parseDocument(content, path));
                         }) ||
                    isChanged;
    const auto takeRecall = [&](const QByteArray &content, const QString &path) {
        lessons::Recall recall = lessons::parseRecall(content, path);
        checkRecall(recall, m_library);
        lesson.recall = std::move(recall);
    };
    const QString folder = lesson.steps.front().lesson;
    isChanged = read(folder, QStringLiteral("recall"), takeRecall) || isChanged;
    const auto takeProject = [&](const QByteArray &content, const QString &path) {
        lesson.project = lessons::parseProject(content, path);
    };
    return read(folder, QStringLiteral("project"), takeProject) || isChanged;
}

bool LessonDocuments::read(const QString &lesson, const QString &document, const Take &take)
{
    if (lesson.isEmpty())
        return false;
    const QString key = lesson + '/' + document;
    for (const QString &name : lessons::documentNames(document)) {
        const QString path = QDir(m_folder).filePath(lesson + '/' + name);
        QFile file(path);
        if (!file.open(QIODevice::ReadOnly))
            continue;
        const QByteArray content = file.readAll();
        const QByteArray known = path.toUtf8() + '\n' + content;
        if (m_known.value(key) == known)
            return false;
        m_known[key] = known;
        m_mistakes.remove(key);
        try {
            take(content, path);
            return true;
        } catch (const lessons::DocumentError &error) {
            m_mistakes[key] = QString::fromStdString(error.what());
            return false;
        }
    }
    m_mistakes.remove(key);
    return false;
}

void LessonDocuments::checkAll()
{
    const QString key = QStringLiteral("concepts");
    m_mistakes.remove(key);
    try {
        checkConcepts(m_library);
    } catch (const lessons::DocumentError &error) {
        m_mistakes[key] = QString::fromStdString(error.what());
    }
}

void LessonDocuments::watch()
{
    // Many editors write another file and rename it, which ends the watch of the old one. So the folders are watched, too.
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    QStringList wanted = {m_folder};
    for (const QFileInfo &lesson : QDir(m_folder).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        wanted << lesson.filePath();
        for (const QFileInfo &file : QDir(lesson.filePath()).entryInfoList({"*.md"}, QDir::Files))
            wanted << file.filePath();
    }
    for (const QString &path : wanted) {
        if (!watched.contains(path))
            m_watcher.addPath(path);
    }
}

}

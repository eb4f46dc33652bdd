#include "app/model/lesson_folders/your_lessons.h"

#include "app/model/lesson_folders/lesson_parameters.h"
#include "app/model/text/quoting.h"
#include "app/model/text/user_error.h"
#include "lessons/api/text/document.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr int quietMilliseconds = 50;
const char *const yoursKey = "lessons/yours";

bool haveSameSteps(const LessonEntry &a, const LessonEntry &b)
{
    return a.id == b.id && std::equal(a.steps.begin(), a.steps.end(), b.steps.begin(), b.steps.end(),
                                      [](const auto &one, const auto &other) { return one.id == other.id; });
}

/// Returns the numbers of the parameters that a step declares. The files were read before without a mistake.
QString parametersIn(const LessonFiles &files, const QString &step)
{
    const QString document = step + QStringLiteral(".md");
    return files.has(document)
               ? parameterKey(lessons::parseDocument(files.content(document), files.shown(document)))
               : QString();
}

/// Returns the steps whose scenes, listings or parameters differ between the files before and now.
QStringList otherRuns(const LessonEntry &lesson, const LessonFiles &before, const LessonFiles &now)
{
    QStringList ids;
    for (const lessons::Step &step : lesson.steps) {
        const QString scene = step.id + QStringLiteral(".json"), listing = step.id + QStringLiteral(".code");
        if (before.content(scene) != now.content(scene) || before.content(listing) != now.content(listing) ||
            parametersIn(before, step.id) != parametersIn(now, step.id))
            ids << step.id;
    }
    return ids;
}

void takeTextsOfParameters(lessons::Step &step, const lessons::Step &from)
{
    for (lessons::Parameter &parameter : step.parameters) {
        const lessons::Parameter *other = from.parameter(parameter.id);
        if (!other)
            continue;
        parameter.name = other->name;
        parameter.help = other->help;
        parameter.unit = other->unit;
    }
}

/// Moves everything but the runs of the steps.
void takeTexts(LessonEntry &lesson, LessonEntry &from)
{
    lesson.title = from.title;
    lesson.summary = from.summary;
    lesson.recall = std::move(from.recall);
    lesson.project = std::move(from.project);
    lesson.projectStart = from.projectStart;
    for (std::size_t i = 0; i < lesson.steps.size(); ++i) {
        lessons::Step &step = lesson.steps[i];
        lessons::Step &other = from.steps[i];
        takeTextsOfParameters(step, other);
        step.title = other.title;
        step.narration = other.narration;
        step.explanation = std::move(other.explanation);
        step.tries = std::move(other.tries);
        step.checks = std::move(other.checks);
        step.codeTasks = std::move(other.codeTasks);
        step.predictions = std::move(other.predictions);
    }
}

}

YourLessons::YourLessons(LessonLibrary &library, QObject *parent) : QObject(parent), m_library(library)
{
    for (const LessonEntry &lesson : library.yours)
        m_paths << lesson.source;
    QStringList remembered = QSettings().value(yoursKey).toStringList();
    for (const QString &path : std::as_const(remembered)) {
        if (!QFileInfo::exists(path))
            m_gone << path;
        else if (!m_paths.contains(path))
            m_paths << path;
    }
    if (!m_gone.isEmpty()) {
        remembered.removeIf([this](const QString &path) { return m_gone.contains(path); });
        QSettings().setValue(yoursKey, remembered);
    }
    for (const QString &path : std::as_const(m_paths))
        readAtStart(path);
    m_due.setSingleShot(true);
    m_due.setInterval(quietMilliseconds);
    connect(&m_due, &QTimer::timeout, this, &YourLessons::refresh);
    connect(&m_watcher, &QFileSystemWatcher::fileChanged, this, [this] { m_due.start(); });
    connect(&m_watcher, &QFileSystemWatcher::directoryChanged, this, [this] { m_due.start(); });
    watch();
}

QString YourLessons::farewell() const
{
    QStringList names;
    for (const QString &path : m_gone)
        names << shownPath(path);
    return names.isEmpty() ? QString()
                           : tr("Could not find %1, so it is no longer among your lessons. If you moved it, "
                                "open it from its new place.")
                                 .arg(names.join(QStringLiteral(", ")));
}

LessonEntry *YourLessons::find(const QString &source)
{
    const auto found = std::find_if(m_library.yours.begin(), m_library.yours.end(),
                                    [&source](const LessonEntry &lesson) { return lesson.source == source; });
    return found == m_library.yours.end() ? nullptr : &*found;
}

void YourLessons::readAtStart(const QString &path)
{
    try {
        const LessonFiles files = readLessonFiles(path);
        LessonEntry now = lessonOf(files, lessons::documentLanguage(), m_library);
        LessonEntry *lesson = find(files.path);
        if (lesson && !haveSameSteps(*lesson, now))
            return; // a step of it may be open
        if (lesson)
            takeTexts(*lesson, now);
        else
            m_library.yours.push_back(std::move(now));
        m_known[files.path] = files;
    } catch (const UserError &error) {
        m_mistakes[path] = error.sentence();
    }
}

const LessonEntry &YourLessons::open(const QString &path)
{
    const LessonFiles files = readLessonFiles(path);
    const LessonEntry &lesson = take(lessonOf(files, lessons::documentLanguage(), m_library), files);
    if (!m_paths.contains(files.path))
        m_paths << files.path;
    QStringList remembered = QSettings().value(yoursKey).toStringList();
    if (!remembered.contains(files.path))
        QSettings().setValue(yoursKey, remembered << files.path);
    watch();
    if (m_mistakes.remove(files.path) > 0)
        emit mistakeChanged(mistake());
    return lesson;
}

void YourLessons::remove(const QString &source)
{
    m_paths.removeAll(source);
    m_known.remove(source);
    QStringList remembered = QSettings().value(yoursKey).toStringList();
    if (remembered.removeAll(source) > 0)
        QSettings().setValue(yoursKey, remembered);
    std::erase_if(m_library.yours, [&source](const LessonEntry &lesson) { return lesson.source == source; });
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    for (const QString &path : watched) {
        if (path == source || path.startsWith(source + '/'))
            m_watcher.removePath(path);
    }
    emit changed();
    if (m_mistakes.remove(source) > 0)
        emit mistakeChanged(mistake());
}

void YourLessons::refresh()
{
    const QString before = mistake();
    for (const QString &path : std::as_const(m_paths)) {
        try {
            readAgain(path);
            m_mistakes.remove(path);
        } catch (const UserError &error) {
            m_mistakes[path] = error.sentence();
        }
    }
    watch();
    if (mistake() != before)
        emit mistakeChanged(mistake());
}

void YourLessons::readAgain(const QString &path)
{
    const LessonFiles files = readLessonFiles(path);
    const auto known = m_known.constFind(path);
    if (known == m_known.constEnd() || known->all != files.all)
        take(lessonOf(files, lessons::documentLanguage(), m_library), files);
}

const LessonEntry &YourLessons::take(LessonEntry now, const LessonFiles &files)
{
    const LessonFiles before = std::exchange(m_known[files.path], files);
    LessonEntry *lesson = find(files.path);
    if (!lesson) {
        m_library.yours.push_back(std::move(now));
        emit changed();
        return m_library.yours.back();
    }
    const QStringList others = otherRuns(now, before, files);
    if (others.isEmpty() && haveSameSteps(*lesson, now)) {
        takeTexts(*lesson, now);
    } else {
        emit aboutToReplace(*lesson);
        *lesson = std::move(now);
        emit replaced(*lesson, others);
    }
    emit changed();
    return *lesson;
}

void YourLessons::watch()
{
    // Many editors write another file and rename it, which ends the watch of the old one. So the folders are watched, too.
    const QStringList watched = m_watcher.files() + m_watcher.directories();
    QStringList wanted = m_paths;
    for (const QString &path : std::as_const(m_paths)) {
        for (const QFileInfo &file : QDir(path).entryInfoList({"*.md", "*.json", "*.code"}, QDir::Files))
            wanted << file.filePath();
    }
    for (const QString &path : std::as_const(wanted)) {
        if (!watched.contains(path) && QFileInfo::exists(path))
            m_watcher.addPath(path);
    }
}

}

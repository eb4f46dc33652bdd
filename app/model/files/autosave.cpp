#include "app/model/files/autosave.h"

#include "app/model/run/same_run.h"
#include "app/model/text/quoting.h"

#include <QDir>
#include <QSaveFile>
#include <QUuid>

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr auto lockName = "lock";
constexpr auto closedName = "left"; ///< this file exists if the program exited normally
constexpr auto ending = ".json";
constexpr int mostAttempts = 3;

/// Returns why the file could not be written, or an empty text on success. Sets the file's modification time to
/// `when`, if valid.
QString writeWhole(const QString &path, const QByteArray &text, const QDateTime &when = {})
{
    QSaveFile file(path);
    const bool isWritten =
        file.open(QIODevice::WriteOnly) && file.write(text) == text.size() && file.commit();
    QFile written(path);
    if (isWritten && when.isValid() && written.open(QIODevice::ReadWrite))
        written.setFileTime(when, QFileDevice::FileModificationTime);
    return isWritten ? QString() : file.errorString();
}

QStringList scenesIn(const QString &folder)
{
    return QDir(folder).entryList({QStringLiteral("*") + ending}, QDir::Files);
}

/// Deletes a folder whose lock this program holds.
void clear(const QString &folder, QLockFile &lock)
{
    for (const QString &file : QDir(folder).entryList(QDir::Files | QDir::Hidden)) {
        if (file != QLatin1String(lockName))
            QFile::remove(folder + '/' + file);
    }
    lock.unlock();
    QDir().rmdir(folder); // fails if another program has put files into it
}

/// Returns whether the folder's program is no longer running. If so, this program now holds the lock.
bool isLeft(QLockFile &lock)
{
    lock.setStaleLockTime(0); // a lock of any age is valid while its program runs
    return lock.tryLock(0);
}

}

Autosave::Autosave(const OpenRun &run, const ComparisonRuns &comparisons, const Document &document,
                   QString folder, int within, QObject *parent)
    : QObject(parent), m_run(run), m_comparisons(comparisons), m_document(document),
      m_folder(std::move(folder))
{
    m_timer.setSingleShot(true);
    m_timer.setInterval(within);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
    run.onChange(ChangeKind::step | ChangeKind::run | ChangeKind::code, this, &Autosave::note);
    connect(&document, &Document::stateChanged, this, &Autosave::note);
}

Autosave::~Autosave()
{
    for (const auto &[name, experiment] : m_written) // some may have been saved or discarded since
        m_due.insert(name);
    saveNow();
    if (m_own.isEmpty())
        return;
    if (scenesIn(m_own).isEmpty())
        clear(m_own, *m_lock);
    else
        writeWhole(m_own + '/' + closedName, {});
}

void Autosave::saveNow()
{
    m_timer.stop();
    write();
    m_writer.wait();
}

void Autosave::takeOver(const StepName &name, const QDateTime &when)
{
    m_changed[name] = when;
    m_due.insert(name);
    saveNow();
}

void Autosave::note()
{
    const StepName name = m_document.name();
    const auto written = m_written.find(name);
    const bool isThere = written != m_written.end();
    const bool isSame = isThere && sameScript(written->second.script, m_run.timeline().script()) &&
                        sameMarked(written->second.branches, m_comparisons.branches()) &&
                        written->second.draft == m_run.draft();
    if (m_document.isChanged() ? isSame : !isThere)
        return;
    m_changed[name] = QDateTime::currentDateTime();
    m_due.insert(name);
    if (!m_timer.isActive())
        m_timer.start();
}

void Autosave::write()
{
    for (const StepName &name : std::exchange(m_due, {}))
        writeOne(name);
}

void Autosave::writeOne(const StepName &name)
{
    const std::optional<Experiment> experiment = m_document.experimentOf(name);
    if (!experiment || !m_document.isChanged(name)) {
        m_written.erase(name);
        if (!m_own.isEmpty())
            addToQueue([file = fileOf(name)] {
                QFile::remove(file);
                return QString();
            });
        return;
    }
    QByteArray text;
    try {
        text = experimentText(*experiment, m_run.library());
    } catch (const UserError &) {
        return; // the version kept before is better than none
    }
    if (!takeFolder())
        return;
    m_written.insert_or_assign(name, *experiment);
    addToQueue([file = fileOf(name), text, when = m_changed[name]] { return writeWhole(file, text, when); });
}

void Autosave::addToQueue(std::function<QString()> work)
{
    m_writer.add([work = std::move(work)](const BackgroundJob::Context &) { return work(); },
                 [this](std::future<QString> result) {
                     const QString why = result.get();
                     if (!why.isEmpty())
                         fail(why);
                 });
}

bool Autosave::takeFolder()
{
    for (int i = 0; m_own.isEmpty() && i < mostAttempts; ++i) {
        const QString own = m_folder + '/' + QUuid::createUuid().toString(QUuid::WithoutBraces);
        if (!QDir().mkpath(own)) {
            fail(tr("the folder %1 could not be created").arg(own));
            return false;
        }
        auto lock = std::make_unique<QLockFile>(own + '/' + lockName);
        if (!isLeft(*lock))
            continue; // another program has just deleted it
        m_own = own;
        m_lock = std::move(lock);
    }
    if (m_own.isEmpty())
        fail(tr("a file in %1 could not be locked").arg(m_folder));
    return !m_own.isEmpty();
}

QString Autosave::fileOf(const StepName &name) const
{
    return m_own + '/' + name.lesson + '.' + name.step + ending;
}

void Autosave::fail(const QString &why)
{
    if (std::exchange(m_hasFailed, true))
        return;
    emit failed(tr("Could not save a backup of your work: %1. Free some disk space, or save it as a file.")
                    .arg(oneLine(why)));
}

std::vector<RecoveredScene> recoveredScenes(const QString &folder)
{
    std::vector<RecoveredScene> scenes;
    for (const QFileInfo &own : QDir(folder).entryInfoList(QDir::Dirs | QDir::NoDotAndDotDot)) {
        const QString path = own.absoluteFilePath();
        QLockFile lock(path + '/' + lockName);
        if (!isLeft(lock))
            continue;
        const QStringList files = scenesIn(path);
        if (files.isEmpty()) {
            clear(path, lock);
            continue;
        }
        const bool wasEnded = !QFileInfo::exists(path + '/' + closedName);
        for (const QString &file : files) {
            const QFileInfo info(path + '/' + file);
            const QString name = info.completeBaseName();
            scenes.push_back({info.absoluteFilePath(),
                              {name.section('.', 0, 0), name.section('.', 1)},
                              info.lastModified(),
                              wasEnded});
        }
    }
    std::stable_sort(scenes.begin(), scenes.end(),
                     [](const RecoveredScene &a, const RecoveredScene &b) { return a.when > b.when; });
    return scenes;
}

void forget(const RecoveredScene &scene)
{
    QFile::remove(scene.file);
    const QString folder = QFileInfo(scene.file).absolutePath();
    QLockFile lock(folder + '/' + lockName);
    if (scenesIn(folder).isEmpty() && isLeft(lock))
        clear(folder, lock);
}

}

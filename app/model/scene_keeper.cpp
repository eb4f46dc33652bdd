#include "app/model/scene_keeper.h"

#include "app/model/same_run.h"
#include "app/model/words.h"

#include <QDir>
#include <QSaveFile>
#include <QUuid>

#include <algorithm>
#include <utility>

namespace app {

namespace {

constexpr auto lockName = "lock";
constexpr auto leftName = "left"; ///< is there when the program ended in good order
constexpr auto ending = ".json";
constexpr int mostAttempts = 3;

/// Why it was not written; empty: it was. The file bears the time `when`, if that is valid.
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

/// Deletes a folder whose lock is ours.
void clear(const QString &folder, QLockFile &lock)
{
    for (const QString &file : QDir(folder).entryList(QDir::Files | QDir::Hidden)) {
        if (file != QLatin1String(lockName))
            QFile::remove(folder + '/' + file);
    }
    lock.unlock();
    QDir().rmdir(folder); // stays if another program has begun to look at it
}

/// Whether the program whose folder this is runs no longer: then the lock is ours.
bool isLeft(QLockFile &lock)
{
    lock.setStaleLockTime(0); // however old: while its program runs, it holds
    return lock.tryLock(0);
}

}

SceneKeeper::SceneKeeper(Session &session, const Document &document, QString folder, int within,
                         QObject *parent)
    : QObject(parent), m_session(session), m_document(document), m_folder(std::move(folder))
{
    m_writer.setMaxThreadCount(1);
    m_timer.setSingleShot(true);
    m_timer.setInterval(within);
    connect(&m_timer, &QTimer::timeout, this, &SceneKeeper::write);
    connect(&session, &Session::runChanged, this, &SceneKeeper::note);
    connect(&session, &Session::stepOpened, this, &SceneKeeper::note);
    connect(&document, &Document::stateChanged, this, &SceneKeeper::note);
}

SceneKeeper::~SceneKeeper()
{
    for (const auto &[name, experiment] : m_written) // one may have been saved since, or given up
        m_due.insert(name);
    keepNow();
    if (m_own.isEmpty())
        return;
    if (scenesIn(m_own).isEmpty())
        clear(m_own, *m_lock);
    else
        writeWhole(m_own + '/' + leftName, {});
}

void SceneKeeper::keepNow()
{
    m_timer.stop();
    write();
    m_writer.waitForDone();
}

void SceneKeeper::takeOver(const StepName &name, const QDateTime &when)
{
    m_changed[name] = when;
    m_due.insert(name);
    keepNow();
}

void SceneKeeper::note()
{
    const StepName name = m_document.name();
    const auto written = m_written.find(name);
    const bool isThere = written != m_written.end();
    const bool isSame = isThere && sameScript(written->second.script, m_session.timeline().script()) &&
                        sameMarked(written->second.branches, m_session.branches());
    if (m_document.isChanged() ? isSame : !isThere)
        return;
    m_changed[name] = QDateTime::currentDateTime();
    m_due.insert(name);
    if (!m_timer.isActive())
        m_timer.start();
}

void SceneKeeper::write()
{
    for (const StepName &name : std::exchange(m_due, {}))
        writeOne(name);
}

void SceneKeeper::writeOne(const StepName &name)
{
    const std::optional<Experiment> experiment = m_document.experimentOf(name);
    if (!experiment || !m_document.isChanged(name)) {
        m_written.erase(name);
        if (!m_own.isEmpty())
            m_writer.start([file = fileOf(name)] { QFile::remove(file); });
        return;
    }
    QByteArray text;
    try {
        text = experimentText(*experiment, m_session.library());
    } catch (const Refusal &) {
        return; // what was kept before is more than nothing
    }
    if (!takeFolder())
        return;
    m_written.insert_or_assign(name, *experiment);
    m_writer.start([this, file = fileOf(name), text, when = m_changed[name]] {
        const QString why = writeWhole(file, text, when);
        if (!why.isEmpty())
            QMetaObject::invokeMethod(this, [this, why] { fail(why); }); // in the thread that owns it
    });
}

bool SceneKeeper::takeFolder()
{
    for (int i = 0; m_own.isEmpty() && i < mostAttempts; ++i) {
        const QString own = m_folder + '/' + QUuid::createUuid().toString(QUuid::WithoutBraces);
        if (!QDir().mkpath(own)) {
            fail(tr("the folder %1 cannot be made").arg(own));
            return false;
        }
        auto lock = std::make_unique<QLockFile>(own + '/' + lockName);
        if (!isLeft(*lock))
            continue; // another program has just tidied it away
        m_own = own;
        m_lock = std::move(lock);
    }
    if (m_own.isEmpty())
        fail(tr("no file can be locked in %1").arg(m_folder));
    return !m_own.isEmpty();
}

QString SceneKeeper::fileOf(const StepName &name) const
{
    return m_own + '/' + name.lesson + '.' + name.step + ending;
}

void SceneKeeper::fail(const QString &why)
{
    if (std::exchange(m_hasFailed, true))
        return;
    emit failed(tr("What you do is not kept against a crash: %1. Make room there, or save as a file.")
                    .arg(oneLine(why)));
}

std::vector<KeptScene> keptScenes(const QString &folder)
{
    std::vector<KeptScene> scenes;
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
        const bool wasEnded = !QFileInfo::exists(path + '/' + leftName);
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
                     [](const KeptScene &a, const KeptScene &b) { return a.when > b.when; });
    return scenes;
}

void forget(const KeptScene &scene)
{
    QFile::remove(scene.file);
    const QString folder = QFileInfo(scene.file).absolutePath();
    QLockFile lock(folder + '/' + lockName);
    if (scenesIn(folder).isEmpty() && isLeft(lock))
        clear(folder, lock);
}

}

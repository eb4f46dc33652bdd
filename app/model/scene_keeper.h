#pragma once

#include "app/model/document.h"

#include <QDateTime>
#include <QLockFile>
#include <QThreadPool>
#include <QTimer>

#include <map>
#include <memory>
#include <set>

namespace app {

/// Keeps every run that has changed and is not saved in a folder, so that a crash takes at most what was done in the
/// last keepWithin ms. Each program has a folder of its own in there, with a lock that only a program that runs holds.
class SceneKeeper : public QObject
{
    Q_OBJECT

public:
    /// Leaves half a second of two for the writing.
    static constexpr int keepWithin = 1500;

    /// A change is written `within` ms. Nothing runs while nothing changes. Session and document must outlive it;
    /// `folder` need not exist.
    SceneKeeper(Session &session, const Document &document, QString folder, int within = keepWithin,
                QObject *parent = nullptr);
    /// Keeps what is not saved for the next start, as left in good order.
    ~SceneKeeper() override;

    /// Writes what waits, and returns when it is written.
    void keepNow();
    /// Keeps the run of step `name`, which was just opened, with the time `when` at which it was last changed.
    void takeOver(const StepName &name, const QDateTime &when);

signals:
    /// Nothing can be kept; the sentence says why. Once.
    void failed(const QString &sentence);

private:
    void note();
    void write();
    void writeOne(const StepName &name);
    bool takeFolder();
    QString fileOf(const StepName &name) const;
    void fail(const QString &why);

    Session &m_session;
    const Document &m_document;
    QString m_folder; ///< of all programs
    QString m_own;    ///< empty while there was nothing to keep
    std::unique_ptr<QLockFile> m_lock;
    QTimer m_timer;
    std::set<StepName> m_due;
    std::map<StepName, Experiment> m_written;
    std::map<StepName, QDateTime> m_changed; ///< when each was last changed: writing it again is no change
    bool m_hasFailed = false;
    QThreadPool m_writer; ///< one thread: in order, and no picture waits for the disk
};

/// A run that a program which runs no longer has kept.
struct KeptScene
{
    QString file;
    StepName name;
    QDateTime when;        ///< when it was last changed
    bool wasEnded = false; ///< by something else than its window, such as a crash
};

/// The latest first. Empties the folders of programs that have left nothing.
std::vector<KeptScene> keptScenes(const QString &folder);
/// Deletes it.
void forget(const KeptScene &scene);

}

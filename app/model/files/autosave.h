#pragma once

#include "app/model/files/document.h"
#include "app/model/jobs/background_job.h"

#include <QDateTime>
#include <QLockFile>
#include <QTimer>

#include <map>
#include <memory>
#include <set>

namespace app {

/// Writes every changed and unsaved run to a folder, so that a crash loses at most the last saveWithin ms of work.
/// Each program has its own subfolder. A running program holds the lock in its subfolder.
class Autosave : public QObject
{
    Q_OBJECT

public:
    /// In ms. Leaves half a second of two seconds for writing.
    static constexpr int saveWithin = 1500;

    /// Writes each change within `within` ms. No timer runs while nothing changes. `folder` need not exist. The
    /// other arguments must outlive this object.
    Autosave(const OpenRun &run, const ComparisonRuns &comparisons, const Document &document, QString folder,
             int within = saveWithin, QObject *parent = nullptr);
    /// Keeps unsaved runs for the next start, and marks them as left by a normal exit.
    ~Autosave() override;

    /// Writes all pending changes, and returns when they are written.
    void saveNow();
    /// Keeps the run of step `name`, which was just opened. `when` is the time of its last change.
    void takeOver(const StepName &name, const QDateTime &when);

signals:
    /// Emitted once, when nothing can be kept; `sentence` says why.
    void failed(const QString &sentence);

private:
    void note();
    void write();
    void writeOne(const StepName &name);
    /// Adds work that changes a file and returns why it failed, or an empty text.
    void addToQueue(std::function<QString()> work);
    bool takeFolder();
    QString fileOf(const StepName &name) const;
    void fail(const QString &why);

    const OpenRun &m_run;
    const ComparisonRuns &m_comparisons;
    const Document &m_document;
    QString m_folder; ///< shared by all programs
    QString m_own;    ///< empty until there is something to keep
    std::unique_ptr<QLockFile> m_lock;
    QTimer m_timer;
    std::set<StepName> m_due;
    std::map<StepName, Experiment> m_written;
    std::map<StepName, QDateTime> m_changed; ///< time of the last change; writing a run again is not a change
    bool m_hasFailed = false;
    BackgroundJob m_writer; ///< changes files in order, so that painting never waits for the disk
};

/// A run kept by a program that is no longer running.
struct RecoveredScene
{
    QString file;
    StepName name;
    QDateTime when;        ///< time of the last change
    bool wasEnded = false; ///< the program did not exit normally, for example after a crash
};

/// Returns the kept runs, latest first. Deletes the folders of ended programs that kept nothing.
std::vector<RecoveredScene> recoveredScenes(const QString &folder);
/// Deletes the file of a kept run.
void forget(const RecoveredScene &scene);

}

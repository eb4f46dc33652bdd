#pragma once

#include "app/model/lesson_folders/lesson_folder.h"

#include <QFileSystemWatcher>
#include <QMap>
#include <QObject>
#include <QStringList>
#include <QTimer>

namespace app {

/// The lessons without C++ of a learner or a teacher. It adds them to a library, remembers them for the next start, and reads
/// them again when one of their files changes. While a file has a mistake, the lesson stays as it was.
class YourLessons : public QObject
{
    Q_OBJECT

public:
    /// Adds the lessons that were open in earlier starts, and reads the texts of LessonLibrary::yours again, since the
    /// language may be another one. `library` must outlive this object.
    explicit YourLessons(LessonLibrary &library, QObject *parent = nullptr);

    /// Reads a lesson, adds it to the library or brings it up to date there, and remembers it.
    /// @throws UserError: as readLesson(); nothing has changed
    const LessonEntry &open(const QString &path);
    /// Takes a lesson out of the library and forgets it. Its files stay. No step of it may be open.
    void remove(const QString &source);
    /// Returns the first mistake in a file of a lesson: file, line and remedy. Empty if there is none.
    QString mistake() const { return m_mistakes.isEmpty() ? QString() : m_mistakes.first(); }
    /// Returns a sentence about lessons of earlier starts that are gone and were forgotten. Empty if there are none.
    QString farewell() const;

signals:
    /// Lessons were added, or have other texts.
    void changed();
    /// The steps of a lesson are about to become others: none of them should be open.
    void aboutToReplace(const app::LessonEntry &lesson);
    /// They have. The runs of the steps `others` begin in another way than before.
    void replaced(const app::LessonEntry &lesson, const QStringList &others);
    /// There is another mistake(), or none any more.
    void mistakeChanged(const QString &sentence);

private:
    void readAtStart(const QString &path);
    void refresh();
    /// Reads a lesson again if a file has changed.
    void readAgain(const QString &path);
    const LessonEntry &take(LessonEntry now, const LessonFiles &files);
    LessonEntry *find(const QString &source);
    void watch();

    LessonLibrary &m_library;
    QStringList m_paths;                ///< of all lessons, as in LessonEntry::source
    QStringList m_gone;                 ///< lessons of earlier starts that no longer exist
    QMap<QString, LessonFiles> m_known; ///< by path: the files that the lesson has come from
    QMap<QString, QString> m_mistakes;  ///< by path
    QFileSystemWatcher m_watcher;
    QTimer m_due; ///< an editor changes a file in several steps
};

}

#pragma once

#include "app/model/catalog/lesson_library.h"

#include <QFileSystemWatcher>
#include <QHash>
#include <QMap>
#include <QTimer>

namespace app {

/// Gives the steps of a library the documents of a folder in place of the embedded ones, and follows changes of its files.
/// The folder has the form of `lessons/`: LESSON/STEP.md and LESSON/STEP.de.md. A step without a file there keeps its
/// texts, and so does one whose file has a mistake.
class LessonDocuments : public QObject
{
    Q_OBJECT

public:
    /// Reads the documents in `folder`. An empty `folder` changes nothing. `library` must outlive this object.
    LessonDocuments(LessonLibrary &library, const QString &folder, QObject *parent = nullptr);

    /// Returns the folder that SPRINGSTEP_LESSONS_TEXT names. Empty if the variable is not set.
    static QString folder();
    /// Returns the mistake of the first file that has one: file, line and remedy. Empty if there is none.
    QString mistake() const { return m_mistakes.isEmpty() ? QString() : m_mistakes.first(); }

signals:
    /// Texts of steps changed.
    void changed();
    /// There is another mistake(), or none any more.
    void mistakeChanged(const QString &sentence);

private:
    void refresh();
    /// Reads the document of a step if its file has changed. Returns whether the step has other texts now.
    bool read(lessons::Step &step);
    void watch();

    LessonLibrary &m_library;
    QString m_folder;
    QFileSystemWatcher m_watcher;
    QTimer m_due;                       ///< an editor changes a file in several steps
    QHash<QString, QByteArray> m_known; ///< path and content of the file by "lesson/step"
    QMap<QString, QString> m_mistakes;  ///< by "lesson/step"
};

}

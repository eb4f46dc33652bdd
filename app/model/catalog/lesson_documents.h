#pragma once

#include "app/model/catalog/lesson_library.h"

#include <QFileSystemWatcher>
#include <QHash>
#include <QMap>
#include <QTimer>

#include <functional>

namespace app {

/// Gives the steps of a library the documents of a folder in place of the embedded ones, and follows changes of its files.
/// The folder has the form of `lessons/`: LESSON/STEP.md and LESSON/STEP.de.md, and LESSON/recall.md. A step without a file
/// there keeps its texts, and so does one whose file has a mistake.
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
    /// Takes the content of a file. May throw a DocumentError.
    using Take = std::function<void(const QByteArray &content, const QString &path)>;

    void refresh();
    /// Reads the documents of a lesson whose files have changed. Returns whether it has other texts now.
    bool read(LessonEntry &lesson);
    /// Reads a document of the folder `lesson` if its file has changed. Returns whether it was taken.
    bool read(const QString &lesson, const QString &document, const Take &take);
    /// Checks the concepts of all documents, which refer to each other.
    void checkAll();
    void watch();

    LessonLibrary &m_library;
    QString m_folder;
    QFileSystemWatcher m_watcher;
    QTimer m_due;                       ///< an editor changes a file in several steps
    QHash<QString, QByteArray> m_known; ///< path and content of the file by "lesson/document"
    QMap<QString, QString> m_mistakes;  ///< by "lesson/document"
};

}

#pragma once

#include "app/model/experiment/experiment.h"

#include <QDateTime>
#include <QImage>
#include <QObject>
#include <QStringList>

#include <vector>

namespace app {

/// An experiment that the learner keeps in the gallery.
struct KeptExperiment
{
    QString file; ///< its path
    QString title;
    QDateTime when;             ///< when it was kept
    QImage picture;             ///< null if it is damaged
    QByteArray experiment = {}; ///< the text of an experiment file
};

/// Returns a picture as the content of a PNG file.
QByteArray pngOf(const QImage &picture);
/// Returns the folder of the learner's gallery.
QString galleryFolder();

/// A folder of experiments that the learner keeps, one file each, with a title, a date and a picture. Files that cannot be
/// read are left alone.
class Gallery : public QObject
{
    Q_OBJECT

public:
    static constexpr qsizetype longestTitle = 60;
    static constexpr QSize pictureSize{264, 192};

    /// `folder` need not exist; the first experiment makes it.
    explicit Gallery(QString folder, QObject *parent = nullptr);

    /// Reads the folder again.
    void refresh();
    /// Returns the experiments in the gallery, the newest first.
    const std::vector<KeptExperiment> &all() const { return m_all; }
    /// Returns one sentence for each file that cannot be read.
    const QStringList &mistakes() const { return m_mistakes; }

    /// Keeps an experiment, and returns its title: `title`, with a number behind it if another one has it.
    /// @throws UserError: the file could not be written
    QString keep(const Experiment &experiment, const LessonLibrary &library, const QString &title,
                 const QImage &picture);
    /// Gives a file another title. An empty title changes nothing.
    /// @throws UserError: the file could not be written
    void rename(const QString &file, const QString &title);
    /// Removes a file.
    /// @throws UserError: it could not be removed
    void remove(const QString &file);
    /// Returns what undo() would take back, for a button: "Undo: remove “Walker”". Empty if there is nothing.
    QString undoText() const;
    /// Takes back the last change: keep(), rename() or remove().
    /// @throws UserError: the file could not be written
    void undo();

    /// Reads a kept experiment.
    /// @throws UserError: as parseExperiment()
    static Experiment experimentOf(const KeptExperiment &kept, const LessonLibrary &library);

signals:
    void changed();

private:
    /// The content of a file before a change.
    struct Change
    {
        QString what;
        QString file;
        QByteArray before; ///< empty: there was no file
    };

    void write(const QString &file, const QByteArray &content) const;
    QString freeTitle(const QString &wanted) const;

    QString m_folder;
    std::vector<KeptExperiment> m_all;
    QStringList m_mistakes;
    std::vector<Change> m_changes;
};

}

#pragma once

#include "app/model/notebook/notebook_page.h"

#include <QDialog>

class QCheckBox;
class QHBoxLayout;
class QLabel;
class QLineEdit;
class QListWidget;
class QPushButton;
class QVBoxLayout;

namespace app {

/// A dialog that writes what the learner did into files: a notebook to hand in, a web page and a PDF to read. It names a
/// learner only if she types her name, and sends nothing anywhere.
class HandInDialog : public QDialog
{
    Q_OBJECT

public:
    /// `gallery` is the folder of the gallery; empty: there is none. The other arguments must outlive it.
    HandInDialog(const LessonLibrary &library, const Progress &progress, const Notes &notes,
                 const Proofs &proofs, QString gallery, QWidget *parent = nullptr);

    /// Shows the dialog with what is done by now.
    void offer();
    /// Returns the message at the bottom: what will be written, or what was.
    QString message() const;

private:
    void addFields(QVBoxLayout &column);
    void addFiles(QVBoxLayout &column);
    void addButtons(QVBoxLayout &column);
    /// Returns a row with a field and its label.
    QHBoxLayout *fieldRow(const QString &text, QLineEdit &field);
    QCheckBox *box(const QString &name, const QString &text, const QString &help, QVBoxLayout &column);
    void list();
    void choose();
    void write();
    void writeFiles(const QStringList &files) const;
    void followChange();
    QString base() const;
    /// Returns the files that are chosen: the paths of notebook, page and PDF.
    QStringList files() const;
    bool hasContent() const;
    QStringList lessons() const;

    const LessonLibrary &m_library;
    const Progress &m_progress;
    const Notes &m_notes;
    const Proofs &m_proofs;
    QString m_folder; ///< of the gallery
    QLineEdit *m_name = nullptr;
    QList<QLabel *> m_labels;    ///< of the fields, to align these
    QLabel *m_heading = nullptr; ///< of the lessons
    QListWidget *m_lessons = nullptr;
    QCheckBox *m_gallery = nullptr;
    QCheckBox *m_notebook = nullptr;
    QCheckBox *m_page = nullptr;
    QCheckBox *m_pdf = nullptr;
    QLineEdit *m_file = nullptr; ///< the path without an ending
    QLabel *m_message = nullptr;
    QPushButton *m_write = nullptr;
    bool m_mayReplace = false;
};

}

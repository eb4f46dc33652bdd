#pragma once

#include <QPointer>
#include <QString>

class QWidget;

namespace app {

class HandInDialog;
class Notes;
class Progress;
class Proofs;
struct LessonLibrary;

/// Hands in the learner's notebook.
class NotebookDesk
{
public:
    /// The dialog belongs to `window`. All arguments must outlive it.
    NotebookDesk(const LessonLibrary &library, const Progress &progress, const Notes &notes,
                 const Proofs &proofs, QWidget &window);
    ~NotebookDesk();

    /// Sets the folder of the gallery, whose scenes can be handed in, too.
    void setGallery(const QString &folder);
    /// Shows the dialog that writes the notebook.
    void show();

private:
    const LessonLibrary &m_library;
    const Progress &m_progress;
    const Notes &m_notes;
    const Proofs &m_proofs;
    QWidget &m_window;
    QString m_gallery;
    QPointer<HandInDialog> m_dialog;
};

}

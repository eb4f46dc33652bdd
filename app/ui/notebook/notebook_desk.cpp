#include "app/ui/notebook/notebook_desk.h"

#include "app/ui/notebook/hand_in_dialog.h"

namespace app {

NotebookDesk::NotebookDesk(const LessonLibrary &library, const Progress &progress, const Notes &notes,
                           const Proofs &proofs, QWidget &window)
    : m_library(library), m_progress(progress), m_notes(notes), m_proofs(proofs), m_window(window)
{
}

NotebookDesk::~NotebookDesk() = default;

void NotebookDesk::setGallery(const QString &folder)
{
    delete m_dialog;
    m_gallery = folder;
}

void NotebookDesk::show()
{
    if (!m_dialog)
        m_dialog = new HandInDialog(m_library, m_progress, m_notes, m_proofs, m_gallery, &m_window);
    m_dialog->offer();
}

}

#include "app/ui/notebook/notebook_desk.h"

#include "app/ui/notebook/hand_in_dialog.h"

namespace app {

NotebookDesk::NotebookDesk(Session &session, QWidget &window) : m_session(session), m_window(window) {}

NotebookDesk::~NotebookDesk() = default;

void NotebookDesk::setGallery(const QString &folder)
{
    delete m_dialog;
    m_gallery = folder;
}

void NotebookDesk::show()
{
    if (!m_dialog)
        m_dialog = new HandInDialog(m_session, m_gallery, &m_window);
    m_dialog->offer();
}

}

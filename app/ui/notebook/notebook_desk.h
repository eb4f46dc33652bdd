#pragma once

#include <QPointer>
#include <QString>

class QWidget;

namespace app {

class HandInDialog;
class Session;

/// Hands in the learner's notebook.
class NotebookDesk
{
public:
    /// The dialog belongs to `window`. Both arguments must outlive it.
    NotebookDesk(Session &session, QWidget &window);
    ~NotebookDesk();

    /// Sets the folder of the gallery, whose scenes can be handed in, too.
    void setGallery(const QString &folder);
    /// Shows the dialog that writes the notebook.
    void show();

private:
    Session &m_session;
    QWidget &m_window;
    QString m_gallery;
    QPointer<HandInDialog> m_dialog;
};

}

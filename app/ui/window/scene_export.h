#pragma once

#include "app/ui/theme/theme.h"

#include <QCoreApplication>

class QWidget;

namespace app {

class FilmDialog;
class Notice;
class SceneView;
class Session;

/// Exports pictures and films of the scene.
class SceneExport
{
    Q_DECLARE_TR_FUNCTIONS(SceneExport)

public:
    /// Dialogs belong to `window`. All arguments must outlive it.
    SceneExport(Session &session, SceneView &scene, Notice &notice, const Theme &theme, QWidget &window);

    /// Copies the picture to the clipboard.
    void copyPicture();
    /// Asks where to save the picture, and saves it.
    void askPicture();
    /// Writes the scene as it is shown, as PNG or SVG. Returns whether it was written; a failure is shown.
    bool savePicture(const QString &path);
    /// Shows the dialog that makes films.
    void showFilm();
    /// Returns whether a film is being made.
    bool isMakingFilm() const;

private:
    Session &m_session;
    SceneView &m_scene;
    Notice &m_notice;
    const Theme &m_theme;
    QWidget &m_window;
    FilmDialog *m_film = nullptr; ///< made when it is shown first
};

}

#pragma once

#include "app/ui/theme/theme.h"

#include <QCoreApplication>

class QWidget;

namespace app {

class FilmDialog;
class Notice;
class PlotsPanel;
class SceneView;
class Session;
class WebPageDialog;

/// Exports pictures, films and web pages of the scene, and the lesson on paper.
class SceneExport
{
    Q_DECLARE_TR_FUNCTIONS(SceneExport)

public:
    /// Dialogs belong to `window`. All arguments must outlive it.
    SceneExport(Session &session, SceneView &scene, PlotsPanel &plots, Notice &notice, const Theme &theme,
                QWidget &window);

    /// Copies the picture to the clipboard.
    void copyPicture();
    /// Asks where to save the picture, and saves it.
    void askPicture();
    /// Writes the scene as it is shown, as PNG or SVG. Returns whether it was written; a failure is shown.
    bool savePicture(const QString &path);
    /// Shows the dialog that makes films.
    void showFilm();
    /// Shows the dialog that makes web pages.
    void showWebPage();
    /// Asks where to save the lesson on paper, and writes it. A failure is shown.
    void askHandout();
    /// Returns whether a film is being made.
    bool isMakingFilm() const;
    /// Returns whether a web page is being made.
    bool isMakingWebPage() const;

private:
    Session &m_session;
    SceneView &m_scene;
    PlotsPanel &m_plots;
    Notice &m_notice;
    const Theme &m_theme;
    QWidget &m_window;
    FilmDialog *m_film = nullptr;       ///< made when it is shown first
    WebPageDialog *m_webPage = nullptr; ///< likewise
};

}

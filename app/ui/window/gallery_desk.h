#pragma once

#include "app/model/files/gallery.h"
#include "app/ui/theme/theme.h"

#include <QPointer>

#include <memory>

namespace app {

class ExperimentFiles;
class GalleryPage;
class Notice;
class ProjectDesk;
class SceneView;
class Session;

/// The gallery of a window: keeps the open experiment, shows what is kept, and opens it.
class GalleryDesk : public QObject
{
    Q_OBJECT

public:
    /// Dialogs belong to `window`. All arguments must outlive it. There is no gallery until setFolder().
    GalleryDesk(Session &session, SceneView &scene, ProjectDesk &projects, ExperimentFiles &files,
                Notice &notice, const Theme &theme, QWidget &window);

    void setFolder(const QString &folder);
    /// Keeps the open experiment with a picture of the scene as it is shown. A failure is shown.
    void keep();
    void showPage();

private:
    /// Returns the title of the project that is built here, or that of the step.
    QString title() const;
    void openKept(const KeptExperiment &kept);

    Session &m_session;
    SceneView &m_scene;
    ProjectDesk &m_projects;
    ExperimentFiles &m_files;
    Notice &m_notice;
    const Theme &m_theme;
    QWidget &m_window;
    std::unique_ptr<Gallery> m_gallery;
    QPointer<GalleryPage> m_page;
};

}

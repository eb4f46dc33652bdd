#include "app/ui/window/gallery_desk.h"

#include "app/model/learning/project_desk.h"
#include "app/model/session/session.h"
#include "app/model/text/quoting.h"
#include "app/ui/dialogs/gallery_page.h"
#include "app/ui/dialogs/report_errors.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/window/experiment_files.h"

namespace app {

GalleryDesk::GalleryDesk(Session &session, SceneView &scene, ProjectDesk &projects, ExperimentFiles &files,
                         Notice &notice, const Theme &theme, QWidget &window)
    : m_session(session), m_scene(scene), m_projects(projects), m_files(files), m_notice(notice),
      m_theme(theme), m_window(window)
{
}

void GalleryDesk::setFolder(const QString &folder)
{
    delete m_page;
    m_gallery = std::make_unique<Gallery>(folder);
}

QString GalleryDesk::title() const
{
    const QString &current = m_projects.current();
    const lessons::Project *project = current.isEmpty() ? nullptr : m_projects.projectOf(current);
    return project && m_projects.isAtPlace(current) ? project->title : m_session.step().title;
}

void GalleryDesk::keep()
{
    if (!m_gallery)
        return;
    QString kept;
    const bool isKept = attempt(m_notice, tr("Could not keep the experiment: %1"), [&] {
        Experiment experiment = m_session.experiment();
        experiment.branches = {}; // what is kept is one run
        kept = m_gallery->keep(experiment, m_session.library(), title(), m_scene.picture());
    });
    if (isKept)
        m_session.showMessage(tr("Kept in the gallery as %1.").arg(quoted(kept)));
}

void GalleryDesk::showPage()
{
    if (!m_gallery)
        return;
    if (!m_page) {
        m_page = new GalleryPage(*m_gallery, m_theme, &m_window);
        connect(m_page, &GalleryPage::keepRequested, this, &GalleryDesk::keep);
        connect(m_page, &GalleryPage::opens, this, &GalleryDesk::openKept);
    }
    m_page->open();
}

void GalleryDesk::openKept(const KeptExperiment &kept)
{
    std::optional<Experiment> read;
    if (!m_files.opens([&] { read = Gallery::experimentOf(kept, m_session.library()); }))
        return;
    const bool isOpen = m_session.lesson().id == read->lesson && m_session.step().id == read->step;
    if (!isOpen)
        m_session.openStep(read->lesson, read->step); // the step that is open now stays as it is
    RunEditor &editor = m_session.editor();
    const EditLabel label{tr("Open %1").arg(quoted(kept.title)), {}, {}};
    editor.endGesture();
    const bool isSandbox = m_session.isSandbox();
    const bool isShown = isSandbox ? editor.replaceScene(label, read->script, read->draft)
                                   : editor.setUp(label, read->script, RunEditor::Maker::learner);
    if (isShown && !isSandbox && read->draft)
        m_session.code().write(*read->draft);
    editor.endGesture();
    if (isShown)
        m_session.showMessage(tr("%1 is open. Undo brings your scene back.").arg(quoted(kept.title)));
}

}

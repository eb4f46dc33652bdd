#include "app/ui/window/scene_export.h"

#include "app/model/session/session.h"
#include "app/model/text/quoting.h"
#include "app/ui/dialogs/ask_file.h"
#include "app/ui/dialogs/report_errors.h"
#include "app/ui/film/film_dialog.h"
#include "app/ui/film/handout_export.h"
#include "app/ui/film/picture_file.h"
#include "app/ui/film/web_page_dialog.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/scene/scene_view.h"

#include <QClipboard>
#include <QFileInfo>
#include <QGuiApplication>

namespace app {

namespace {

PageSwitches switchesFrom(const Extras &extras)
{
    PageSwitches switches;
    switches.trails = extras.trails;
    switches.velocities = extras.velocities;
    switches.onion = extras.onion;
    switches.ghost = extras.comparison;
    switches.guides = extras.overlays;
    switches.unitCircle = extras.unitCircle;
    switches.grid = extras.grid;
    switches.eyes = extras.eyes;
    return switches;
}

}

SceneExport::SceneExport(Session &session, SceneView &scene, PlotsPanel &plots, Notice &notice,
                         const Theme &theme, QWidget &window)
    : m_session(session), m_scene(scene), m_plots(plots), m_notice(notice), m_theme(theme), m_window(window)
{
}

void SceneExport::copyPicture()
{
    QGuiApplication::clipboard()->setImage(m_scene.picture(pngScale));
    m_session.showMessage(tr("The picture of the scene is copied."));
}

void SceneExport::askPicture()
{
    const QString suggestion = m_session.step().id + ".png";
    const QString path =
        askWhereToSave(&m_window, tr("Picture of the scene"), suggestion, tr("Pictures (*.png *.svg)"));
    if (!path.isEmpty())
        savePicture(path);
}

bool SceneExport::savePicture(const QString &path)
{
    if (!attempt(m_notice, tr("Could not save the picture: %1"), [&] { app::savePicture(m_scene, path); }))
        return false;
    m_session.showMessage(tr("Saved as %1.").arg(shownPath(QFileInfo(path).fileName())));
    return true;
}

void SceneExport::askHandout()
{
    QString path;
    if (attempt(m_notice, tr("Could not write the handout: %1"),
                [&] { path = exportHandout(m_window, m_session.lesson(), m_session.library()); }) &&
        !path.isEmpty())
        m_session.showMessage(tr("Saved as %1.").arg(shownPath(QFileInfo(path).fileName())));
}

void SceneExport::showFilm()
{
    if (!m_film)
        m_film = new FilmDialog(m_session, m_scene, m_theme, &m_window);
    m_film->offer();
}

void SceneExport::showWebPage()
{
    if (!m_webPage)
        m_webPage = new WebPageDialog(m_session, &m_window);
    std::vector<PlotSpec> plots;
    if (m_plots.isVisible()) {
        for (const PlotSpec &plot : m_plots.list().plots())
            plots.push_back(pinned(plot, m_session.selected()));
    }
    m_webPage->offer(std::move(plots), switchesFrom(m_scene.extras()));
}

bool SceneExport::isMakingWebPage() const
{
    return m_webPage && m_webPage->isMaking();
}

bool SceneExport::isMakingFilm() const
{
    return m_film && m_film->isMaking();
}

}

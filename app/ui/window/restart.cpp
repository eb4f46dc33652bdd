#include "app/ui/window/restart.h"

#include "app/ui/actions/command.h"
#include "app/ui/dialogs/notice.h"
#include "app/ui/window/last_step.h"
#include "app/ui/window/mode_choice.h"
#include "app/ui/window/scene_export.h"

#include <QWidget>

namespace app {

Restart::Restart(const RestartParts &parts, const SceneExport &exports, Notice &notice, QWidget &window)
    : m_parts(parts), m_exports(exports), m_notice(notice), m_window(window)
{
}

void Restart::offer(const QString &reason)
{
    const bool films = m_exports.isMakingFilm();
    if (!films && !m_exports.isMakingWebPage()) {
        start();
        return;
    }
    m_notice.ask(films ? tr("%1 A film is being made.").arg(reason)
                       : tr("%1 A web page is being made.").arg(reason),
                 {{tr("Restart now"),
                   films ? tr("Cancels the film; everything else is kept")
                         : tr("Cancels the page; everything else is kept"),
                   [this] { start(); }}});
}

void Restart::start()
{
    Session &session = m_parts.session;
    m_handover = Handover{m_parts.document.saved(), m_parts.mode.mode(), session.playback().goal(),
                          session.playback().isPlaying(), m_parts.sceneOnly.isChecked()};
    // No time passes between two windows.
    session.input().releaseAll();
    session.preview().end();
    session.cancelComputing();
    m_window.close();
}

void Restart::continueFrom(const Handover &from)
{
    m_parts.mode.restore(from.mode, LastStep::load());
    m_parts.sceneOnly.setChecked(from.isSceneOnly);
    m_parts.document.setSaved(from.saved);
    if (from.goal)
        m_parts.session.playback().goTo({*from.goal, 0});
    if (from.isPlaying)
        m_parts.session.playback().play();
}

}

// The scene alone: no panels, the first parameters above it, its time in one row below it.

#include "app/ui/scene/scene_bar.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/footfall_strip.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/commands.h"
#include "app/ui/window/focus_parameters.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/room.h"
#include "app/ui/window/scene_card.h"

#include <QAction>
#include <QBoxLayout>
#include <QDockWidget>
#include <QLayout>
#include <QMenu>

namespace app {

void MainWindow::makeFocusActions()
{
    m_focusAction = m_commands->add(tr("Scene onl&y"), {QKeySequence(Qt::Key_F11)}, KeyGroup::window);
    m_focusAction->setObjectName("sceneOnly");
    m_focusAction->setToolTip(tr("Nothing but the scene and its time; again brings the panels back (F11)"));
    m_focusAction->setCheckable(true);
    m_view->addAction(m_focusAction);
    connect(m_focusAction, &QAction::toggled, this, &MainWindow::setFocusMode);
    QAction *full = m_commands->add(tr("F&ull screen"), {QKeySequence("Shift+F11")}, KeyGroup::window);
    full->setCheckable(true);
    m_view->addAction(full);
    // The window may have been left so at the last start, and others than this action can change it.
    const auto follow = [this, full] { full->setChecked(isFullScreen()); };
    connect(m_view, &QMenu::aboutToShow, full, follow);
    connect(full, &QAction::triggered, this, [this, follow] {
        setWindowState(windowState() ^ Qt::WindowFullScreen);
        follow();
    });
}

void MainWindow::setFocusMode(bool on)
{
    if (on)
        enterFocus();
    else
        leaveFocus();
}

void MainWindow::enterFocus()
{
    showStability(false);
    m_room->bringAllBack();
    m_docksBeforeFocus = saveState();
    for (QDockWidget *dock : findChildren<QDockWidget *>())
        dock->hide();
    m_footfall->setMaximumHeight(0); // it stands under the timeline, which goes
    m_transport->takeIn(m_timeline);
    m_timeline->setForm(TimelineStrip::Form::trackOnly);
    m_sceneBar->setMiddle(new FocusParameters(m_session, m_theme, m_sceneBar));
    if (!m_card)
        m_card = new SceneCard(m_session, m_theme, *m_scene);
    m_card->show();
    m_scene->setFocus();
}

void MainWindow::leaveFocus()
{
    m_card->hide();
    m_sceneBar->setMiddle(nullptr);
    m_transport->giveOut(m_timeline);
    m_timeline->setForm(TimelineStrip::Form::whole);
    auto *column = static_cast<QBoxLayout *>(centralWidget()->layout());
    column->insertWidget(column->indexOf(m_transport) + 1, m_timeline);
    m_footfall->setMaximumHeight(QWIDGETSIZE_MAX);
    column
        ->activate(); // panels come back to the width that they had, beside a scene that needs no more than before
    layout()->activate();
    restorePanels(m_docksBeforeFocus);
    placeSides();
    fitParameters();
}

}

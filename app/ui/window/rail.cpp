// The lessons as a narrow strip of marks beside the scene, and the whole list again.

#include "app/ui/panels/learn_panel.h"
#include "app/ui/window/commands.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/room.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>

namespace app {

void MainWindow::makeRailAction()
{
    m_railAction =
        m_commands->add(tr("Lessons &as a narrow strip"), {QKeySequence("Ctrl+Shift+1")}, KeyGroup::window);
    m_railAction->setObjectName("lessonRail");
    m_railAction->setToolTip(tr("The marks of the lessons alone, and more room for the rest (Ctrl+Shift+1)"));
    m_railAction->setCheckable(true);
    m_view->addAction(m_railAction);
    connect(m_railAction, &QAction::triggered, this, &MainWindow::chooseForm);
    connect(m_learn, &LearnPanel::formAsked, this,
            [this](LearnPanel::Form form) { chooseForm(form == LearnPanel::Form::rail); });
    connect(m_learn, &LearnPanel::formChanged, this, &MainWindow::placeRail);
}

void MainWindow::chooseForm(bool isRail)
{
    m_layouts.chooseRail(m_layoutKey, isRail);
    m_left->show();
    m_learn->setForm(isRail ? LearnPanel::Form::rail : LearnPanel::Form::whole);
}

void MainWindow::useKeptForm()
{
    const bool byItself = m_mode == Mode::measure && width() < wideWindow;
    const bool isRail = m_layouts.hasRail(m_layoutKey, byItself);
    m_learn->setForm(isRail ? LearnPanel::Form::rail : LearnPanel::Form::whole);
    placeRail();
}

void MainWindow::placeRail()
{
    const bool builds = m_session.isWorkshop(); // its tools are in the place of the lessons
    const bool isRail = m_learn->form() == LearnPanel::Form::rail;
    m_railAction->setChecked(isRail);
    m_railAction->setEnabled(!builds);
    QWidget &pages = *m_left->widget();
    const bool wasNarrow = pages.maximumWidth() == LearnPanel::railWidth;
    if (isRail && !builds) {
        pages.setFixedWidth(LearnPanel::railWidth);
    } else if (wasNarrow) {
        pages.setMinimumWidth(0);
        pages.setMaximumWidth(QWIDGETSIZE_MAX);
        placeSides();
    }
}

}

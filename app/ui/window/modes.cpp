// What the window is arranged for: learning, or measuring what accuracy costs.

#include "app/ui/window/commands.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/room.h"

#include <QActionGroup>
#include <QButtonGroup>
#include <QDockWidget>
#include <QFrame>
#include <QHBoxLayout>
#include <QMenu>
#include <QToolButton>

#include <utility>

namespace app {

void MainWindow::makeModeActions()
{
    m_modes = new QActionGroup(this);
    const auto add = [this](const QString &text, const char *key, const QString &tip, Mode mode) {
        QAction *made = m_commands->add(text, {QKeySequence(key)}, KeyGroup::window);
        made->setToolTip(tr("%1 (%2)").arg(tip, key));
        made->setCheckable(true);
        made->setChecked(mode == m_mode);
        m_modes->addAction(made);
        m_view->addAction(made);
        connect(made, &QAction::triggered, this, [this, mode] { setMode(mode); });
    };
    add(tr("L&earn"), "F5", tr("Lessons, scene and code"), Mode::learn);
    add(tr("&Measure"), "F6", tr("What accuracy costs in time, on this scene"), Mode::measure);
    add(tr("&Build"), "F7", tr("A scene of your own: points, springs, sticks, feet"), Mode::build);
    m_view->addSeparator();
}

QWidget *MainWindow::modeSwitch()
{
    auto *frame = new QFrame;
    frame->setObjectName("modes");
    auto *row = new QHBoxLayout(frame);
    row->setContentsMargins(2, 2, 2, 2);
    row->setSpacing(2);
    for (QAction *mode : m_modes->actions()) {
        auto *button = new QToolButton(frame);
        button->setObjectName("mode");
        button->setText(mode->text().remove('&'));
        button->setToolTip(mode->toolTip());
        button->setCheckable(true);
        button->setChecked(mode->isChecked());
        button->setEnabled(mode->isEnabled());
        button->setFocusPolicy(Qt::TabFocus);
        row->addWidget(button);
        connect(button, &QToolButton::clicked, mode, [button, mode] {
            mode->trigger();
            button->setChecked(mode->isChecked()); // a click on the one that is on leaves it on
        });
        connect(mode, &QAction::toggled, button, &QToolButton::setChecked);
    }
    return frame;
}

void MainWindow::setMode(Mode mode)
{
    if (mode == m_mode)
        return;
    arrangeFor(mode);
    if (mode == Mode::build)
        m_trip.go();
    else if (mode == Mode::learn)
        m_trip.comeBack();
    fitParameters();
}

void MainWindow::arrangeFor(Mode mode)
{
    if (mode == m_mode)
        return;
    m_focusAction->setChecked(false);
    showStability(false);
    keepLayout();
    const Mode before = std::exchange(m_mode, mode);
    m_modes->actions().at(static_cast<int>(mode))->setChecked(true);
    useLayout(before);
    arrangePlots();
    placeSides();
}

void MainWindow::showEnergy(bool shown)
{
    showDock(*m_energyDock, shown);
}

void MainWindow::showEffects(bool shown)
{
    showDock(*m_effectsDock, shown);
}

void MainWindow::arrangeForMeasuring()
{
    if (width() >= wideWindow) {
        m_accuracyDock->show();
        m_energyDock->show();
        splitDockWidget(m_accuracyDock, m_codeDock, Qt::Horizontal);
        splitDockWidget(m_codeDock, m_parameterDock, Qt::Vertical);
        splitDockWidget(m_accuracyDock, m_effectsDock, Qt::Vertical);
        m_effectsDock->show();
        resizeDocks({m_energyDock}, {300}, Qt::Vertical);
        resizeDocks({m_effectsDock}, {300}, Qt::Vertical);
        return;
    }
    m_left->show(); // as a rail
    m_accuracyDock->show();
    m_parameterDock->show();
    for (QDockWidget *tab : {m_effectsDock, m_energyDock, m_codeDock}) {
        tabifyDockWidget(m_accuracyDock, tab);
        tab->show();
    }
    m_accuracyDock->raise();
}

}

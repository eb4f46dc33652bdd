// The other runs of a step: their menu, and the dock that compares one of them with the run in use.

#include "app/ui/branches/branches_panel.h"
#include "app/ui/time/runs_menu.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/time/transport_bar.h"
#include "app/ui/window/commands.h"
#include "app/ui/window/main_window.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>

namespace app {

void MainWindow::makeBranchesDock()
{
    m_branches = new BranchesPanel(m_session, m_theme, this);
    m_branchesDock = dock("branches", new QWidget(this), m_branches, Qt::BottomDockWidgetArea);
    m_branchesDock->setWindowTitle(tr("Two runs")); // its tab, where docks are tabs
    m_branchesDock->hide();
    connect(m_branchesDock, &QDockWidget::visibilityChanged, m_branches,
            [branches = m_branches](bool seen) { branches->setCovered(!seen); });
    tabifyDockWidget(m_energyDock, m_branchesDock);
    const auto compare = [this] { showBranches(true); };
    connect(&m_transport->runs(), &RunsMenu::compareWanted, this, compare);
    connect(m_timeline, &TimelineStrip::compareWanted, this, compare);
}

void MainWindow::makeBranchActions()
{
    const KeyGroup group = KeyGroup::otherRuns;
    const auto add = [&](const QString &text, const char *key, const QString &tip, auto slot) {
        QAction *made = m_commands->add(text, {QKeySequence(key)}, group);
        made->setToolTip(tr("%1 (%2)").arg(tip, key));
        connect(made, &QAction::triggered, this, slot);
        m_run->addAction(made);
        return made;
    };
    m_run->addMenu(&m_transport->runs());
    add(tr("Choose among the other runs…"), "Ctrl+Shift+R",
        tr("Show one beside, go back to it, keep, name or delete it"), [this] { m_transport->chooseRun(); });
    QAction *compare =
        add(tr("&Compare two runs"), "Ctrl+Shift+B",
            tr("How far this run and the one beside it are apart, frame by frame"),
            [this](bool shown) { showBranches(shown || m_branches->visibleRegion().isEmpty()); });
    compare->setCheckable(true);
    compare->setObjectName("showBranches");
    connect(m_branchesDock, &QDockWidget::visibilityChanged, compare,
            [dock = m_branchesDock, compare] { compare->setChecked(!dock->isHidden()); });
}

void MainWindow::showBranches(bool shown)
{
    showDock(*m_branchesDock, shown);
}

}

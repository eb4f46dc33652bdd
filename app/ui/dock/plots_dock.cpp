#include "app/ui/dock/plots_dock.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QSettings>

namespace app {

namespace {

constexpr const char *plotsShownKey = "plots/shown";

}

bool PlotsDock::isWanted()
{
    return QSettings().value(plotsShownKey, true).toBool();
}

void PlotsDock::show(bool isShown) const
{
    QSettings().setValue(plotsShownKey, isShown);
    QDockWidget &plots = m_layout.docks[Panel::plots];
    plots.setVisible(isShown);
    if (!isShown)
        return;
    arrange();
    plots.raise();
}

void PlotsDock::arrange() const
{
    QMainWindow &window = m_layout.window;
    QDockWidget &plots = m_layout.docks[Panel::plots];
    const Qt::DockWidgetArea area = window.dockWidgetArea(&plots);
    if (area == Qt::LeftDockWidgetArea || area == Qt::BottomDockWidgetArea) {
        plots.setVisible(isWanted()); // the learner has put it there
        return;
    }
    window.removeDockWidget(&plots); // a dock leaves its tabs only this way
    window.addDockWidget(Qt::RightDockWidgetArea, &plots);
    if (hasRoomForPlots(window.size())) {
        window.splitDockWidget(&m_layout.docks[Panel::code], &plots, Qt::Vertical);
    } else {
        const Panel panel = m_layout.id.mode == WindowMode::measure ? Panel::accuracy : Panel::code;
        window.tabifyDockWidget(&m_layout.docks[panel], &plots);
        m_layout.docks[panel].raise();
    }
    plots.setVisible(isWanted());
}

}

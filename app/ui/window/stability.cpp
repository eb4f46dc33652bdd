// The stability gauge in the status bar, and its reasons in a dock.

#include "app/ui/plots/plot_export.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/stability/stability_gauge.h"
#include "app/ui/stability/stability_panel.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/notice.h"

#include <QAction>
#include <QDockWidget>

namespace app {

void MainWindow::makeStability()
{
    m_gauge = new StabilityGauge(*m_stability, m_theme, this);
    m_gauge->setCheckable(true);
    m_stabilityPanel = new StabilityPanel(*m_stability, m_theme, this);
    m_stabilityDock = dock("stability", new QWidget(this), m_stabilityPanel, Qt::RightDockWidgetArea);
    m_stabilityDock->setWindowTitle(tr("Stability")); // its tab, where docks are tabs
    m_stabilityDock->hide();
    connect(m_gauge, &StabilityGauge::clicked, this, [this](bool on) { showStability(on); });
    connect(&m_stabilityPanel->exports(), &PlotExport::said, &m_session, &Session::said);
    connect(&m_stabilityPanel->exports(), &PlotExport::failed, m_notice, &Notice::say);
    connect(m_stabilityPanel, &StabilityPanel::closed, this, [this] { showStability(false); });
}

void MainWindow::showStability(bool shown)
{
    m_gauge->setChecked(shown);
    m_stabilityAction->setChecked(shown);
    if (shown == !m_stabilityDock->isHidden())
        return;
    if (!shown) {
        m_stabilityDock->hide();
        if (m_replaced) {
            m_replaced->show();
            m_replaced->raise(); // where docks are tabs
        }
        m_replaced = nullptr;
        fitParameters();
        m_scene->setFocus();
        return;
    }
    // It takes the place of what the learner can best do without: the scene, the parameters and the lessons stay.
    for (QDockWidget *dock : {m_accuracyDock, m_codeDock}) {
        const bool isCovered = dock->visibleRegion().isEmpty(); // one of several tabs
        if (!dock->isHidden() && (!m_replaced || !isCovered))
            m_replaced = dock;
    }
    const int wide = m_replaced ? m_replaced->width() : m_parameterDock->width();
    if (m_replaced)
        splitDockWidget(m_replaced, m_stabilityDock, Qt::Vertical);
    m_stabilityDock->show();
    m_stabilityDock->raise(); // where docks are tabs
    if (m_replaced)
        m_replaced->hide();
    resizeDocks({m_stabilityDock}, {wide}, Qt::Horizontal);
    fitParameters();
}

void MainWindow::showGrowthMap(MapPlane plane)
{
    m_stabilityPanel->showMap(plane);
}

}

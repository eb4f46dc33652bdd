// The plots of the window: where they stand, and who hears what they say.

#include "app/ui/branches/branches_panel.h"
#include "app/ui/energy/energy_panel.h"
#include "app/ui/measure/accuracy_panel.h"
#include "app/ui/plots/plot_export.h"
#include "app/ui/plots/plots_panel.h"
#include "app/ui/scene/scene_view.h"
#include "app/ui/time/timeline_strip.h"
#include "app/ui/window/commands.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/notice.h"
#include "app/ui/window/room.h"

#include <QAction>
#include <QDockWidget>
#include <QMenu>
#include <QResizeEvent>
#include <QSettings>

namespace app {

namespace {

const char *const shownKey = "plots/shown";
constexpr int high = 900; ///< and here, plots fit between code and parameters

}

void MainWindow::makePlots()
{
    m_plots = new PlotsPanel(m_session, m_theme, this);
    m_plotsDock = dock("plots", new QWidget(this), m_plots, Qt::RightDockWidgetArea);
    m_plotsDock->setWindowTitle(tr("Plots")); // its tab, where docks are tabs
    m_codeDock->setWindowTitle(tr("Code"));
    connect(m_plots, &PlotsPanel::said, &m_session, &Session::said);
    connect(m_plots, &PlotsPanel::failed, m_notice, &Notice::say);
    connect(m_plots, &PlotsPanel::wantedHeightChanged, this, &MainWindow::fitParameters);
    for (const PlotExport *exports : {&m_energy->exports(), &m_accuracy->exports(), &m_branches->exports()}) {
        connect(exports, &PlotExport::said, &m_session, &Session::said);
        connect(exports, &PlotExport::failed, m_notice, &Notice::say);
    }
    joinCursors();
    connect(m_plotsDock, &QDockWidget::visibilityChanged, m_plots,
            [plots = m_plots](bool seen) { plots->setCovered(!seen); });
}

void MainWindow::joinCursors()
{
    const auto point = [this](std::optional<std::int64_t> frame) {
        frame ? m_session.glance({*frame, 0}) : m_session.endGlance();
    };
    connect(m_plots, &PlotsPanel::pointedAt, this, point);
    connect(m_energy, &EnergyPanel::pointedAt, this, point);
    connect(m_branches, &BranchesPanel::pointedAt, this, point);
    connect(m_accuracy, &AccuracyPanel::pointedAt, this, point);
    connect(m_timeline, &TimelineStrip::pointedAt, this, point);
    connect(m_scene, &SceneView::bodyPointedAt, m_plots, &PlotsPanel::setPointedBody);
    connect(&m_session, &Session::glanceChanged, this, [this] {
        const std::optional<sim::Cursor> &moment = m_session.marked();
        // Inside a frame plots are no finer than the cursor that they have there already.
        const bool isFrame = moment && moment->phase == 0;
        const auto frame = isFrame ? std::optional(moment->frame) : std::nullopt;
        m_plots->setHovered(frame);
        m_energy->setHovered(frame);
        m_branches->setHovered(frame);
    });
}

void MainWindow::makePlotsAction()
{
    QAction *made = m_commands->add(tr("&Plots"), {QKeySequence("Ctrl+5")}, KeyGroup::window);
    made->setObjectName("showPlots");
    made->setToolTip(tr("Curves of any quantity of any body (Ctrl+5)"));
    made->setCheckable(true);
    m_view->addAction(made);
    connect(made, &QAction::triggered, this,
            [this](bool shown) { showPlots(shown || m_plots->isCovered()); });
    connect(m_plotsDock, &QDockWidget::visibilityChanged, made,
            [made, dock = m_plotsDock] { made->setChecked(!dock->isHidden()); });
}

bool MainWindow::hasRoomForPlots() const
{
    return width() >= wideWindow && height() >= high;
}

void MainWindow::showPlots(bool shown)
{
    QSettings().setValue(shownKey, shown);
    m_plotsDock->setVisible(shown);
    if (shown) {
        arrangePlots();
        m_plotsDock->raise();
    }
    fitParameters();
}

void MainWindow::arrangePlots()
{
    const bool shown = QSettings().value(shownKey, true).toBool();
    const Qt::DockWidgetArea area = dockWidgetArea(m_plotsDock);
    if (area == Qt::LeftDockWidgetArea || area == Qt::BottomDockWidgetArea) {
        m_plotsDock->setVisible(shown); // the learner has put it there
        return;
    }
    removeDockWidget(m_plotsDock); // a dock leaves its tabs only so
    if (hasRoomForPlots()) {
        addDockWidget(Qt::RightDockWidgetArea, m_plotsDock);
        splitDockWidget(m_codeDock, m_plotsDock, Qt::Vertical);
    } else {
        QDockWidget *beside = m_mode == Mode::measure ? m_accuracyDock : m_codeDock;
        addDockWidget(Qt::RightDockWidgetArea, m_plotsDock);
        tabifyDockWidget(beside, m_plotsDock);
        beside->raise();
    }
    m_plotsDock->setVisible(shown);
}

void MainWindow::resizeEvent(QResizeEvent *event)
{
    QMainWindow::resizeEvent(event);
    if (isVisible())
        m_room->share();
    const auto hasRoom = [](QSize size) { return size.width() >= wideWindow && size.height() >= high; };
    if (!event->oldSize().isValid() || hasRoom(event->oldSize()) != hasRoom(event->size()))
        arrangePlots();
    // Panels that gave way to a smaller window come back to the lengths that they had.
    placeSides();
    fitParameters();
}

}

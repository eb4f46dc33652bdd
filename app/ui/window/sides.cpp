// How wide the panels beside the scene are: as the learner left them, else as the window has room.

#include "app/ui/panels/learn_panel.h"
#include "app/ui/window/main_window.h"
#include "app/ui/window/room.h"

#include <QDockWidget>
#include <QMouseEvent>
#include <QStyle>

#include <algorithm>

namespace app {

namespace {

constexpr int leastWidth = 240; ///< px that a panel gives way to, so that the scene has room

}

bool MainWindow::isBeside(const QDockWidget &dock, Qt::DockWidgetArea area) const
{
    return !dock.isHidden() && !dock.isFloating() && dockWidgetArea(const_cast<QDockWidget *>(&dock)) == area;
}

std::vector<MainWindow::Side> MainWindow::sides() const
{
    const bool isWide = width() >= wideWindow;
    const bool isMeasure = m_mode == Mode::measure;
    const bool isWideMeasure = m_layoutKey == layoutKey(Mode::measure, true);
    std::vector<Side> all;
    const auto add = [&](const char *name, Qt::DockWidgetArea area,
                         std::initializer_list<QDockWidget *> docks, int usual, int least) {
        const auto shown = std::find_if(docks.begin(), docks.end(),
                                        [&](const QDockWidget *dock) { return isBeside(*dock, area); });
        if (shown != docks.end())
            all.push_back({*shown, name, m_layouts.length(m_layoutKey, name, usual), least});
    };
    const bool isRail = m_left->widget()->maximumWidth() == LearnPanel::railWidth;
    if (!isRail)
        add("left", Qt::LeftDockWidgetArea,
            {m_left, m_codeDock, m_plotsDock, m_parameterDock, m_accuracyDock},
            isWideMeasure ? 272
            : isWide      ? 320
                          : 280,
            leastWidth);
    if (isWideMeasure) {
        add("accuracy", Qt::RightDockWidgetArea, {m_accuracyDock, m_effectsDock}, 616, 480);
        add("right", Qt::RightDockWidgetArea, {m_codeDock, m_plotsDock, m_parameterDock}, 371, 340);
        return all;
    }
    add("right", Qt::RightDockWidgetArea,
        {m_codeDock, m_accuracyDock, m_stabilityDock, m_plotsDock, m_parameterDock},
        isMeasure ? 560
        : isWide  ? 480
                  : 400,
        340);
    return all;
}

void MainWindow::placeSides()
{
    std::vector<Side> all = sides();
    const int separator = style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr, this);
    const int railed = m_left->isHidden() || m_left->widget()->maximumWidth() != LearnPanel::railWidth
                           ? 0
                           : LearnPanel::railWidth + separator;
    int missing = leastScene.width() + railed - width();
    for (const Side &side : all)
        missing += side.width + separator;
    // The right-most give way first.
    for (auto side = all.rbegin(); side != all.rend() && missing > 0; ++side) {
        const int given = std::clamp(side->width - side->least, 0, missing);
        side->width -= given;
        missing -= given;
    }
    QList<QDockWidget *> docks;
    QList<int> widths;
    for (const Side &side : all) {
        docks << side.dock;
        widths << side.width;
    }
    resizeDocks(docks, widths, Qt::Horizontal);
}

void MainWindow::noteSeparator(const QMouseEvent &event)
{
    m_besideSeparator.clear();
    if (!isSeparator(event.position().toPoint()))
        return;
    m_besideSeparator = sides();
    for (Side &side : m_besideSeparator)
        side.width = side.dock->width();
    m_heightBefore = m_parameterDock->height();
}

void MainWindow::keepSides()
{
    for (const Side &before : m_besideSeparator) {
        if (before.dock->width() != before.width)
            m_layouts.chooseLength(m_layoutKey, before.name, before.dock->width());
    }
    if (!m_besideSeparator.empty() && m_parameterDock->height() != m_heightBefore)
        m_layouts.chooseLength(m_layoutKey, heightOfParameters, m_parameterDock->height());
    m_besideSeparator.clear();
}

}

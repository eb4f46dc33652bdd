#include "app/ui/dock/docks.h"

#include "app/ui/actions/command.h"

#include <QDockWidget>
#include <QLayout>
#include <QMainWindow>

#include <algorithm>

namespace app {

void Docks::add(const DockEntry &entry)
{
    auto *dock = new QDockWidget(entry.title, &m_window);
    dock->setObjectName(QLatin1String(entry.name));
    dock->setFeatures(QDockWidget::DockWidgetClosable);
    m_window.addDockWidget(entry.area, dock);
    dock->setHidden(entry.start == DockStart::hidden);
    const auto below = std::find_if(m_docks.begin(), m_docks.end(), [this](const auto &other) {
        return m_window.dockWidgetArea(other.second) == Qt::BottomDockWidgetArea;
    });
    if (entry.area == Qt::BottomDockWidgetArea && below != m_docks.end())
        m_window.tabifyDockWidget(below->second, dock);
    m_docks[entry.panel] = dock;
}

void Docks::fill(Panel panel, QWidget &content, QWidget *title)
{
    QDockWidget &dock = (*this)[panel];
    dock.setTitleBarWidget(title ? title : new QWidget(&dock));
    // Qt would lay the content out, for a size that is not its own yet, which takes long.
    if (content.layout())
        content.layout()->setEnabled(false);
    dock.setWidget(&content);
    if (content.layout())
        content.layout()->setEnabled(true);
}

std::vector<QDockWidget *> Docks::all() const
{
    std::vector<QDockWidget *> docks;
    for (const auto &[panel, dock] : m_docks)
        docks.push_back(dock);
    return docks;
}

void Docks::show(Panel panel, bool isShown) const
{
    if (const auto own = m_showFunctions.find(panel); own != m_showFunctions.end()) {
        own->second(isShown);
        return;
    }
    QDockWidget &dock = (*this)[panel];
    dock.setVisible(isShown);
    if (isShown)
        dock.raise();
}

bool Docks::isCovered(Panel panel) const
{
    const QDockWidget &dock = (*this)[panel];
    return !dock.isHidden() && dock.widget()->visibleRegion().isEmpty();
}

bool Docks::isIn(Panel panel, Qt::DockWidgetArea area) const
{
    QDockWidget &dock = (*this)[panel];
    return !dock.isHidden() && !dock.isFloating() && m_window.dockWidgetArea(&dock) == area;
}

void Docks::toggleTogether(Command &command, const std::vector<Panel> &panels)
{
    connect(&command, &QAction::triggered, this, [this, panels](bool isShown) {
        for (const Panel panel : panels)
            (*this)[panel].setVisible(isShown);
    });
    command.setChecked(true);
    follow(command, panels.front());
}

void Docks::toggle(Command &command, Panel panel)
{
    connect(&command, &QAction::triggered, this,
            [this, panel](bool isShown) { show(panel, isShown || isCovered(panel)); });
    follow(command, panel);
}

void Docks::follow(Command &command, Panel panel)
{
    QDockWidget &dock = (*this)[panel];
    connect(&dock, &QDockWidget::visibilityChanged, &command,
            [&command, &dock] { command.setChecked(!dock.isHidden()); });
}

}

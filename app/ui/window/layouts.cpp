// Where the panels stand: each preset has an arrangement of its own, which is remembered.

#include "app/ui/window/main_window.h"
#include "app/ui/window/room.h"

#include <QAction>
#include <QDockWidget>
#include <QLayout>

namespace app {

QString MainWindow::layoutKey(Mode mode) const
{
    return layoutKey(mode, width() >= wideWindow);
}

QString MainWindow::layoutKey(Mode mode, bool isWide)
{
    switch (mode) {
    case Mode::measure:
        return isWide ? QStringLiteral("window/docksMeasureWide") : QStringLiteral("window/docksMeasure");
    case Mode::build:
        return QStringLiteral("window/docksBuild");
    case Mode::learn:
        break;
    }
    return QStringLiteral("window/docks");
}

void MainWindow::keepLayout()
{
    if (m_layoutKey.isEmpty())
        return; // the window is not arranged yet
    m_room->bringAllBack();
    m_layouts.keep(m_layoutKey, m_focusAction->isChecked() ? m_docksBeforeFocus : saveState());
}

void MainWindow::saveLayouts()
{
    keepLayout();
    m_layouts.save();
}

bool MainWindow::restorePanels(const QByteArray &state)
{
    // Qt 6.4 shows its tab bars one by one from the list that it has of them. Where the window is to be laid out anew, the
    // first one shown makes it do so, which replaces the list.
    layout()->setEnabled(false);
    const bool restored = restoreState(state);
    layout()->setEnabled(true);
    layout()->activate();
    return restored;
}

void MainWindow::useLayout(Mode before)
{
    m_layoutKey = layoutKey(m_mode);
    useKeptForm();
    if (restorePanels(m_layouts.kept(m_layoutKey)))
        return;
    if (m_mode == Mode::measure) {
        removeDockWidget(m_plotsDock); // arrangePlots() finds its place among those that stay
        arrangeForMeasuring();
    } else if (before == Mode::measure) {
        restorePanels(m_layouts.kept(layoutKey(Mode::learn)));
    }
}

void MainWindow::resetLayout()
{
    m_focusAction->setChecked(false);
    showStability(false);
    m_layouts.forget(m_layoutKey);
    m_layoutKey = layoutKey(m_mode);
    useKeptForm();
    restorePanels(m_firstDocks);
    if (m_mode == Mode::measure) {
        removeDockWidget(m_plotsDock);
        arrangeForMeasuring();
    }
    arrangePlots();
    placeSides();
    fitParameters();
    emit m_session.said(tr("The panels stand as they did at first."));
}

}

#include "app/ui/dock/stability_dock.h"

#include "app/ui/dock/panel_sizes.h"

#include <QDockWidget>
#include <QMainWindow>

namespace app {

void StabilityDock::hide()
{
    QDockWidget &stability = m_layout.docks[Panel::stability];
    emit shownChanged(false);
    if (stability.isHidden())
        return;
    stability.hide();
    if (m_replaced) {
        m_replaced->show();
        m_replaced->raise();
    }
    m_replaced = nullptr;
    m_sizes.fitHeights();
    emit closed();
}

void StabilityDock::chooseReplaced()
{
    for (const Panel panel : {Panel::accuracy, Panel::code}) {
        QDockWidget &dock = m_layout.docks[panel];
        const bool isCovered = dock.visibleRegion().isEmpty();
        if (!dock.isHidden() && (!m_replaced || !isCovered))
            m_replaced = &dock;
    }
}

void StabilityDock::show()
{
    QDockWidget &stability = m_layout.docks[Panel::stability];
    emit shownChanged(true);
    if (!stability.isHidden())
        return;
    chooseReplaced();
    QMainWindow &window = m_layout.window;
    const int width = (m_replaced ? m_replaced : &m_layout.docks[Panel::parameters])->width();
    if (m_replaced)
        window.splitDockWidget(m_replaced, &stability, Qt::Vertical);
    stability.show();
    stability.raise();
    if (m_replaced)
        m_replaced->hide();
    window.resizeDocks({&stability}, {width}, Qt::Horizontal);
    m_sizes.fitHeights();
}

}

#include "app/ui/dock/window_layouts.h"

#include "app/ui/dock/dock_fitter.h"
#include "app/ui/dock/panel_sizes.h"
#include "app/ui/dock/plots_dock.h"
#include "app/ui/dock/rail_choice.h"

#include <QDockWidget>
#include <QLayout>
#include <QMainWindow>
#include <QResizeEvent>

namespace app {

WindowLayouts::WindowLayouts(PanelLayout &layout, DockFitter &fitter, const PanelSizes &sizes,
                             const PlotsDock &plots, RailChoice &rail)
    : m_layout(layout), m_fitter(fitter), m_sizes(sizes), m_plots(plots), m_rail(rail)
{
    layout.window.installEventFilter(this);
}

LayoutId WindowLayouts::idFor(WindowMode mode) const
{
    return {mode, m_layout.window.width() >= wideWindow};
}

void WindowLayouts::setMode(WindowMode mode)
{
    if (mode == m_layout.id.mode)
        return;
    emit aboutToArrange();
    store();
    const WindowMode before = m_layout.id.mode;
    m_layout.id = idFor(mode);
    emit modeChanged(mode);
    useStored(before);
    m_plots.arrange();
    m_sizes.fitWidths();
}

void WindowLayouts::store()
{
    if (!m_isArranged)
        return;
    m_fitter.bringAllBack();
    m_layout.store.store(m_layout.id.key(), m_hidden ? *m_hidden : m_layout.window.saveState());
}

void WindowLayouts::save()
{
    store();
    m_layout.store.save();
}

bool WindowLayouts::restore(const QByteArray &state)
{
    // Qt 6.4 shows its tab bars one by one from the list that it has of them. Where the window is to be laid out again, the
    // first one shown makes it do so, which replaces the list.
    QLayout *layout = m_layout.window.layout();
    layout->setEnabled(false);
    const bool isRestored = m_layout.window.restoreState(state);
    layout->setEnabled(true);
    layout->activate();
    return isRestored;
}

void WindowLayouts::useStored(WindowMode before)
{
    m_isArranged = true;
    m_rail.restore();
    if (restore(m_layout.store.layout(m_layout.id.key())))
        return;
    if (m_layout.id.mode == WindowMode::measure)
        arrangeForMeasuring();
    else if (before == WindowMode::measure)
        restore(m_layout.store.layout(idFor(WindowMode::learn).key()));
}

void WindowLayouts::restoreAtStart()
{
    m_layout.id = idFor(m_layout.id.mode);
    m_isArranged = true;
    m_rail.restore();
    restore(m_layout.store.layout(m_layout.id.key()));
    for (const Panel panel : {Panel::accuracy, Panel::energy, Panel::branches, Panel::effects})
        m_layout.docks[panel].hide(); // the window opens for learning
}

void WindowLayouts::reset()
{
    emit aboutToArrange();
    m_layout.store.forget(m_layout.id.key());
    m_layout.id = idFor(m_layout.id.mode);
    m_rail.restore();
    restore(m_layout.first);
    if (m_layout.id.mode == WindowMode::measure)
        arrangeForMeasuring();
    m_plots.arrange();
    m_sizes.fit();
}

void WindowLayouts::arrangeForMeasuring()
{
    QMainWindow &window = m_layout.window;
    const Docks &docks = m_layout.docks;
    window.removeDockWidget(&docks[Panel::plots]); // PlotsDock finds its place among the others
    QDockWidget &accuracy = docks[Panel::accuracy];
    if (window.width() >= wideWindow) {
        accuracy.show();
        docks[Panel::energy].show();
        window.splitDockWidget(&accuracy, &docks[Panel::code], Qt::Horizontal);
        window.splitDockWidget(&docks[Panel::code], &docks[Panel::parameters], Qt::Vertical);
        window.splitDockWidget(&accuracy, &docks[Panel::effects], Qt::Vertical);
        docks[Panel::effects].show();
        window.resizeDocks({&docks[Panel::energy]}, {300}, Qt::Vertical);
        window.resizeDocks({&docks[Panel::effects]}, {300}, Qt::Vertical);
        return;
    }
    docks[Panel::lessons].show(); // as a rail
    accuracy.show();
    docks[Panel::parameters].show();
    for (const Panel panel : {Panel::effects, Panel::energy, Panel::code}) {
        window.tabifyDockWidget(&accuracy, &docks[panel]);
        docks[panel].show();
    }
    accuracy.raise();
}

void WindowLayouts::hideAll()
{
    m_fitter.bringAllBack();
    m_hidden = m_layout.window.saveState();
    for (QDockWidget *dock : m_layout.docks.all())
        dock->hide();
}

void WindowLayouts::showAll()
{
    if (!m_hidden)
        return;
    m_layout.window.layout()->activate();
    restore(*m_hidden);
    m_hidden.reset();
    m_sizes.fit();
}

bool WindowLayouts::eventFilter(QObject *, QEvent *event)
{
    const bool isResize = event->type() == QEvent::Resize;
    // A panel may want more than before.
    if ((isResize || event->type() == QEvent::LayoutRequest) && m_layout.window.isVisible())
        m_fitter.share();
    if (isResize) {
        const auto &sizes = static_cast<QResizeEvent &>(*event);
        if (!sizes.oldSize().isValid() || hasRoomForPlots(sizes.oldSize()) != hasRoomForPlots(sizes.size()))
            m_plots.arrange();
    }
    // Panels that became smaller with the window get their sizes back.
    if (isResize || event->type() == QEvent::Show)
        m_sizes.fit();
    return false;
}

}

#include "app/ui/dock/panel_sizes.h"

#include "app/ui/learn/learn_panel.h"
#include "app/ui/parameters/parameter_panel.h"
#include "app/ui/parameters/parameter_row.h"

#include <QDockWidget>
#include <QMainWindow>
#include <QMouseEvent>
#include <QStyle>

#include <algorithm>

namespace app {

namespace {

constexpr const char *parametersName = "parameters"; ///< of their height in the settings
constexpr int leastLeft = 240;                       ///< px
constexpr int besideColumn = 68;                     ///< px of the window's height: header and status bar
constexpr int readableAccuracy = 490;                ///< px, its tab included

}

PanelSizes::PanelSizes(PanelLayout &layout) : m_layout(layout)
{
    layout.window.installEventFilter(this);
}

std::vector<PanelSizes::Side> PanelSizes::sides() const
{
    const bool isWide = m_layout.window.width() >= wideWindow;
    const bool isMeasure = m_layout.id.mode == WindowMode::measure;
    std::vector<Side> all;
    const auto add = [&](const char *name, Qt::DockWidgetArea area, std::initializer_list<Panel> panels,
                         int usual, int least) {
        const auto shown = std::find_if(panels.begin(), panels.end(),
                                        [&](Panel panel) { return m_layout.docks.isIn(panel, area); });
        if (shown != panels.end())
            all.push_back({&m_layout.docks[*shown], name,
                           m_layout.store.length(m_layout.id.key(), name, usual), least});
    };
    const bool isRail = m_layout.docks[Panel::lessons].widget()->maximumWidth() == LearnPanel::railWidth;
    if (!isRail)
        add("left", Qt::LeftDockWidgetArea,
            {Panel::lessons, Panel::code, Panel::plots, Panel::parameters, Panel::accuracy},
            m_layout.id.isWideMeasure() ? 272
            : isWide                    ? 320
                                        : 280,
            leastLeft);
    if (m_layout.id.isWideMeasure()) {
        add("accuracy", Qt::RightDockWidgetArea, {Panel::accuracy, Panel::effects}, 616, 480);
        add("right", Qt::RightDockWidgetArea, {Panel::code, Panel::plots, Panel::parameters}, 371, 340);
        return all;
    }
    add("right", Qt::RightDockWidgetArea,
        {Panel::code, Panel::accuracy, Panel::stability, Panel::plots, Panel::parameters},
        isMeasure ? 560
        : isWide  ? 480
                  : 400,
        340);
    return all;
}

int PanelSizes::separatorWidth() const
{
    return m_layout.window.style()->pixelMetric(QStyle::PM_DockWidgetSeparatorExtent, nullptr,
                                                &m_layout.window);
}

int PanelSizes::railWidth() const
{
    const QDockWidget &lessons = m_layout.docks[Panel::lessons];
    const bool isRail = !lessons.isHidden() && lessons.widget()->maximumWidth() == LearnPanel::railWidth;
    return isRail ? LearnPanel::railWidth + separatorWidth() : 0;
}

void PanelSizes::fit() const
{
    fitWidths();
    fitHeights();
}

void PanelSizes::fitWidths() const
{
    std::vector<Side> all = sides();
    int missing = leastScene.width() + railWidth() - m_layout.window.width();
    for (const Side &side : all)
        missing += side.width + separatorWidth();
    // The right-most columns become narrower first.
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
    m_layout.window.resizeDocks(docks, widths, Qt::Horizontal);
}

int PanelSizes::parameterHeight(int available) const
{
    QDockWidget &parameters = m_layout.docks[Panel::parameters];
    parameters.widget()->updateGeometry(); // else the dock learns only later what it holds
    int wanted = parameters.sizeHint().height();
    if (m_layout.id.mode == WindowMode::measure) { // a plot needs its height; parameters can be scrolled
        const int least = parameters.minimumSizeHint().height();
        const int missing = wanted - (available - readableAccuracy);
        const int rows = // none is cut in two
            std::max(0, missing - ParameterPanel::slack + ParameterRow::height - 1) / ParameterRow::height;
        if (missing > 0)
            wanted = std::max(least, wanted - rows * ParameterRow::height - ParameterPanel::slack);
    }
    return m_layout.store.length(m_layout.id.key(), parametersName, wanted);
}

void PanelSizes::fitHeights() const
{
    const Docks &docks = m_layout.docks;
    const int separator = separatorWidth();
    const int available = m_layout.window.height() - besideColumn - separator;
    const int parameters = parameterHeight(available);
    QDockWidget *above = &docks[docks[Panel::code].isHidden() ? Panel::accuracy : Panel::code];
    if (!docks[Panel::stability].isHidden())
        above = &docks[Panel::stability];
    if (docks[Panel::plots].isHidden() || !hasRoomForPlots(m_layout.window.size())) {
        m_layout.window.resizeDocks({above, &docks[Panel::parameters]},
                                    {std::max(1, available - parameters), parameters}, Qt::Vertical);
        return;
    }
    const int plots = docks[Panel::plots].widget()->sizeHint().height();
    m_layout.window.resizeDocks({above, &docks[Panel::plots], &docks[Panel::parameters]},
                                {std::max(1, available - separator - parameters - plots), plots, parameters},
                                Qt::Vertical);
}

bool PanelSizes::eventFilter(QObject *, QEvent *event)
{
    if (event->type() == QEvent::MouseButtonPress)
        notePress(static_cast<QMouseEvent &>(*event));
    else if (event->type() == QEvent::MouseButtonRelease)
        storeDragged();
    return false;
}

void PanelSizes::notePress(const QMouseEvent &event)
{
    m_besideSeparator.clear();
    if (!m_layout.window.isSeparator(event.position().toPoint()))
        return;
    m_besideSeparator = sides();
    for (Side &side : m_besideSeparator)
        side.width = side.dock->width();
    m_heightBefore = m_layout.docks[Panel::parameters].height();
}

void PanelSizes::storeDragged()
{
    const QString key = m_layout.id.key();
    for (const Side &before : m_besideSeparator) {
        if (before.dock->width() != before.width)
            m_layout.store.chooseLength(key, before.name, before.dock->width());
    }
    const int height = m_layout.docks[Panel::parameters].height();
    if (!m_besideSeparator.empty() && height != m_heightBefore)
        m_layout.store.chooseLength(key, parametersName, height);
    m_besideSeparator.clear();
}

}

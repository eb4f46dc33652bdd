#include "app/ui/dock/rail_choice.h"

#include "app/ui/actions/command.h"
#include "app/ui/dock/panel_sizes.h"

#include <QDockWidget>
#include <QMainWindow>

namespace app {

RailChoice::RailChoice(PanelLayout &layout, LearnPanel &learn, const OpenRun &run, PanelSizes &sizes,
                       Command &toggle)
    : m_layout(layout), m_learn(learn), m_run(run), m_sizes(sizes), m_toggle(toggle)
{
    connect(&toggle, &QAction::triggered, this,
            [this](bool isRail) { choose(isRail ? LearnPanel::Form::rail : LearnPanel::Form::whole); });
    connect(&learn, &LearnPanel::formRequested, this, &RailChoice::choose);
    connect(&learn, &LearnPanel::formChanged, this, &RailChoice::fitDock);
}

void RailChoice::choose(LearnPanel::Form form)
{
    m_layout.store.chooseRail(m_layout.id.key(), form == LearnPanel::Form::rail);
    m_layout.docks[Panel::lessons].show();
    m_learn.setForm(form);
}

void RailChoice::restore()
{
    const bool isUsual = m_layout.id.mode == WindowMode::measure && m_layout.window.width() < wideWindow;
    const bool isRail = m_layout.store.hasRail(m_layout.id.key(), isUsual);
    m_learn.setForm(isRail ? LearnPanel::Form::rail : LearnPanel::Form::whole);
    fitDock();
}

void RailChoice::fitDock()
{
    const bool isSandbox = m_run.isSandbox();
    const bool isRail = m_learn.form() == LearnPanel::Form::rail;
    m_toggle.setChecked(isRail);
    m_toggle.setEnabled(!isSandbox);
    QWidget &content = *m_layout.docks[Panel::lessons].widget();
    const bool wasRail = content.maximumWidth() == LearnPanel::railWidth;
    if (isRail && !isSandbox) {
        content.setFixedWidth(LearnPanel::railWidth);
    } else if (wasRail) {
        content.setMinimumWidth(0);
        content.setMaximumWidth(QWIDGETSIZE_MAX);
        m_sizes.fitWidths();
    }
}

}

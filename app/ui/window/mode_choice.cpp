#include "app/ui/window/mode_choice.h"

#include "app/model/sandbox/sandbox.h"
#include "app/model/session/session.h"
#include "app/ui/actions/command.h"
#include "app/ui/dock/panel_sizes.h"
#include "app/ui/dock/rail_choice.h"
#include "app/ui/dock/window_layouts.h"
#include "app/ui/window/last_step.h"
#include "app/ui/window/left_pages.h"

namespace app {

ModeChoice::ModeChoice(Session &session, WindowLayouts &layouts, RailChoice &rail, const PanelSizes &sizes,
                       LeftPages &pages, Command &build)
    : m_session(session), m_layouts(layouts), m_rail(rail), m_sizes(sizes), m_pages(pages), m_build(build),
      m_visit(session)
{
    session.onChange(ChangeKind::step, this, &ModeChoice::followStep);
    followStep();
}

WindowMode ModeChoice::mode() const
{
    return m_layouts.mode();
}

void ModeChoice::choose(WindowMode mode)
{
    if (mode == m_layouts.mode())
        return;
    m_layouts.setMode(mode);
    if (mode == WindowMode::build)
        m_visit.go();
    else if (mode == WindowMode::learn)
        m_visit.comeBack();
    m_sizes.fitHeights();
}

void ModeChoice::restore(WindowMode mode, const LastStep &last)
{
    m_visit.comeBackTo(last.lesson, last.step);
    m_layouts.setMode(mode); // the session is there already
    m_sizes.fitHeights();
}

void ModeChoice::followStep()
{
    const bool isSandbox = m_session.isSandbox();
    isSandbox ? m_pages.showTools() : m_pages.showLessons();
    m_rail.fitDock();
    m_build.setEnabled(sandboxOf(m_session.library()));
    m_visit.note();
    if (m_layouts.mode() != WindowMode::measure)
        m_layouts.setMode(isSandbox ? WindowMode::build : WindowMode::learn);
}

}

#pragma once

#include "app/model/sandbox/sandbox_visit.h"
#include "app/ui/dock/window_mode.h"

#include <QObject>

namespace app {

class Command;
class LeftPages;
class PanelSizes;
class RailChoice;
class WindowLayouts;
struct LastStep;

/// Keeps the mode of the window and the open step in agreement: in the build mode a sandbox is open, and the learn mode
/// leaves it.
class ModeChoice : public QObject
{
    Q_OBJECT

public:
    /// `build` chooses the build mode. All arguments must outlive it.
    ModeChoice(Session &session, WindowLayouts &layouts, RailChoice &rail, const PanelSizes &sizes,
               LeftPages &pages, Command &build);

    /// Arranges the window for a mode, and opens or leaves the sandbox.
    void choose(WindowMode mode);
    /// Arranges the window for the mode of an earlier window on the same session, in which `last` was the last step of a
    /// lesson.
    void restore(WindowMode mode, const LastStep &last);
    WindowMode mode() const;

    /// Shows the lessons or the tools of the sandbox, and chooses the mode to match.
    void followStep();

private:
    Session &m_session;
    WindowLayouts &m_layouts;
    RailChoice &m_rail;
    const PanelSizes &m_sizes;
    LeftPages &m_pages;
    Command &m_build;
    SandboxVisit m_visit;
};

}

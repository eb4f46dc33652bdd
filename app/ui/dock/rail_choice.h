#pragma once

#include "app/ui/dock/panel_layout.h"
#include "app/ui/learn/learn_panel.h"

namespace app {

class PanelSizes;

/// Shows the lessons as a narrow rail or as the whole list, as the learner chose for the layout in use.
class RailChoice : public QObject
{
    Q_OBJECT

public:
    /// `toggle` switches between both. All arguments must outlive it.
    RailChoice(PanelLayout &layout, LearnPanel &learn, const OpenRun &run, PanelSizes &sizes,
               Command &toggle);

    void choose(LearnPanel::Form form);
    /// Takes the form that was stored for the layout in use.
    void restore();
    /// Gives the dock of the lessons the width of their form. In a sandbox its tools replace the lessons.
    void fitDock();

private:
    PanelLayout &m_layout;
    LearnPanel &m_learn;
    const OpenRun &m_run;
    PanelSizes &m_sizes;
    Command &m_toggle;
};

}

#pragma once

#include "app/ui/dock/panel_layout.h"

namespace app {

/// Places the plots: between code and parameters if there is room, else as a tab beside the code, or beside
/// accuracy in the measure mode. Plots that the learner has moved to another side stay there.
class PlotsDock
{
public:
    /// `layout` must outlive it.
    explicit PlotsDock(PanelLayout &layout) : m_layout(layout) {}

    /// Shows the plots or hides them, from now on.
    void show(bool isShown) const;
    void arrange() const;
    /// Returns whether the learner wants to see plots.
    static bool isWanted();

private:
    PanelLayout &m_layout;
};

}

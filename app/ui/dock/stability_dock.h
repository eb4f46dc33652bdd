#pragma once

#include "app/ui/dock/panel_layout.h"

namespace app {

class PanelSizes;

/// Shows the stability panel in place of code or accuracy. Scene, parameters and lessons stay.
class StabilityDock : public QObject
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    StabilityDock(PanelLayout &layout, const PanelSizes &sizes) : m_layout(layout), m_sizes(sizes) {}

    void show();
    /// Hides the panel, and shows again what it replaced.
    void hide();

signals:
    /// Emitted whenever show() or hide() was called, so that buttons can follow.
    void shownChanged(bool isShown);
    /// The panel was open, and is hidden now.
    void closed();

private:
    /// Chooses what the stability panel replaces, unless something is hidden for it already.
    void chooseReplaced();

    PanelLayout &m_layout;
    const PanelSizes &m_sizes;
    QDockWidget *m_replaced = nullptr; ///< hidden while stability is shown
};

}

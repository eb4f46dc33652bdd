#pragma once

#include "app/ui/dock/docks.h"
#include "app/ui/dock/layout_store.h"
#include "app/ui/dock/window_mode.h"

#include <QByteArray>
#include <QSize>

class QMainWindow;

namespace app {

/// The minimum size of the scene, px. The scene becomes smaller only when hiding panels is not enough.
constexpr QSize leastScene{480, 220};
/// The minimum size of the window, px.
constexpr QSize leastWindow{480, 420};
/// The window width, px, from which lessons, accuracy and code fit side by side.
constexpr int wideWindow = 1600;

/// Names a layout: there is one for each mode, and two for measuring.
struct LayoutId
{
    WindowMode mode = WindowMode::learn;
    bool isWide = false; ///< whether the window was wide when the layout came into use

    /// Returns the key of the layout in the settings.
    QString key() const;
    bool isWideMeasure() const { return mode == WindowMode::measure && isWide; }
};

/// The panels of a window and the layout in use. The classes that arrange the panels share it.
struct PanelLayout
{
    explicit PanelLayout(QMainWindow &owner) : window(owner), docks(owner) {}

    QMainWindow &window;
    Docks docks;
    LayoutStore store;
    LayoutId id;
    QByteArray first; ///< the layout of a new window
};

/// Returns whether a window of this size has room for plots between code and parameters.
bool hasRoomForPlots(QSize window);

}

#pragma once

#include "app/ui/dock/panel_layout.h"

#include <QByteArray>

#include <optional>

namespace app {

class DockFitter;
class PanelSizes;
class PlotsDock;
class RailChoice;

/// Arranges the panels for the mode of the window. Each mode has its own layout, which is stored. The panels share the
/// room again whenever the window changes its size.
class WindowLayouts : public QObject
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    WindowLayouts(PanelLayout &layout, DockFitter &fitter, const PanelSizes &sizes, const PlotsDock &plots,
                  RailChoice &rail);

    WindowMode mode() const { return m_layout.id.mode; }
    void setMode(WindowMode mode);
    /// Restores the layout of the mode in use, in a window that has just been made.
    void restoreAtStart();
    /// Puts the panels back to their first places, in the mode in use.
    void reset();
    /// Writes all layouts to the settings.
    void save();

    /// Hides all panels, until showAll().
    void hideAll();
    void showAll();

    bool eventFilter(QObject *window, QEvent *event) override;

signals:
    /// Panels are about to be arranged in another way. What is shown only for a while has to go first.
    void aboutToArrange();
    void modeChanged(WindowMode mode);

private:
    LayoutId idFor(WindowMode mode) const;
    /// Keeps the layout in use for its mode.
    void store();
    /// Works like QMainWindow::restoreState(), also while the window has not been laid out yet.
    bool restore(const QByteArray &state);
    void useStored(WindowMode before);
    void arrangeForMeasuring();

    PanelLayout &m_layout;
    DockFitter &m_fitter;
    const PanelSizes &m_sizes;
    const PlotsDock &m_plots;
    RailChoice &m_rail;
    bool m_isArranged = false;          ///< false until a layout is in use
    std::optional<QByteArray> m_hidden; ///< the layout that showAll() restores
};

}

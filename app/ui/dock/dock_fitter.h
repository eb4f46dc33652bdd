#pragma once

#include "app/ui/dock/panel_layout.h"

#include <QObject>
#include <QSize>

#include <vector>

namespace app {

class LearnPanel;
class SceneView;

/// Fits the panels into the window. If the window is too small for all open panels, it hides the less
/// important ones and shows them again later.
class DockFitter : public QObject
{
    Q_OBJECT

public:
    /// All arguments must outlive it.
    DockFitter(PanelLayout &layout, LearnPanel &learn, SceneView &scene);

    /// Hides panels until the others fit into the window. Shows hidden panels again if they fit, or if the
    /// learner has asked for them meanwhile.
    void share();
    /// Shows all hidden panels again, whether they fit or not.
    void bringAllBack();

signals:
    /// Panels were hidden or shown again, so the others have other lengths to share.
    void sidesChanged();

private:
    /// The ways to save room while the window is too small, in the order in which they are tried. `numbers` hides
    /// measures and parameters, before the others beside the scene.
    enum class Way { rail, below, smallScene, numbers, right, left };

    /// One way that was used, and what it takes to undo it.
    struct Aside
    {
        Way way;
        std::vector<QDockWidget *> panels; ///< the panels that it hid
        QSize least;                       ///< px, the window size needed to undo it
    };

    QSize leastSize();
    bool isShort();
    void bringBackWhatFits();
    void letStepAside(std::vector<QDockWidget *> requested);
    /// Saves room in this `way`, but keeps the `requested` panels. Returns whether that helps.
    bool stepAside(Way way, const std::vector<QDockWidget *> &requested);
    /// Returns the panels that `way` hides, without the `requested` ones. The front tab comes last.
    std::vector<QDockWidget *> panelsFor(Way way, const std::vector<QDockWidget *> &requested) const;
    /// Returns the hidden panels that the learner has shown again, and stops tracking them.
    std::vector<QDockWidget *> takeRequested();
    void bringBack(const Aside &aside);
    Aside bringLastBack();

    QMainWindow &m_window;
    LearnPanel &m_learn;
    SceneView &m_scene;
    QDockWidget &m_lessons; ///< the dock of `learn`
    QDockWidget &m_numbers; ///< the dock of measures and parameters
    QDockWidget &m_code;
    std::vector<Aside> m_aside; ///< the most recent one last
};

}

#pragma once

#include "app/ui/dock/panel_layout.h"

#include <QObject>

#include <vector>

class QMouseEvent;

namespace app {

/// Gives the panels beside the scene their widths and heights: those that the learner chose by dragging a
/// separator, else those that suit the window.
class PanelSizes : public QObject
{
public:
    /// `layout` must outlive it.
    explicit PanelSizes(PanelLayout &layout);

    void fit() const;
    void fitWidths() const;
    /// Gives the parameters the height that they need, and the panels above them the rest.
    void fitHeights() const;

    bool eventFilter(QObject *window, QEvent *event) override;

private:
    /// A column of panels beside the scene.
    struct Side
    {
        QDockWidget *dock; ///< one of its panels
        const char *name;  ///< in the settings
        int width;         ///< px
        int least;         ///< px, if the scene needs the room
    };

    /// Handles a mouse press in the window. On a separator, the sizes of the panels beside it are noted.
    void notePress(const QMouseEvent &event);
    /// Handles the release: stores the sizes that have changed since the press.
    void storeDragged();
    std::vector<Side> sides() const;
    /// Returns the width of the rail of lessons with its separator, or 0 if there is no rail, px.
    int railWidth() const;
    int separatorWidth() const;
    int parameterHeight(int available) const;

    PanelLayout &m_layout;
    std::vector<Side> m_besideSeparator; ///< the columns at the time of the press
    int m_heightBefore = 0;              ///< px, of the parameters at the time of the press
};

}

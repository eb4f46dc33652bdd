#pragma once

#include <QRect>

class QWidget;

namespace app {

/// Keeps where a window stands from one start to the next, in px of the screen: the window stands in the same place at
/// every size of text and controls.
class PlaceKeeper
{
public:
    /// `window` must outlive it.
    explicit PlaceKeeper(QWidget &window) : m_window(window) {}

    /// Puts the window where it was kept, before it is shown. The screen may be smaller now: the window and its frame are
    /// inside the screen. Returns false where nothing was kept.
    bool restore();
    /// Keeps where the window stands. Where nobody has moved it since restore(), what was kept before stays: rounding and
    /// frames do not add up.
    void keep();

private:
    bool isWherePut() const;

    QWidget &m_window;
    QRect m_put; ///< by restore(), without the frame
};

/// The rectangle inside `room` that is nearest to `wanted`, with room for a frame of these margins.
QRect insideScreen(QRect wanted, const QMargins &frame, const QRect &room);

}

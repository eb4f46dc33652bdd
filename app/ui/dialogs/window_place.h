#pragma once

#include <QRect>

class QWidget;

namespace app {

/// Stores the place of a window from one program start to the next, in physical screen pixels. The place is
/// therefore the same at every interface scale.
class WindowPlace
{
public:
    /// `window` must outlive it.
    explicit WindowPlace(QWidget &window) : m_window(window) {}

    /// Moves the window to its stored place before it is shown. The window and its frame stay inside the
    /// screen, which may be smaller now. Returns false if no place was stored.
    bool restore();
    /// Stores the place of the window. If it has not moved since restore(), the stored place is kept, so that
    /// rounding and frames do not add up.
    void keep();

private:
    bool isWherePut() const;

    QWidget &m_window;
    QRect m_put; ///< by restore(), px, without the frame
};

/// Returns the rectangle inside `room` that is nearest to `wanted`, with room for a frame with these margins.
QRect insideScreen(QRect wanted, const QMargins &frame, const QRect &room);

}

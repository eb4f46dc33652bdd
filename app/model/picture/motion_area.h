#pragma once

#include "lessons/api/view/view.h"
#include "sim/run/track.h"

#include <QRectF>

#include <memory>

namespace app {

/// Returns the box of everything drawn of a scene in `state`, in px of the scene. It contains bodies with their
/// radius, and the branches of a tree. In trees with more than 2,000 branches, the outermost twigs may extend
/// beyond it.
QRectF subjectBox(const lessons::View &view, const sim::State &state);

/// Returns the x position of a camera that follows a body in `state`, in px of the scene. Returns 0 if the view
/// follows no body.
double followedX(const lessons::View &view, const sim::State &state);

/// A measurement of the area that a run covers. It computes the run from its start and collects the box of all its
/// moments. It works in slices, so that a window stays responsive.
class MotionArea
{
public:
    /// Measures the frames `from` to `to` of `script`, drawn with the view `view`.
    /// @throws sim::Error: scene and method do not fit
    MotionArea(const sim::Script &script, std::shared_ptr<const lessons::View> view, std::int64_t from,
               std::int64_t to);

    /// Continues for about `milliseconds`. Returns whether all frames are measured, or the run has ended.
    bool goOn(qint64 milliseconds);
    /// Returns the box of the moments measured so far, in px of the scene. If the view follows a body, the box is
    /// relative to followedX().
    QRectF area() const { return m_area; }
    /// Returns the last computed frame.
    std::int64_t frame() const { return m_track.cursor().frame; }

private:
    void add();

    sim::Track m_track;
    std::shared_ptr<const lessons::View> m_view;
    std::int64_t m_from;
    std::int64_t m_to;
    QRectF m_area;
};

}

#pragma once

#include "lessons/api/view/view.h"
#include "sim/run/track.h"

#include <QRectF>

#include <memory>

namespace app {

/// Returns the box of all that is drawn of a scene in `state`, in px of the scene: bodies with their radius, and the
/// branches of a tree. Of trees with more than 2,000 branches the outermost twigs may reach out of it.
QRectF subjectBox(const lessons::View &look, const sim::State &state);

/// Returns where a camera that follows a body stands in `state`, in px of the scene: 0 where the look follows none.
double followedX(const lessons::View &look, const sim::State &state);

/// A measure of how far a run moves: it computes the run from its start and collects the box of all its moments. It
/// works in slices, so that a window can go on meanwhile.
class MotionArea
{
public:
    /// Measures the frames `from` to `to` of `script`, drawn as `look` says.
    /// @throws sim::Error when scene and method do not fit
    MotionArea(const sim::Script &script, std::shared_ptr<const lessons::View> look, std::int64_t from,
               std::int64_t to);

    /// Computes on for about `milliseconds`. Returns whether all frames are measured, or the run has ended.
    bool goOn(qint64 milliseconds);
    /// Returns the box of the moments measured so far, in px of the scene; of a look that follows a body relative to
    /// followedX().
    QRectF area() const { return m_area; }
    /// Returns the last frame that was computed.
    std::int64_t frame() const { return m_track.cursor().frame; }

private:
    void add();

    sim::Track m_track;
    std::shared_ptr<const lessons::View> m_look;
    std::int64_t m_from;
    std::int64_t m_to;
    QRectF m_area;
};

}

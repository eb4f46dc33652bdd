#pragma once

#include "app/ui/scene/drawing/canvas.h"

#include <optional>

namespace app {

/// Drags bodies with the mouse pointer: takes hold of a body, moves it and releases it.
class BodyDrag
{
public:
    explicit BodyDrag(Playback &playback, UserInput &input) : m_playback(playback), m_input(input) {}

    /// Returns the body under `place`: within its disc or within 12 screen px. Returns the nearest of several, or the
    /// one that covers it, or -1.
    static int bodyAt(const SceneContent &shown, const Camera &camera, QPointF place);

    /// Selects the body. While the run plays, this takes hold of it at once. While the run is paused, only dragging
    /// takes hold, so a click selects and changes nothing. At the start or the end of the run, dragging also starts
    /// time.
    void press(const QString &body, sim::Vec2 where, sim::Vec2 place, QPointF pointer);
    /// Moves the body with the pointer, which is at `place` in the scene.
    void carry(sim::Vec2 place, QPointF pointer);
    void release();

    /// Returns whether the mouse button is down on a body.
    bool isDown() const { return m_body.has_value(); }

private:
    Playback &m_playback;
    UserInput &m_input;
    std::optional<QString> m_body;
    sim::Vec2 m_offset; ///< from the pointer to the centre of the body, px
    QPointF m_pressed;  ///< on the screen
    bool m_holds = false;
};

}

#pragma once

#include "app/ui/scene/canvas.h"

#include <optional>

namespace app {

/// The pointer as a hand: it takes hold of a body, carries it and lets go.
class Hand
{
public:
    explicit Hand(Session &session) : m_session(session) {}

    /// The body under `place`: within its disc or 12 px of the screen; the nearest if there are several, or -1.
    static int bodyAt(const Shown &shown, const Camera &camera, QPointF place);

    /// Selects the body, and takes hold of it at once while the run plays. While it stands, only carrying
    /// takes hold, so that a click selects and changes nothing; at the start and at the end of the run that starts time.
    void press(const QString &body, sim::Vec2 where, sim::Vec2 place, QPointF pointer);
    /// Carries the body to where the pointer is, at `place` in the scene.
    void carry(sim::Vec2 place, QPointF pointer);
    void letGo();

    /// Whether the button is down on a body.
    bool isDown() const { return m_body.has_value(); }

private:
    Session &m_session;
    std::optional<QString> m_body;
    sim::Vec2 m_offset; ///< from the pointer to the middle of the body, px
    QPointF m_pressed;  ///< on the screen
    bool m_holds = false;
};

}

#pragma once

#include "app/ui/scene/canvas.h"

#include <QKeyEvent>

#include <optional>

namespace app {

/// What the pointer and the keys do in steps whose scenes let more in than a hand: they blow, steer, or set targets.
class Tools
{
public:
    explicit Tools(Session &session) : m_session(session) {}

    /// Whether a press at `place`, on no body or on the one that the pointer carries, is the scene's: the pointer
    /// is down then, or a target is set.
    bool press(sim::Vec2 place);
    void moveTo(sim::Vec2 place);
    /// The pointer's button comes up, and all keys.
    void letUp();
    bool isPointing() const { return m_pointing; }

    /// Whether an arrow key steers now: while the run plays, in a step that knows keys.
    bool wants(const QKeyEvent &key) const;
    /// A key goes down or up. Returns whether it was one of these.
    bool key(const QKeyEvent &key, bool down);
    /// Moves the pointer (or the target) by keys, from where it is or, before the first time, from `middle`.
    /// Returns whether the step has one.
    bool nudge(sim::Vec2 by, sim::Vec2 middle);
    /// The pointer's button by the keyboard: down if it was up. Returns whether the step has a pointer.
    bool togglePointer(sim::Vec2 middle);
    /// Returns whether the scene has a use for the pointer or for targets.
    bool any() const;

private:
    /// Returns whether the step accepts this input and an effect of its scene, as it is now, reads it.
    bool can(lessons::Interaction what) const;
    sim::Vec2 pointer(sim::Vec2 middle) const;
    bool isDown() const;

    Session &m_session;
    bool m_pointing = false;
};

}

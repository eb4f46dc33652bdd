#pragma once

#include "app/ui/scene/drawing/canvas.h"

#include <QKeyEvent>

#include <optional>

namespace app {

/// Handles pointer and keys in steps whose scenes accept more input than dragging: wind, steering, or targets.
class Tools
{
public:
    explicit Tools(const OpenRun &run, Playback &playback, UserInput &input)
        : m_run(run), m_playback(playback), m_input(input)
    {
    }

    /// Handles a press at `place`, on no body or on the one that the pointer carries. Returns whether the scene uses it:
    /// the pointer is down then, or a target is set.
    bool press(sim::Vec2 place);
    void moveTo(sim::Vec2 place);
    /// Releases the pointer's button and all keys.
    void release();
    bool isPointing() const { return m_pointing; }

    /// Returns whether an arrow key steers now: while the run plays, in a step that accepts keys.
    bool wants(const QKeyEvent &key) const;
    /// Handles a key that is pressed or released. Returns whether it steers.
    bool key(const QKeyEvent &key, bool down);
    /// Moves the pointer or the target by `by`. A pointer that has not been used yet starts at `middle`.
    /// Returns whether the step has a pointer or a target.
    bool nudge(sim::Vec2 by, sim::Vec2 middle);
    /// Toggles the pointer's button by the keyboard. Returns whether the step has a pointer.
    bool togglePointer(sim::Vec2 middle);
    /// Returns whether the scene uses the pointer or targets.
    bool any() const;

private:
    /// Returns whether the step accepts this input and an effect of its scene, as it is now, reads it.
    bool can(lessons::Interaction what) const;
    sim::Vec2 pointer(sim::Vec2 middle) const;
    bool isDown() const;

    const OpenRun &m_run;
    Playback &m_playback;
    UserInput &m_input;
    bool m_pointing = false;
};

}

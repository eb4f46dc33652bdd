#pragma once

#include "app/model/learning/prediction_desk.h"
#include "app/ui/scene/drawing/canvas.h"

#include <QKeyEvent>

namespace app {

/// Takes the place that a learner predicts, by mouse and keys, and draws it.
class PlacePicker
{
public:
    /// Takes places for `desk`, which must outlive this object.
    void attach(PredictionDesk &desk) { m_desk = &desk; }

    /// Returns whether a place is being chosen: bodies cannot be dragged then.
    bool isPicking() const { return m_desk && m_desk->picking(); }
    /// Moves the cross to `at`, px.
    void place(sim::Vec2 at);
    /// Returns whether this key is for the cross.
    bool wants(const QKeyEvent &key) const;
    /// Handles a key that wants() returns true for: arrows move the cross by 10 px, with Shift by 1 px; Enter commits; Esc
    /// stops.
    void press(const QKeyEvent &key);

    /// Draws the predicted place and, after the run, the true one and the distance.
    void draw(const Canvas &canvas) const;
    /// Returns what draw() shows, in words for screen readers; may be empty.
    QString words() const;

private:
    PredictionDesk *m_desk = nullptr;
};

}

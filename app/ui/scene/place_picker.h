#pragma once

#include "app/model/learning/prediction_desk.h"
#include "app/ui/scene/drawing/label_places.h"
#include "app/ui/scene/drawing/overlay_labels.h"

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

    /// Returns whether there is a predicted place to draw.
    bool isMarked() const { return m_desk && m_desk->mark(); }
    /// Draws the predicted place and, after the run, the true one and the distance, in one of `places`. The line between
    /// the two places leaves `texts` free.
    void draw(const Canvas &canvas, const LabelPlaces &places, const std::vector<QRectF> &texts) const;
    /// Returns what draw() shows, in words for screen readers; may be empty.
    QString words() const;

private:
    PredictionDesk *m_desk = nullptr;
};

/// Returns the line from a predicted place to the true one, screen px, with a gap at each of the boxes `texts`.
std::vector<QLineF> predictionLines(const PredictionDesk::PlaceMark &mark, const Camera &camera,
                                    const std::vector<QRectF> &texts);

/// Returns the label beside a predicted place whose true place is known. It is in one of `places`, within `area`, and also
/// avoids the marks of the two places. `font` is that of labels.
OverlayLabel predictionLabel(const PredictionDesk::PlaceMark &mark, const Camera &camera, const QRectF &area,
                             LabelPlaces places, const QFont &font);

}

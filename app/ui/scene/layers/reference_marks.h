#pragma once

#include "app/ui/scene/drawing/canvas.h"
#include "sim/analysis/accuracy/study.h"

namespace app {

/// Returns the exact positions of the points of `shown` at `frame`, by the reference of `accuracy`. Empty if
/// the reference does not reach that frame.
std::optional<ReferencePlaces> referencePlaces(const SceneContent &shown, const sim::Accuracy &accuracy,
                                               std::int64_t frame);

/// Returns a sentence such as "3.4 px off the reference here".
QString referenceSentence(const ReferencePlaces &reference);
/// Returns the box in `area` for the distance to the reference: beside the body with the largest distance. Avoids the
/// boxes in `taken`. Empty if there is nothing to tell.
QRectF referenceLabelBox(const SceneContent &shown, const Camera &camera, QRectF area,
                         std::vector<QRectF> taken);
/// Draws the distance to the reference in its box.
void drawReferenceLabel(QPainter &painter, const SceneContent &shown, const Theme &theme, QRectF box);
/// Draws the reference's symbol for the legend.
void drawReferenceMark(QPainter &painter, const Theme &theme, QPointF centre);

}

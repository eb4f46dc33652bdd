#pragma once

#include "app/ui/scene/canvas.h"
#include "sim/analysis/accuracy/study.h"

namespace app {

/// Where the exact solution of `accuracy` has the points of `shown` at `frame`; nothing where it does not reach.
std::optional<ReferencePlaces> referencePlaces(const Shown &shown, const sim::Accuracy &accuracy,
                                               std::int64_t frame);

/// "3.4 px off the reference here".
QString referenceSentence(const ReferencePlaces &reference);
/// Writes it beside the body that is farthest off, clear of `taken`.
void drawReferenceLabel(QPainter &painter, const Shown &shown, const Theme &theme, const Camera &camera,
                        QRectF area, std::vector<QRectF> taken);
/// The legend's mark.
void drawReferenceMark(QPainter &painter, const Theme &theme, QPointF centre);

}

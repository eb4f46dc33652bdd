#include "app/ui/scene/layers/reference_marks.h"

#include "app/model/text/accuracy_text.h"
#include "app/ui/scene/drawing/label_places.h"
#include "app/ui/scene/layers/layers.h"

#include <QCoreApplication>

#include <cmath>

namespace app {

namespace {

struct ReferenceMarksText
{
    Q_DECLARE_TR_FUNCTIONS(ReferenceMarksText)
};

constexpr double lineWidth = 1.6;
constexpr double leastGap = 1.5; ///< screen px; shorter distances have no line

QPen outline(const Theme &theme)
{
    return dashed(theme.tokens().ink2, lineWidth, {2.5, 2.5});
}

}

std::optional<ReferencePlaces> referencePlaces(const SceneContent &shown, const sim::Accuracy &accuracy,
                                               std::int64_t frame)
{
    const auto &frames = accuracy.reference.trajectories;
    if (frame < 0 || frame > accuracy.horizon || frame >= static_cast<std::int64_t>(frames.size()))
        return std::nullopt;
    ReferencePlaces found;
    found.places = frames[static_cast<std::size_t>(frame)];
    if (static_cast<int>(found.places.size()) != shown.points())
        return std::nullopt;
    found.uncertainty = accuracy.reference.disagreement;
    for (int i = 0; i < shown.points(); ++i) {
        const double away =
            sim::length(shown.state().positionOf(i) - found.places[static_cast<std::size_t>(i)]);
        if (!shown.isHidden(i) && (found.farthest < 0 || away > found.distance)) {
            found.farthest = i;
            found.distance = away;
        }
    }
    return found;
}

QString referenceSentence(const ReferencePlaces &reference)
{
    return ReferenceMarksText::tr("%1 off the reference here").arg(pixels(reference.distance));
}

void drawReference(const Canvas &canvas)
{
    const SceneContent &shown = canvas.shown;
    if (!shown.reference || !shown.extras.reference)
        return;
    QPainter &p = canvas.painter;
    for (int i = 0; i < shown.points(); ++i) {
        if (shown.isHidden(i))
            continue;
        const QPointF place = canvas.camera.at(shown.reference->places[static_cast<std::size_t>(i)]);
        const QPointF body = canvas.camera.at(shown.state().positionOf(i));
        const double radius = canvas.camera.radius(shown.radius(i));
        if (canvas.reaches(place, radius)) {
            p.setPen(outline(canvas.theme));
            p.setBrush(Qt::NoBrush);
            p.drawEllipse(place, radius, radius);
        }
        if (std::hypot(place.x() - body.x(), place.y() - body.y()) >= leastGap) {
            p.setPen(QPen(canvas.tokens().past, 2.0, Qt::SolidLine, Qt::RoundCap));
            p.drawLine(canvas.cut(body, place));
        }
    }
}

QRectF referenceLabelBox(const SceneContent &shown, const Camera &camera, QRectF area,
                         std::vector<QRectF> taken)
{
    if (!shown.reference || !shown.extras.reference || shown.reference->farthest < 0 ||
        shown.reference->distance <= 0.0)
        return {};
    const QFontMetricsF metrics(shown.text);
    const QPointF body = camera.at(shown.state().positionOf(shown.reference->farthest));
    const double radius = camera.radius(shown.radius(shown.reference->farthest));
    return LabelPlaces(std::move(taken))
        .within(area, body + QPointF(radius + 10.0, radius + 4.0),
                {metrics.horizontalAdvance(referenceSentence(*shown.reference)) + 16.0, 22.0});
}

void drawReferenceLabel(QPainter &painter, const SceneContent &shown, const Theme &theme, QRectF box)
{
    if (box.isEmpty())
        return;
    painter.setPen(QPen(theme.tokens().line2, 1.0));
    painter.setBrush(theme.tokens().scene);
    painter.drawRoundedRect(box, 5.0, 5.0);
    painter.setBrush(Qt::NoBrush);
    painter.setFont(shown.text);
    painter.setPen(theme.tokens().ink);
    painter.drawText(box, Qt::AlignCenter, referenceSentence(*shown.reference));
}

void drawReferenceMark(QPainter &painter, const Theme &theme, QPointF centre)
{
    painter.setPen(outline(theme));
    painter.setBrush(Qt::NoBrush);
    painter.drawEllipse(centre, 5.0, 5.0);
}

}

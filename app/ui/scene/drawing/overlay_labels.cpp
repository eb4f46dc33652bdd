#include "app/ui/scene/drawing/overlay_labels.h"

#include "app/ui/scene/drawing/label_places.h"
#include "app/ui/scene/hud/free_area.h"
#include "lessons/api/view/view.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {

namespace {

using lessons::Overlay;

constexpr double smallestArc = 22.0;
constexpr double outsideBody = 12.0;
constexpr double pullGap = 8.0;
constexpr double shortestPull = 3.0;   ///< px; a shorter arrow is invisible, so it needs no name
constexpr double largestRing = 4000.0; ///< screen px; a larger ring looks like a line in any view
constexpr int piecesOfRing = 48;

/// Returns the radius of the body at `place`, screen px; 0 if there is none.
double bodyAt(const SceneContent &shown, const Camera &camera, sim::Vec2 place)
{
    for (int i = 0; i < shown.points(); ++i) {
        if (!shown.isHidden(i) && shown.state().positionOf(i) == place)
            return camera.radius(shown.radius(i));
    }
    return 0.0;
}

QPointF pullVector(const Overlay &overlay, const SceneContent &shown)
{
    return unitArrow / shown.scales.pull.unit * QPointF(overlay.b.x, overlay.b.y);
}

bool isTooShort(const Overlay &overlay, const SceneContent &shown)
{
    const QPointF vector = pullVector(overlay, shown);
    return overlay.shape == Overlay::Shape::arrow && std::hypot(vector.x(), vector.y()) < shortestPull;
}

QPointF pullStart(const Overlay &overlay, const SceneContent &shown, const Camera &camera)
{
    const QPointF vector = pullVector(overlay, shown);
    const double length = std::hypot(vector.x(), vector.y());
    const double away = length > 0.0 ? (bodyAt(shown, camera, overlay.a) + pullGap) / length : 0.0;
    return camera.at(overlay.a) + away * vector;
}

void addArc(std::vector<QLineF> &strokes, QPointF centre, double radius, double angle)
{
    QPointF from = centre + QPointF(radius, 0.0);
    const int pieces =
        std::max(1, static_cast<int>(piecesOfRing * std::abs(angle) / (2.0 * std::numbers::pi)));
    for (int i = 1; i <= pieces; ++i) {
        const double turned = angle * i / pieces;
        const QPointF to = centre + radius * QPointF(std::cos(turned), std::sin(turned));
        strokes.emplace_back(from, to);
        from = to;
    }
}

void addStrokes(std::vector<QLineF> &strokes, const Overlay &overlay, const SceneContent &shown,
                const Camera &camera)
{
    const QPointF a = camera.at(overlay.a);
    switch (overlay.shape) {
    case Overlay::Shape::cross:
        strokes.insert(strokes.end(), {QLineF(a - QPointF(crossArm, 0), a + QPointF(crossArm, 0)),
                                       QLineF(a - QPointF(0, crossArm), a + QPointF(0, crossArm))});
        break;
    case Overlay::Shape::ring:
        addArc(strokes, a, ringRadius(overlay, camera), 2.0 * std::numbers::pi);
        break;
    case Overlay::Shape::arrow: {
        const QPointF from = pullStart(overlay, shown, camera);
        strokes.emplace_back(from, from + pullVector(overlay, shown));
        break;
    }
    case Overlay::Shape::line:
        strokes.emplace_back(a, camera.at(overlay.b));
        break;
    case Overlay::Shape::angle:
        strokes.emplace_back(a, a + QPointF(arcRadius(overlay, shown, camera) + beyondArc, 0.0));
        addArc(strokes, a, arcRadius(overlay, shown, camera), overlay.size);
        break;
    case Overlay::Shape::wind:
        break;
    }
}

/// Returns the position to label for an overlay.
QPointF anchorOf(const Overlay &overlay, const SceneContent &shown, const Camera &camera)
{
    const QPointF a = camera.at(overlay.a);
    switch (overlay.shape) {
    case Overlay::Shape::cross:
        return a;
    case Overlay::Shape::ring:
        return a + ringRadius(overlay, camera) * std::numbers::sqrt2 / 2 * QPointF(1.0, -1.0);
    case Overlay::Shape::arrow:
        return pullStart(overlay, shown, camera) + pullVector(overlay, shown);
    case Overlay::Shape::line:
        return (a + camera.at(overlay.b)) / 2;
    case Overlay::Shape::angle:
        return a + (arcRadius(overlay, shown, camera) + 6.0) *
                       QPointF(std::cos(overlay.size / 2), std::sin(overlay.size / 2));
    case Overlay::Shape::wind:
        break;
    }
    return a;
}

}

double ringRadius(const Overlay &overlay, const Camera &camera)
{
    return std::min(overlay.size * camera.zoom, largestRing);
}

double arcRadius(const Overlay &overlay, const SceneContent &shown, const Camera &camera)
{
    return std::max(smallestArc, bodyAt(shown, camera, overlay.a) + outsideBody);
}

Arrow overlayArrow(const Overlay &overlay, const SceneContent &shown, const Camera &camera,
                   const Theme &theme)
{
    return {pullStart(overlay, shown, camera), pullVector(overlay, shown), {theme.tokens().ink2, 2.0}};
}

std::vector<QLineF> explainingStrokes(const SceneContent &shown, const Camera &camera, const Theme &theme)
{
    std::vector<QLineF> strokes;
    for (const std::vector<Arrow> &arrows :
         {pullArrows(shown, camera, theme), velocityArrows(shown, camera, theme)}) {
        for (const Arrow &arrow : arrows)
            strokes.emplace_back(arrow.from, arrow.from + arrow.vector);
    }
    if (!shown.extras.overlays)
        return strokes;
    for (const Overlay &overlay : shown.picture.overlays)
        addStrokes(strokes, overlay, shown, camera);
    return strokes;
}

QString shownTitle(const SceneContent &shown, const Camera &camera)
{
    return QFontMetricsF(shown.figures)
        .elidedText(shown.name, Qt::ElideRight, shown.view().stage.width() * camera.zoom);
}

QRectF titleBox(const SceneContent &shown, const Camera &camera)
{
    if (shown.name.isEmpty() || shown.points() == 0)
        return {};
    const QRectF stage = shown.view().stage;
    const QFontMetricsF metrics(shown.figures);
    const double width = metrics.horizontalAdvance(shownTitle(shown, camera));
    const QPointF top = camera.at({stage.center().x(), stage.top()});
    return {top - QPointF(width / 2.0, 0.0), QSizeF(width, metrics.height())};
}

std::vector<OverlayLabel> overlayLabels(const SceneContent &shown, const Camera &camera, const Theme &theme,
                                        QRectF area)
{
    std::vector<OverlayLabel> labels;
    if (!shown.extras.overlays)
        return labels;
    const QFontMetricsF metrics(shown.text);
    std::vector<QRectF> taken = bodyBoxes(shown, camera);
    // Not nameBox(), which jumps from pixel to pixel while the body moves less. Labels would jump with it, to and fro.
    taken.push_back(namePlace(shown, camera, area));
    taken.push_back(shown.card);
    LabelPlaces places(std::move(taken), explainingStrokes(shown, camera, theme));
    for (const Overlay &overlay : shown.picture.overlays) {
        const QPointF anchor = anchorOf(overlay, shown, camera);
        if (overlay.label.isEmpty() || !area.contains(anchor) || isTooShort(overlay, shown))
            continue;
        const QSizeF size(metrics.horizontalAdvance(overlay.label), metrics.height());
        labels.push_back({overlay.label, places.beside(anchor, size, area)});
    }
    return labels;
}

}

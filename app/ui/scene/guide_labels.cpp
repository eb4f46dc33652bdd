#include "app/ui/scene/guide_labels.h"

#include "app/ui/scene/free_area.h"
#include "app/ui/scene/label_places.h"
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
constexpr double shortestPull = 3.0;   ///< px; what is shorter is not seen, so it has no name
constexpr double largestRing = 4000.0; ///< what is larger looks like a line in any view
constexpr int piecesOfRing = 48;

/// Radius on the screen of the body that stands at `place`; 0 if there is none.
double bodyAt(const Shown &shown, const Camera &camera, sim::Vec2 place)
{
    for (int i = 0; i < shown.points(); ++i) {
        if (!shown.isHidden(i) && shown.state().positionOf(i) == place)
            return camera.radius(shown.radius(i));
    }
    return 0.0;
}

QPointF pullVector(const Overlay &guide, const Shown &shown)
{
    return unitArrow / shown.scales.pull.unit * QPointF(guide.b.x, guide.b.y);
}

bool isTooShort(const Overlay &guide, const Shown &shown)
{
    const QPointF vector = pullVector(guide, shown);
    return guide.shape == Overlay::Shape::arrow && std::hypot(vector.x(), vector.y()) < shortestPull;
}

QPointF pullStart(const Overlay &guide, const Shown &shown, const Camera &camera)
{
    const QPointF vector = pullVector(guide, shown);
    const double length = std::hypot(vector.x(), vector.y());
    const double away = length > 0.0 ? (bodyAt(shown, camera, guide.a) + pullGap) / length : 0.0;
    return camera.at(guide.a) + away * vector;
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

void addStrokes(std::vector<QLineF> &strokes, const Overlay &guide, const Shown &shown, const Camera &camera)
{
    const QPointF a = camera.at(guide.a);
    switch (guide.shape) {
    case Overlay::Shape::cross:
        strokes.insert(strokes.end(), {QLineF(a - QPointF(crossArm, 0), a + QPointF(crossArm, 0)),
                                       QLineF(a - QPointF(0, crossArm), a + QPointF(0, crossArm))});
        break;
    case Overlay::Shape::ring:
        addArc(strokes, a, ringRadius(guide, camera), 2.0 * std::numbers::pi);
        break;
    case Overlay::Shape::arrow: {
        const QPointF from = pullStart(guide, shown, camera);
        strokes.emplace_back(from, from + pullVector(guide, shown));
        break;
    }
    case Overlay::Shape::line:
        strokes.emplace_back(a, camera.at(guide.b));
        break;
    case Overlay::Shape::angle:
        strokes.emplace_back(a, a + QPointF(arcRadius(guide, shown, camera) + beyondArc, 0.0));
        addArc(strokes, a, arcRadius(guide, shown, camera), guide.size);
        break;
    case Overlay::Shape::wind:
        break;
    }
}

/// The place that a guide's name belongs to.
QPointF anchorOf(const Overlay &guide, const Shown &shown, const Camera &camera)
{
    const QPointF a = camera.at(guide.a);
    switch (guide.shape) {
    case Overlay::Shape::cross:
        return a;
    case Overlay::Shape::ring:
        return a + ringRadius(guide, camera) * std::numbers::sqrt2 / 2 * QPointF(1.0, -1.0);
    case Overlay::Shape::arrow:
        return pullStart(guide, shown, camera) + pullVector(guide, shown);
    case Overlay::Shape::line:
        return (a + camera.at(guide.b)) / 2;
    case Overlay::Shape::angle:
        return a + (arcRadius(guide, shown, camera) + 6.0) *
                       QPointF(std::cos(guide.size / 2), std::sin(guide.size / 2));
    case Overlay::Shape::wind:
        break;
    }
    return a;
}

}

double ringRadius(const Overlay &guide, const Camera &camera)
{
    return std::min(guide.size * camera.zoom, largestRing);
}

double arcRadius(const Overlay &guide, const Shown &shown, const Camera &camera)
{
    return std::max(smallestArc, bodyAt(shown, camera, guide.a) + outsideBody);
}

Arrow guideArrow(const Overlay &guide, const Shown &shown, const Camera &camera, const Theme &theme)
{
    return {pullStart(guide, shown, camera), pullVector(guide, shown), {theme.tokens().ink2, 2.0}};
}

std::vector<QLineF> explainingStrokes(const Shown &shown, const Camera &camera, const Theme &theme)
{
    std::vector<QLineF> strokes;
    for (const std::vector<Arrow> &arrows :
         {pullArrows(shown, camera, theme), velocityArrows(shown, camera, theme)}) {
        for (const Arrow &arrow : arrows)
            strokes.emplace_back(arrow.from, arrow.from + arrow.vector);
    }
    if (!shown.extras.guides)
        return strokes;
    for (const Overlay &guide : shown.picture.guides)
        addStrokes(strokes, guide, shown, camera);
    return strokes;
}

QRectF titleBox(const Shown &shown, const Camera &camera)
{
    if (shown.name.isEmpty() || shown.points() == 0)
        return {};
    const QRectF stage = shown.look().stage;
    const QFontMetricsF metrics(shown.figures);
    const double width = metrics.horizontalAdvance(shown.name);
    const QPointF top = camera.at({stage.center().x(), stage.top()});
    return {top - QPointF(width / 2.0, 0.0), QSizeF(width, metrics.height())};
}

std::vector<GuideLabel> guideLabels(const Shown &shown, const Camera &camera, const Theme &theme, QRectF area)
{
    std::vector<GuideLabel> labels;
    if (!shown.extras.guides)
        return labels;
    const QFontMetricsF metrics(shown.text);
    std::vector<QRectF> taken = bodyBoxes(shown, camera);
    taken.push_back(nameBox(shown, camera, area));
    LabelPlaces places(std::move(taken), explainingStrokes(shown, camera, theme));
    for (const Overlay &guide : shown.picture.guides) {
        const QPointF anchor = anchorOf(guide, shown, camera);
        if (guide.label.isEmpty() || !area.contains(anchor) || isTooShort(guide, shown))
            continue;
        const QSizeF size(metrics.horizontalAdvance(guide.label), metrics.height());
        labels.push_back({guide.label, places.beside(anchor, size, area)});
    }
    return labels;
}

}

// A layer of shadows: on the floor below discs or, without a floor, just below each disc.

#include "app/ui/scene/layers/layers.h"
#include "app/ui/scene/layers/material.h"
#include "lessons/api/view/view.h"

#include <cmath>

namespace app {

namespace {

constexpr double leastDisc = 4.0;  ///< screen px; shadows of smaller discs would be invisible
constexpr double highest = 160.0;  ///< scene px; discs higher than this cast no shadow on the floor
constexpr double flatness = 0.17;  ///< height of a shadow on the floor, as a fraction of its width
constexpr double underDisc = 1.32; ///< radius of a shadow without a floor, as a multiple of the disc's radius
constexpr double belowLine = 1.0;  ///< screen px; keeps the floor's line free of shadow
constexpr int mostShadows = 300;

/// Returns the distance from a position down to the floor, px; empty if there is no floor.
std::optional<double> floorBelow(const lessons::View &view, sim::Vec2 place)
{
    if (view.room && place.x > view.room->left && place.x < view.room->right)
        return view.room->floor;
    return view.room ? std::nullopt : view.ground;
}

void drawOnFloor(const Canvas &canvas, sim::Vec2 place, double radius, double floor)
{
    const double height = std::max(0.0, floor - place.y - radius);
    if (height >= highest || place.y - radius > floor)
        return;
    const double share = height / highest;
    const QSizeF half = canvas.camera.zoom * radius * (1.1 + share) * QSizeF(1.0, flatness);
    const QPointF at(canvas.camera.at(place).x(), std::round(canvas.camera.at({0.0, floor}).y()));
    if (!canvas.reaches(at, half.width()))
        return;
    drawShade(canvas.painter, at + QPointF(0.0, half.height() + belowLine), half,
              fullShade(canvas.theme) * (1.0 - share) * (1.0 - share));
}

void drawUnder(const Canvas &canvas, sim::Vec2 place, double radius)
{
    const double drawn = canvas.camera.radius(radius);
    const QPointF at = canvas.camera.at(place) + QPointF(0.0, 0.16 * drawn + 1.0);
    if (canvas.reaches(at, underDisc * drawn))
        drawShade(canvas.painter, at, underDisc * drawn * QSizeF(1.0, 1.0), 1.15 * fullShade(canvas.theme));
}

}

void drawShadows(const Canvas &canvas)
{
    const SceneContent &shown = canvas.shown;
    const lessons::View &view = shown.view();
    if (isFlat(canvas.theme) || shown.points() > mostShadows || view.sky != lessons::View::Sky::paper)
        return;
    using Shape = lessons::BodyView::Shape;
    for (int i = 0; i < shown.points(); ++i) {
        const double radius = shown.radius(i);
        const bool isDisc = shown.shape(i) == Shape::body || shown.shape(i) == Shape::foot;
        if (!isDisc || radius * canvas.camera.zoom < leastDisc)
            continue;
        const sim::Vec2 place = shown.state().positionOf(i);
        if (!view.room && !view.ground)
            drawUnder(canvas, place, radius);
        else if (const std::optional<double> floor = floorBelow(view, place))
            drawOnFloor(canvas, place, radius, *floor);
    }
}

}

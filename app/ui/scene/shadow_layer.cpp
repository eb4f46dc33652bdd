// Shadows of discs: on the floor below them, or, where there is none, just under them.

#include "app/ui/scene/layers.h"
#include "app/ui/scene/material.h"
#include "lessons/api/view/view.h"

#include <cmath>

namespace app {

namespace {

constexpr double leastDisc = 4.0;  ///< px of the screen: the shadows of smaller discs are not seen
constexpr double highest = 160.0;  ///< px of the scene: from this high, nothing throws a shadow on the floor
constexpr double flatness = 0.17;  ///< how deep a shadow on the floor is, of its width
constexpr double underDisc = 1.32; ///< the radius of a shadow without a floor, of the disc's
constexpr double belowLine = 1.0;  ///< px of the screen: the floor's line stays as it is
constexpr int mostShadows = 300;

/// How far down the floor lies below a place, px; empty where there is none.
std::optional<double> floorBelow(const lessons::View &look, sim::Vec2 place)
{
    if (look.room && place.x > look.room->left && place.x < look.room->right)
        return look.room->floor;
    return look.room ? std::nullopt : look.ground;
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

void ShadowLayer::draw(const Canvas &canvas) const
{
    const Shown &shown = canvas.shown;
    const lessons::View &look = shown.look();
    if (isFlat(canvas.theme) || shown.points() > mostShadows || look.sky != lessons::View::Sky::paper)
        return;
    using Shape = lessons::BodyView::Shape;
    for (int i = 0; i < shown.points(); ++i) {
        const double radius = shown.radius(i);
        const bool isDisc = shown.shape(i) == Shape::body || shown.shape(i) == Shape::foot;
        if (!isDisc || radius * canvas.camera.zoom < leastDisc)
            continue;
        const sim::Vec2 place = shown.state().positionOf(i);
        if (!look.room && !look.ground)
            drawUnder(canvas, place, radius);
        else if (const std::optional<double> floor = floorBelow(look, place))
            drawOnFloor(canvas, place, radius, *floor);
    }
}

}

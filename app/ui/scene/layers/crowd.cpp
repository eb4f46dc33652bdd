#include "app/ui/scene/layers/crowd.h"

#include "lessons/api/view/view.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr double shortestLeg = 1.5;   ///< screen px
constexpr double smallestFoot = 0.15; ///< radius, screen px
constexpr double smallestBody = 0.7;

}

double legWidthInCrowd(double zoom)
{
    return std::clamp(3.0 * std::sqrt(zoom / 2.6), 0.4, 6.0);
}

void begin(Stencil &stencil, const Canvas &canvas)
{
    stencil.begin(canvas.area, canvas.painter.device()->devicePixelRatioF());
}

void addLegs(Stencil &stencil, const Canvas &canvas, const Figure &figure, double width)
{
    for (const lessons::LegView &leg : figure.view.legs) {
        if (leg.curve != 0.0)
            continue;
        const QPointF from = canvas.camera.at(figure.state.positionOf(leg.from));
        const QPointF to = canvas.camera.at(figure.state.positionOf(leg.to));
        if (std::abs(to.x() - from.x()) + std::abs(to.y() - from.y()) >= shortestLeg)
            stencil.addLine({from, to}, width);
    }
}

void addDiscs(Stencil &stencil, const Canvas &canvas, const Figure &figure, double largest)
{
    using Shape = lessons::BodyView::Shape;
    for (std::size_t i = 0; i < figure.view.bodies.size(); ++i) {
        const lessons::BodyView &body = figure.view.bodies[i];
        const bool isBody = body.shape == Shape::body;
        if (!isBody && body.shape != Shape::foot)
            continue;
        const double drawn = body.radius * canvas.camera.zoom;
        if (drawn >= largest || (!isBody && drawn < smallestFoot))
            continue;
        stencil.addDisc(canvas.camera.at(figure.state.positionOf(static_cast<int>(i))),
                        isBody ? std::max(smallestBody, drawn) : drawn);
    }
}

}

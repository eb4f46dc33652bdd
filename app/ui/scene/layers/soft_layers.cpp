// Layers of tentacles and skins.

#include "app/ui/scene/drawing/eyes.h"
#include "app/ui/scene/drawing/figure.h"
#include "app/ui/scene/layers/layers.h"
#include "lessons/api/view/view.h"

#include <cmath>

namespace app {

namespace {

constexpr double eyesForward =
    0.45; ///< position of the eyes, as a fraction of the way from the centre of a skin to its front
constexpr double faceShare = 0.5; ///< the face's radius, as a fraction of that way

QPointF middleOf(const Canvas &canvas, const lessons::SkinView &skin)
{
    QPointF sum;
    for (const int point : skin.outline)
        sum += canvas.camera.at(canvas.shown.state().positionOf(point));
    return sum / static_cast<double>(skin.outline.size());
}

void drawFace(const Canvas &canvas, const lessons::SkinView &skin)
{
    const QPointF middle = middleOf(canvas, skin);
    const QPointF ahead = canvas.camera.at(canvas.shown.state().positionOf(skin.front)) - middle;
    const double way = std::hypot(ahead.x(), ahead.y());
    if (way <= 0.0)
        return;
    Face face;
    face.centre = middle + eyesForward * ahead;
    face.radius = faceShare * way;
    face.across = QPointF(-ahead.y(), ahead.x()) / way;
    if (face.across.x() < 0.0)
        face.across = -face.across;
    face.velocity = canvas.shown.state().velocityOf(skin.front);
    drawEyes(canvas, face);
}

}

void drawChains(const Canvas &canvas)
{
    for (const lessons::ChainView &chain : canvas.shown.view().chains)
        canvas.painter.fillPath(chainPath(canvas, canvas.shown.state(), chain), canvas.tokens().body);
}

void drawSkins(const Canvas &canvas)
{
    for (const lessons::SkinView &skin : canvas.shown.view().skins) {
        const QPainterPath path = skinPath(canvas, canvas.shown.state(), skin);
        canvas.painter.fillPath(path, canvas.tokens().body);
        canvas.painter.setPen(Qt::NoPen);
        if (skin.front >= 0 && canvas.shown.extras.eyes && !path.isEmpty())
            drawFace(canvas, skin);
    }
}

}

#include "app/ui/scene/eyes.h"

#include <algorithm>

namespace app {

namespace {

constexpr double drawnRadius = 15.0; ///< the radius that the places of the eyes are meant for
constexpr double lookFar = 6.0;      ///< px/frame at which the eyes look all the way
constexpr double apart = 5.2;        ///< from the middle to an eye, at drawnRadius

}

void drawEyes(const Canvas &canvas, const Face &face)
{
    if (face.radius < smallestFace)
        return;
    const double z = face.radius / drawnRadius;
    const double speed = sim::length(face.velocity);
    const double share = speed > 0.0 ? std::min(1.0, speed / lookFar) / speed : 0.0;
    const QPointF look(face.velocity.x * share, face.velocity.y * share);
    QPainter &p = canvas.painter;
    for (const double side : {-1.0, 1.0}) {
        const QPointF eye =
            face.centre + face.radius * face.up + z * (side * apart * face.across + 2.0 * look);
        p.setBrush(canvas.tokens().bodyInk);
        p.drawEllipse(eye, 3.6 * z, 3.6 * z);
        p.setBrush(canvas.tokens().body);
        p.drawEllipse(eye + 1.5 * z * look, 1.7 * z, 1.7 * z);
    }
}

}

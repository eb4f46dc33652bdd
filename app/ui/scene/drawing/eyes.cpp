#include "app/ui/scene/drawing/eyes.h"

#include <algorithm>

namespace app {

namespace {

constexpr double drawnRadius = 15.0; ///< the radius for which the other sizes are given
constexpr double lookFar = 6.0;      ///< px/frame at which the eyes look fully sideways
constexpr double leastGlint = 1.5;   ///< of drawnRadius; smaller eyes have no glint
constexpr double apart = 5.2;        ///< from the centre to an eye, at drawnRadius

}

void drawEyes(const Canvas &canvas, const Face &face)
{
    if (face.radius < smallestFace)
        return;
    const double z = face.radius / drawnRadius;
    const double speed = sim::length(face.velocity);
    const double share = speed > 0.0 ? std::min(1.0, speed / lookFar) / speed : 0.0;
    const QPointF gaze(face.velocity.x * share, face.velocity.y * share);
    QPainter &p = canvas.painter;
    for (const double side : {-1.0, 1.0}) {
        const QPointF eye =
            face.centre + face.radius * face.up + z * (side * apart * face.across + 2.0 * gaze);
        p.setBrush(canvas.tokens().bodyInk);
        p.drawEllipse(eye, 3.6 * z, 3.6 * z);
        p.setBrush(canvas.tokens().body);
        const QPointF pupil = eye + 1.5 * z * gaze;
        p.drawEllipse(pupil, 1.9 * z, 1.9 * z);
        if (z < leastGlint || canvas.theme.scheme() == Scheme::highContrast)
            continue;
        p.setBrush(canvas.tokens().bodyInk);
        p.drawEllipse(pupil + z * QPointF(-0.6, -0.7), 0.55 * z, 0.55 * z);
    }
}

}

// A layer with the right triangle of the arrow whose angle the unit circle shows.

#include "app/model/picture/arrow_angle.h"
#include "app/ui/scene/drawing/triangle_style.h"
#include "app/ui/scene/layers/layers.h"

namespace app {

void drawTriangle(const Canvas &canvas)
{
    if (!canvas.shown.extras.unitCircle)
        return;
    const std::optional<ArrowAngle> arrow = arrowAngleOf(canvas.shown.picture);
    if (!arrow || arrow->length() == 0.0)
        return;
    const QPointF from = canvas.camera.at(arrow->from), to = canvas.camera.at(arrow->to);
    const QPointF corner = canvas.camera.at({arrow->to.x, arrow->from.y});
    canvas.painter.setPen(solid(canvas.tokens().ink2, triangleLongSide));
    canvas.painter.drawLine(canvas.cut(from, to));
    canvas.painter.setPen(besidePen(canvas.tokens().ink));
    canvas.painter.drawLine(canvas.cut(from, corner));
    canvas.painter.setPen(oppositePen(canvas.tokens().ink));
    canvas.painter.drawLine(canvas.cut(corner, to));
}

}

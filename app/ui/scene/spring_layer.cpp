// Springs between two points.

#include "app/ui/scene/layers.h"

#include <algorithm>
#include <cmath>

namespace app {

namespace {

constexpr int most = 14;           ///< turns of a coil
constexpr double turnLength = 9.0; ///< px of the scene, of a spring at rest
constexpr double halfWidth = 4.0;  ///< px of the scene
constexpr double smallest = 5.0;   ///< px of the screen: a turn that is shorter is not drawn as one

double discAt(const Canvas &canvas, int point)
{
    return canvas.shown.isHidden(point) ? 0.0 : canvas.camera.radius(canvas.shown.radius(point));
}

/// A coil with straight ends. It keeps its turns, so that they stand closer when it is pressed.
void addCoil(QPainterPath &path, const QLineF &line, int turns, double wide)
{
    const QPointF u = (line.p2() - line.p1()) / line.length();
    const QPointF across = wide * QPointF(-u.y(), u.x());
    const double part = line.length() / (2.0 * turns + 2.0);
    path.moveTo(line.p1());
    path.lineTo(line.p1() + 0.5 * part * u);
    for (int i = 0; i <= 2 * turns; ++i)
        path.lineTo(line.p1() + (0.5 + 0.5 + i) * part * u + (i % 2 == 0 ? across : -across));
    path.lineTo(line.p2() - 0.5 * part * u);
    path.lineTo(line.p2());
}

void addSpring(QPainterPath &path, const Canvas &canvas, const lessons::SpringLook &spring)
{
    const sim::State &state = canvas.shown.state();
    QLineF line(canvas.camera.at(state.at(spring.a)), canvas.camera.at(state.at(spring.b)));
    if (canvas.cut(line.p1(), line.p2()).isNull())
        return;
    const double rims = discAt(canvas, spring.a) + discAt(canvas, spring.b);
    const double length = line.length();
    if (length > rims + smallest) { // from edge to edge
        const QPointF u = (line.p2() - line.p1()) / length;
        line = {line.p1() + discAt(canvas, spring.a) * u, line.p2() - discAt(canvas, spring.b) * u};
    }
    const int turns = std::clamp(static_cast<int>(spring.length / turnLength), 1, most);
    if (length <= rims + smallest || line.length() < smallest * turns * 0.5) {
        path.moveTo(line.p1());
        path.lineTo(line.p2());
        return;
    }
    addCoil(path, line, turns, std::clamp(halfWidth * canvas.camera.zoom, 2.0, 9.0));
}

}

void SpringLayer::draw(const Canvas &canvas) const
{
    if (canvas.shown.look().springs.empty())
        return;
    QPainterPath path;
    for (const lessons::SpringLook &spring : canvas.shown.look().springs)
        addSpring(path, canvas, spring);
    canvas.painter.setBrush(Qt::NoBrush);
    QPen pen = solid(canvas.tokens().spring, std::clamp(1.2 * canvas.camera.zoom, 1.0, 2.2));
    pen.setJoinStyle(Qt::RoundJoin);
    canvas.painter.setPen(pen);
    canvas.painter.drawPath(path);
}

}

#include "app/ui/scene/layers/material.h"

namespace app {

namespace {

constexpr double smallestShaded = 5.0; ///< screen px; smaller discs are drawn flat

}

QBrush roundBrush(const Canvas &canvas, QPointF centre, double radius, const QColor &color)
{
    if (isFlat(canvas.theme) || radius < smallestShaded)
        return color;
    QRadialGradient light(centre + radius * QPointF(-0.22, -0.34), 1.38 * radius);
    light.setColorAt(0.0, mixed(color, Qt::white, 0.2));
    light.setColorAt(0.22, color);
    light.setColorAt(0.55, color);
    light.setColorAt(1.0, mixed(color, Qt::black, 0.28));
    return light;
}

void drawShade(QPainter &painter, QPointF centre, QSizeF half, double strength)
{
    // A unit disc, scaled: SVG files keep the painter's transform, but not a brush's.
    painter.save();
    painter.translate(centre);
    painter.scale(half.width(), half.height());
    QRadialGradient shade(QPointF(), 1.0);
    const auto dark = [](double alpha) { return faded(Qt::black, alpha); };
    shade.setColorAt(0.0, dark(strength));
    shade.setColorAt(0.55, dark(0.55 * strength));
    shade.setColorAt(1.0, dark(0.0));
    painter.setPen(Qt::NoPen);
    painter.setBrush(shade);
    painter.drawEllipse(QPointF(), 1.0, 1.0);
    painter.restore();
}

double fullShade(const Theme &theme)
{
    return theme.isDark() ? 0.6 : 0.26;
}

}

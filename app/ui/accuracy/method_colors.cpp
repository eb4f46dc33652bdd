#include "app/ui/accuracy/method_colors.h"

#include "sim/methods/methods.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace app {

namespace {

/// Returns the family of a method from its properties, so that a new method needs no entry here.
std::size_t familyOf(const sim::Method &method)
{
    enum Family : std::size_t { euler, verlet, rungeKutta, adaptive, implicit };
    const std::vector<std::string> needs = method.requirements();
    if (std::find(needs.begin(), needs.end(), "jacobian") != needs.end())
        return implicit;
    if (method.stepping() == sim::Stepping::adaptive)
        return adaptive;
    if (method.order() <= 1)
        return euler;
    return method.symplectic() == sim::Symplectic::yes ? verlet : rungeKutta;
}

QPainterPath polygon(const QPolygonF &corners)
{
    QPainterPath path;
    path.addPolygon(corners);
    path.closeSubpath();
    return path;
}

/// Returns a polygon with `corners` on a circle, the first at the top, or a star if `inner`, its inner radius in px, is
/// not 0.
QPainterPath regular(int corners, double radius, double turn = 0.0, double inner = 0.0)
{
    QPolygonF places;
    const int count = inner > 0.0 ? 2 * corners : corners;
    for (int i = 0; i < count; ++i) {
        const double angle = 2.0 * std::numbers::pi * (i + turn) / count - std::numbers::pi / 2.0;
        const double r = inner > 0.0 && i % 2 == 1 ? inner : radius;
        places << QPointF(r * std::cos(angle), r * std::sin(angle));
    }
    return polygon(places);
}

QPainterPath plus(double r)
{
    const double t = 0.36 * r;
    return polygon({{-t, -r},
                    {t, -r},
                    {t, -t},
                    {r, -t},
                    {r, t},
                    {t, t},
                    {t, r},
                    {-t, r},
                    {-t, t},
                    {-r, t},
                    {-r, -t},
                    {-t, -t}});
}

}

MethodColors inkOf(const sim::Method &method, const Theme &theme)
{
    const std::size_t family = familyOf(method);
    MethodColors ink;
    std::size_t before = 0; // methods of the family that come first
    for (const sim::MethodPtr &other : sim::allMethods()) {
        if (other->id() == method.id())
            break;
        before += familyOf(*other) == family ? 1 : 0;
        ++ink.shape;
    }
    const auto &shades = theme.tokens().methods[family];
    ink.color = shades[before % shades.size()];
    return ink;
}

QPainterPath markerPath(int shape, double size)
{
    const double r = size / 2.0;
    QPainterPath circle;
    switch (shape % markerShapes) {
    case 0:
        return regular(4, 1.2 * r, 0.5);
    case 1:
        circle.addEllipse(QPointF(), r, r);
        return circle;
    case 2:
        return regular(3, 1.25 * r);
    case 3:
        return regular(4, 1.25 * r);
    case 4:
        return regular(3, 1.25 * r, 1.5);
    case 5:
        return regular(5, 1.4 * r, 0.0, 0.6 * r);
    case 6:
        return plus(1.1 * r);
    case 7:
        return regular(6, 1.1 * r);
    case 8:
        return regular(5, 1.15 * r);
    case 9:
        return regular(3, 1.25 * r, 0.75);
    case 10:
        return regular(3, 1.25 * r, 2.25);
    default:
        return regular(4, 1.4 * r, 0.0, 0.5 * r);
    }
}

}
